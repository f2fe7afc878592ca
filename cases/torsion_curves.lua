-- The cantilevers of Fig. 7, Tang, Tian & Hu 2022, twisted as far as they go: torque over twist and
-- shortening of the free end (Figs. 8, 10), beside the linear solution, and what they look like
-- (Fig. 11).  cases/torsion.lua has the beams and the numbers beside solids.
--
-- Each path ends just before it cannot be followed further.  With `average` that is a limit point
-- of the torque: Wagner's stress presses the core of a bar that gets shorter and shorter, and the
-- material law, linear between Green's strain and second Piola-Kirchhoff stress, softens in
-- compression.  The square gets to 1700 of the paper's 2160 deg, the I past its 16 rad, the box to
-- 790 of 1260 deg.  Poisson's coupling on the axis alone (`axis`), which the paper has, or at each
-- point (`full`) moves that limit out: the square passes 2160 deg, ... .  There strains are of
-- order 1, and no linear law means much.
--
-- Long before, a bar under an end torque moves sideways: at pi E I/L, where the moment is that of
-- two pairs of forces that keep their direction, half of each about the section's slopes
-- (semi-tangential, Ziegler 1956), as hobe.moment is.  Up to there the twisted straight bars are
-- stable, from there on they are equilibria that nobody will see, in the paper as here.  The
-- reference has exactly that load for the square; about the twisted state, found by bisection, it
-- differs as twist and Wagner's stress change the bar.
-- Long: not run under the sanitizers, where it takes minutes.
local hobe = require "hobe"

local n, L, nu = hobe.param("n", 20), 2, 0.3

local function I(w)
  return hobe.I{ height = 0.215, width = 0.1, flange = 0.015, web = 0.01, warping = w }
end
local function square(w) return hobe.square{ side = 0.1, warping = w } end
local function hollow(w)
  return hobe.hollow{ width = 0.16, height = 0.08, thickness = 0.01, warping = w }
end
local function box(w)
  return hobe.box{ width = 0.25, height = 0.05, thickness = 0.005, warping = w }
end

local function scene(section, E, M, how)
  return hobe.scene{
    hobe.beam{ name = "bar", element = how.element, elements = n, section = section,
               material = { E = E, nu = nu, rho = 7850 }, from = {0, 0, 0}, to = {L, 0, 0},
               mechanics = how.mechanics, integration = how.integration },
    hobe.clamp{ "bar", at = 0 },
    hobe.moment{ "bar", at = 1, value = {1e3*M, 0, 0} },
  }
end

local plain = { "MGD30w" }
local function paper(M)
  return { "MGD30w, axis, paper's settings", M, mechanics = "axis", integration = "paper",
           w = "paper" }
end

-- Torques, kNm, at which each path ends.
local beams = {
  { "I", I, 210e9, colour = 1, { "MGD30w", 4300 }, { "MGD30w, full", 9600, mechanics = "full" }, paper(11700) },
  { "square", square, 1e9, { "MGD30w", 59.9 }, { "MGD30w3, full", 93, element = "MGD30w3", mechanics = "full" },
    paper(150) },
  { "hollow", hollow, 1e9, { "MGD30w", 24.7 }, { "MGD30w, full", 39, mechanics = "full" }, paper(62) },
  { "box", box, 1e9, { "MGD30w", 16 }, { "MGD30w, full", 20.5, mechanics = "full" }, paper(27) },
}

-- ---- curves ------------------------------------------------------------------------------------

local reached = {}
for _, beam in ipairs(beams) do
  local name, make, E = beam[1], beam[2], beam[3]
  local twists, shorts, furthest = {}, {}, 0
  for k = 4, #beam do
    local how = beam[k]
    local path = hobe.path(scene(make(how.w), E, how[2], how), { arc = 0.05 })
    local M, twist, short = { 0 }, { 0 }, { 0 }
    for i, point in ipairs(path) do
      M[i + 1], twist[i + 1] = how[2]*point.load, math.deg(point:twist("bar", 1))
      short[i + 1] = -1e3*point:displacement("bar", 1)[1]
    end
    local last = #M
    twists[#twists + 1] = { label = how[1], x = twist, y = M }
    shorts[#shorts + 1] = { label = how[1], x = twist, y = short }
    reached[#reached + 1] = { name, how[1], M[last], twist[last], math.rad(twist[last]), short[last],
                              path[#path].smallest_volume, #path, path.iterations, path.ended }
    furthest = math.max(furthest, twist[last])
  end
  local GJ = E/(2*(1 + nu))*make().J
  local most = twists[1].y[#twists[1].y]
  table.insert(twists, { label = "linear", colour = 0, x = { 0, math.deg(1e3*most*L/GJ) }, y = { 0, most } })
  hobe.plot{ file = name .. "_torque.png", title = name .. ": torque", xlabel = "twist, deg", ylabel = "Mx, kNm", series = twists }
  hobe.plot{ file = name .. "_shortening.png", title = name .. ": shortening", xlabel = "twist, deg", ylabel = "shortening, mm", series = shorts }
end
hobe.table{ title = "How far",
  columns = { "", "element", "Mx, kNm", "twist, deg", "rad", "shortening, mm", "least det F", "points", "iterations", "ended by" },
  rows = reached, file = "reached.csv" }

-- ---- sideways ----------------------------------------------------------------------------------

-- The torque, kNm, at which the twisted bar becomes unstable, between two.
local function critical(section, E, low, high)
  while high - low > 1e-4*high do
    local M = (low + high)/2
    local s = scene(section, E, M, plain)
    local r = hobe.static(s, { steps = math.ceil(8*M/high) })
    local unstable = hobe.modal(s, { modes = 1, state = r }).unstable
    if unstable > 0 then high = M else low = M end
  end
  return low
end
local report, rows = {}, {}
for _, b in ipairs{ { "I", I(), 210e9, 3000 }, { "square", square(), 1e9, 20 }, { "hollow", hollow(), 1e9, 14 }, { "box", box(), 1e9, 4 } } do
  local section, E = b[2], b[3]
  local theory = math.pi*E*math.sqrt(section.Iyy*section.Izz)/L/1e3
  local linear = hobe.buckling(scene(section, E, 1, plain), { modes = 1 }):factor(1)
  local nonlinear = critical(section, E, 0, b[4])
  rows[#rows + 1] = { b[1], theory, linear, nonlinear }
end
hobe.table{ title = "Sideways", columns = { "", "pi E sqrt(Iy Iz)/L", "linear", "twisted" }, rows = rows }
