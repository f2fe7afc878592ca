-- The cantilevers of Fig. 7, Tang, Tian & Hu 2022, twisted as far as they go: torque and shortening
-- over the twist of the free end beside the linear solution (Figs. 8, 10), and what that looks like
-- (Fig. 11).  cases/torsion.lua has the beams, and numbers beside solids.
--
-- Each path ends just before it cannot be followed further.  With `average` that is a limit point
-- of the torque, or close to one: Wagner's stress presses the core together, and a law that is
-- linear between Green's strain and the second Piola-Kirchhoff stress gets softer in compression.
-- The I passes the paper's 16 rad; the square comes to 1700 of its 2160 deg, the box to 790 of its
-- 1260.  Where Poisson's coupling acts on the axis alone, as in the paper, or at each point, the
-- limit is higher: in the paper's settings the square passes 2160 deg, and so it does with `full`.
-- The box in the paper's settings comes to 660 deg with 20 elements and to 940 with 8, and no way
-- was found to its 1260.  No linear law means much there: det F, the change of volume, falls to
-- 0.6.  The box is long past its limit torque, too, 0.200 kNm in solids.
--
-- Long before, a bar under an end torque leaves its straight axis.  A moment that acts half on each
-- of the slopes y and z is semi-tangential: Ziegler's critical torque is pi E I/L (I = sqrt(Iy Iz)
-- here; H. Ziegler, Principles of Structural Stability, 1968).  Linear buckling at the reference
-- has it for closed sections, but for their shear; about the twisted state the thin-walled bars
-- give way much earlier.  From there on all curves are, here as in the paper, those of equilibria
-- that a bar free to move would leave.
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
    hobe.beam{ name = "bar", element = how.element, elements = how.elements or n,
               section = section, material = { E = E, nu = nu, rho = 7850 },
               from = {0, 0, 0}, to = {L, 0, 0}, mechanics = how.mechanics,
               integration = how.integration },
    hobe.clamp{ "bar", at = 0 },
    hobe.moment{ "bar", at = 1, value = {1e3*M, 0, 0} },
  }
end

local plain = {}
local function paper(M, elements)
  local few = elements and string.format(", %d elements", elements) or ""
  return { "MGD30w, paper's settings" .. few, M, mechanics = "axis", integration = "paper",
           w = "paper", elements = elements }
end

-- Their section, E, Pa, and the paths with the torques, kNm, that end them.
local beams = {
  { "I", I, 210e9, { "MGD30w", 4300 }, { "MGD30w, full", 9600, mechanics = "full" }, paper(11700) },
  { "square", square, 1e9, { "MGD30w", 59.9 },
    { "MGD30w3, full", 93, element = "MGD30w3", mechanics = "full" }, paper(150) },
  { "hollow", hollow, 1e9, { "MGD30w", 24.7 }, { "MGD30w, full", 39, mechanics = "full" },
    paper(62) },
  { "box", box, 1e9, { "MGD30w", 16 }, { "MGD30w, full", 20.5, mechanics = "full" }, paper(27),
    paper(56, 8) },
}
local report, rows, drawings = {}, {}, {}

-- ---- curves ------------------------------------------------------------------------------------

-- Torque, kNm, twist, deg, and shortening, mm, along a path, from the reference on.
local function follow(path, M)
  local torque, twist, short = { 0 }, { 0 }, { 0 }
  for i, point in ipairs(path) do
    torque[i + 1], twist[i + 1] = M*point.load, math.deg(point:twist("bar", 1))
    short[i + 1] = -1e3*point:displacement("bar", 1)[1]
  end
  return torque, twist, short
end

-- The points of a path at about a turn and at its end, to be drawn.
local function draw(name, path, twist)
  local turn = 1
  for i = 1, #path do
    if math.abs(twist[i + 1] - 360) < math.abs(twist[turn + 1] - 360) then turn = i end
  end
  for _, i in ipairs{ turn, #path } do
    drawings[#drawings + 1] = { path[i], string.format("%s: %.0f°", name, twist[i + 1]) }
  end
end

-- Every fourth point of a path for ParaView: 1 MB each of the square, a hundred of an outline.
local function write(name, path, torque)
  local series = {}
  for i = 4, #path, 4 do series[#series + 1] = { path[i], torque[i + 1] } end
  hobe.vtk{ file = name .. ".pvd", states = series }
end

for _, beam in ipairs(beams) do
  local name, make, E = beam[1], beam[2], beam[3]
  local GJ = E/(2*(1 + nu))*make().J
  local torques, shorts, furthest = {}, {}, 0
  for k = 4, #beam do
    local how = beam[k]
    local path = hobe.path(scene(make(how.w), E, how[2], how))
    local torque, twist, short = follow(path, how[2])
    local last = #path + 1
    torques[k - 3] = { label = how[1], x = twist, y = torque }
    shorts[k - 3] = { label = how[1], x = twist, y = short }
    rows[#rows + 1] = { name, how[1], torque[last], twist[last], math.rad(twist[last]), short[last],
                        path[#path].smallest_volume }
    report[name .. (k > 4 and "_" .. k - 3 or "")] = { twist[last], "deg" }
    furthest = math.max(furthest, twist[last])
    if k == 4 then draw(name, path, twist) end
    if k == 4 and name == "square" then write(name, path, torque) end
  end
  torques[#torques + 1] = { label = "linear", colour = 0, x = { 0, furthest },
                            y = { 0, 1e-3*GJ*math.rad(furthest)/L } }
  hobe.plot{ file = name .. "_torque.png", title = name .. ": torque at the end",
             xlabel = "twist, deg", ylabel = "Mx, kNm", series = torques }
  hobe.plot{ file = name .. "_shortening.png", title = name .. ": shortening",
             xlabel = "twist, deg", ylabel = "shortening, mm", series = shorts }
end
hobe.table{
  title = "How far", rows = rows, file = "far.csv",
  columns = { "", "element", "Mx, kNm", "twist, deg", "rad", "shortening, mm", "least det F" },
}
hobe.picture{ file = "fig11.png", title = "Twisted cantilevers (Fig. 11)", states = drawings,
              colour = "twist", columns = 2, reference = false }

-- ---- sideways ----------------------------------------------------------------------------------

-- The torque, kNm, from which on the twisted bar is unstable, by bisection below `high`.
local function critical(section, E, high)
  local low, most = 0, high
  while high - low > 1e-4*high do
    local M = (low + high)/2
    local s = scene(section, E, M, plain)
    local state = hobe.static(s, { steps = math.ceil(8*M/most) })
    if hobe.modal(s, { modes = 1, state = state }).unstable > 0 then high = M else low = M end
  end
  return low
end

rows = {}
for i, beam in ipairs(beams) do
  local name, section, E = beam[1], beam[2](), beam[3]
  local theory = 1e-3*math.pi*E*math.sqrt(section.Iyy*section.Izz)/L
  local linear = hobe.buckling(scene(section, E, 1, plain), { modes = 1 }):factor(1)
  rows[i] = { name, theory, linear, critical(section, E, 1.2*theory) }
  if name ~= "I" then
    report["sideways_" .. name] = { linear, "kNm", expect = theory, within = 5e-3 }   -- shear
  end
end
hobe.table{ title = "Torque at which the bar moves sideways, kNm", rows = rows,
            columns = { "", "pi E I/L", "linear buckling", "of the twisted bar" } }
hobe.report(report)
