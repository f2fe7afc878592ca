-- A cantilever that tapers, and what it is worth that elements know it: beam (d) of Fig. 7 of Tang,
-- Tian & Hu 2022, L 2 m, solid, 100 mm wide, 200 mm high at the clamp and 100 mm at the tip,
-- E 1 GPa, nu 0.3, rho 7850 kg/m^3; MGD30w.
--
-- Frequencies: the first of bending in the X-Z plane.  "paper": its Table 8, which an independent
-- prototype in the paper's settings (3 x 3 x 3 Gauss points, one term of eq. 33, Poisson's coupling
-- on the axis) repeats to all digits.
--
-- Deflection of the tip under a small load there: "theory" is Timoshenko's beam, the integral of
-- M^2/(E I) + V^2/(k G A) by quadrature, with k = 5/6, in the beams on the average strain.
-- "stepped": as many prismatic elements, joined, each as high as the beam in its middle.
local hobe = require "hobe"

local L, E, nu = 2, 1e9, 0.3
local P = 1e-4                                         -- N: 1e-7 of the length, to stay linear

local function rectangle(at, warping)                  -- at the fraction of the length
  return hobe.rectangle{ width = 0.1, height = 0.2 - 0.1*at, warping = warping }
end

local function taper(warping)
  return hobe.taper{ from = rectangle(0, warping), to = rectangle(1, warping) }
end

local function beam(keys)
  keys.name = keys.name or "beam"
  keys.element = "MGD30w"
  keys.material = { E = E, nu = nu, rho = 7850, k2 = keys.k, k3 = keys.k, k = "average" }
  keys.from, keys.to, keys.k = keys.from or {0, 0, 0}, keys.to or {L, 0, 0}, nil
  return hobe.beam(keys)
end

-- ---- frequencies -------------------------------------------------------------------------------

local function frequency(keys)
  local m = hobe.modal(hobe.scene{ beam(keys), hobe.clamp{ "beam", at = 0 } }, { modes = 4 })
  for i = 1, m.count do
    local u = m:shape(i, "beam", 1)
    if math.abs(u[3]) > math.abs(u[2]) then return m:frequency(i) end
  end
end

local rows, report = {}, {}
for _, known in ipairs{ {1, 19.723}, {10, 19.591}, {50, 19.590}, {100, 19.589} } do
  local n = known[1]
  local paper = frequency{ elements = n, section = taper("paper"),
                           mechanics = "axis", integration = "paper" }
  rows[#rows + 1] = { n, known[2], paper,
                      n <= 10 and frequency{ elements = n, section = taper() } or nil,
                      n <= 10 and frequency{ elements = n, section = taper(), k = 5/6 } or nil }
  report["paper_" .. n] = { paper, "rad/s", expect = known[2], within = 0.5e-3/known[2] }
end
hobe.table{
  title = "First bending frequency in the X-Z plane, rad/s",
  columns = { "elements", "paper", "its settings", "exact, k = 1", "exact, k = 5/6" },
  rows = rows,
}

-- ---- deflection --------------------------------------------------------------------------------

-- Simpson's rule; 1000 panels leave 1e-13.
local function theory()
  local sum, panels = 0, 1000
  for i = 0, 2*panels do
    local t = i/(2*panels)
    local A, h = 0.1*(0.2 - 0.1*t), 0.2 - 0.1*t
    local weight = (i == 0 or i == 2*panels) and 1 or i % 2 == 1 and 4 or 2
    local arm, G = L*(1 - t), E/(2*(1 + nu))
    sum = sum + weight*L/(6*panels)*(arm^2/(E*A*h^2/12) + 1/(5/6*G*A))
  end
  return P*sum
end

local function tip(items, last)
  items[#items + 1] = hobe.force{ last, at = 1, value = {0, 0, P} }
  return hobe.static(hobe.scene(items)):displacement(last, 1)[3]
end

-- Holds the section, but not r_x, which would forbid the first element to shear there.
local function clamp(name) return hobe.clamp{ name, at = 0, warping = "free" } end

local function tapered(n)
  return tip({ clamp("beam"), beam{ elements = n, section = taper(), k = 5/6 } }, "beam")
end

local function stepped(n)
  local function step(i) return "step " .. i end
  local items = { clamp(step(1)) }
  for i = 1, n do
    items[#items + 1] = beam{ name = step(i), elements = 1, k = 5/6,
                              section = rectangle((i - 0.5)/n),
                              from = { L*(i - 1)/n, 0, 0 }, to = { L*i/n, 0, 0 } }
    if i > 1 then items[#items + 1] = hobe.join{ step(i - 1), step(i), at = {1, 0} } end
  end
  return tip(items, step(n))
end

local exact = theory()
local halvings, log_tapered, log_stepped = {}, {}, {}
rows = {}
for i = 0, 5 do
  local n = 1 << i
  local t, s = tapered(n)/exact - 1, stepped(n)/exact - 1
  rows[i + 1] = { n, t, s }
  halvings[i + 1] = i
  log_tapered[i + 1], log_stepped[i + 1] = math.log(math.abs(t), 10), math.log(math.abs(s), 10)
end
hobe.table{
  title = string.format("Deflection of the tip, %.6g m in theory: relative error", exact),
  columns = { "elements", "tapered", "stepped" },
  rows = rows,
}
hobe.plot{
  file = "taper.png", title = "Tip deflection of a tapered cantilever, MGD30w",
  xlabel = "log2 of the number of elements", ylabel = "log10 of the relative error",
  series = {
    { label = "elements that taper", x = halvings, y = log_tapered, style = "linespoints" },
    { label = "a stair of prismatic elements", x = halvings, y = log_stepped,
      style = "linespoints" },
  },
}
-- Errors of order 4 and 2, here with a little room.
report.tapered_8 = { tapered(8), "m", expect = exact, within = 3e-5 }
report.tapered_32 = { tapered(32), "m", expect = exact, within = 1.2e-7 }
report.stepped_32 = { stepped(32), "m", expect = exact, within = 5e-4 }
hobe.report(report)
