-- Natural frequencies of a square cantilever: beam (b) of Fig. 7 of Tang, Tian & Hu 2022, L 2 m,
-- section 100 x 100 mm, E 1 GPa, nu 0.3, rho 7850 kg/m^3; MGD30w.  Which mass shakes with which
-- mode, and the shapes in bending as a plot; table8.lua has the paper's own numbers.
--
-- "solid": a converged model of quadratic bricks with a clamped face, the last digit uncertain.
local hobe = require "hobe"

local n = hobe.param("elements", 20)
local L, a = 2, 0.1

-- `hobe chart cases/frequencies.lua` compares models.
hobe.chart{
  truth = { bending = 9.060, torsion = 159.78 }, doubt = 2e-4,
  ladder = {
    { element = { "BE24", "3333", "MGD30", "3433", "BE24w", "3333w", "MGD30w", "3433w", "BE42",
                  "3363", "MGD30w3" }, elements = { 1, 2, 4, 8, 16, 32 } },
    { element = { "34X3", "MGD30w-II", "BE24w-II", "B4" }, elements = { 1, 2, 4, 8, 16 } },
    { element = "MGD30w", elements = { 4, 8, 16 }, mechanics = { "axis", "full" } },
  },
}

local function modes(elements)
  local scene = hobe.scene{
    hobe.beam{
      name = "bar", element = hobe.param("element", "MGD30w"), elements = elements,
      section = hobe.rectangle{ width = a, height = a },
      material = { E = 1e9, nu = 0.3, rho = 7850 },
      from = {0, 0, 0}, to = {L, 0, 0},
      mechanics = hobe.param("mechanics", "average"),
    },
    hobe.clamp{ "bar", at = 0 },
  }
  return hobe.modal(scene, { modes = 10 })
end

-- What a mode does most at the tip: "bending", "axial" or "torsion", seen at a corner.
local function kind(m, i)
  local u, c = m:shape(i, "bar", 1), m:shape(i, "bar", 1, a/2, a/2)
  local bending = math.max(math.abs(u[2]), math.abs(u[3]))
  local torsion = math.max(math.abs(c[2] - u[2]), math.abs(c[3] - u[3]))
  if math.abs(u[1]) > math.max(bending, torsion) then return "axial" end
  return bending > torsion and "bending" or "torsion"
end

local function first(m, which)
  for i = 1, m.count do
    if kind(m, i) == which then return i end
  end
end

local rows = {}
local m = modes(n)
local bending, torsion = first(m, "bending"), first(m, "torsion")
rows[#rows + 1] = { "bending", n, m:frequency(bending), 9.060 }
rows[#rows + 1] = { "torsion", n, m:frequency(torsion), 159.78 }
hobe.table{
  title = "First frequencies of the square beam, rad/s",
  columns = { "", "elements", "this run", "solid" },
  rows = rows,
}

local all, shapes = {}, {}
for i = 1, m.count do
  local e = m:effective_mass(i)
  for k = 1, 3 do
    if e[k] < 1e-12*m.mass then e[k] = 0 end           -- rounding
  end
  all[i] = { i, kind(m, i), m:frequency(i), e[1], e[2], e[3] }
end
hobe.table{
  title = string.format("All %d modes found, with the mass that shakes with each, of %.4g kg",
                        m.count, m.mass),
  columns = { "mode", "", "rad/s", "along X, kg", "along Y, kg", "along Z, kg" },
  rows = all,
}
for i = 1, 5, 2 do
  local x, y = {}, {}
  local tip = m:shape(i, "bar", 1)                      -- a pair turns freely about the axis
  local size = math.sqrt(tip[2]^2 + tip[3]^2)
  for k = 0, 50 do
    local u = m:shape(i, "bar", k/50)
    x[k + 1] = L*k/50
    y[k + 1] = (u[2]*tip[2] + u[3]*tip[3])/size
  end
  shapes[#shapes + 1] = { label = string.format("%.4g rad/s", m:frequency(i)), x = x, y = y }
end
hobe.plot{
  file = "shapes.png", title = "Bending modes of the square cantilever, mass-normalised",
  xlabel = "x, m", ylabel = "u along the tip's, 1/sqrt(kg)", series = shapes,
}

hobe.report{
  bending  = { m:frequency(bending), "rad/s", expect = 9.060,  within = 5e-3 },
  torsion  = { m:frequency(torsion), "rad/s", expect = 159.78, within = 5e-3 },
}
