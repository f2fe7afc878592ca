-- An elastic pendulum swings from the horizontal through 180 degrees, by few unknowns.
--
-- A bar, L 1 m, 40 x 40 mm, E 1 GPa, 7850 kg/m^3, on a hinge, which would sag by 7 % of its
-- length if it were held level, is let go, and trembles as it falls. The fields of the path's
-- series of the bar that is held level and upright under its weight, closed under rotations in
-- the plane of the swing (hobe.reduce), turn exactly, so that what is reduced is the
-- deformation alone, and need no frame that moves along.
-- Component modes of the present tangent (Tang, Tian & Hu 2022 after Craig & Bampton) do not turn:
-- to them the turn of a section is a stretch, and the bar stands still, on modes that are found
-- again whenever it has moved by 0.03 rad.  All of them are the full model, but for accelerations
-- that settle each time.
--
-- Error: the farthest that the end is from that of the full model (8 elements MGD30, 162 unknowns,
-- with the same steps), relative to the length.  Expected of 19 fields: less than a mesh of 36
-- unknowns leaves, 3e-3; of all modes what settling does, of the order of the steps; the others are
-- our own numbers.
-- Long: eigenproblems in each of many steps.
local hobe = require "hobe"

local g, L, n = 9.81, 1, 8
local to, step = 0.97, hobe.param("step", 2e-3)       -- s: half a period

local function bar(elements, kind, weight)
  return hobe.scene{
    hobe.beam{ name = "bar", element = "MGD30", elements = elements,
               section = hobe.square{ side = 0.04 }, from = {0, 0, 0}, to = {L, 0, 0},
               material = { E = 1e9, nu = 0.3, rho = 7850 } },
    hobe.support{ "bar", at = 0, kind = kind, axis = kind == "revolute" and {0, 1, 0} or nil },
    hobe.gravity(weight) }
end

local function swing(scene, projection)
  local d = hobe.dynamic(scene, { to = to, step = step, store = 0.01, projection = projection })
  local tip = {}
  for i = 1, d.count do tip[i] = d:state(i):position("bar", 1) end
  return { d = d, tip = tip }
end

local whole = bar(n, "revolute", {0, 0, -g})
local full = swing(whole)
local rows, lines, report = {}, {}, {}

local function note(how, unknowns, run)
  local error = 0
  for i, a in ipairs(run.tip) do
    local b = full.tip[i]
    error = math.max(error, math.sqrt((a[1] - b[1])^2 + (a[2] - b[2])^2 + (a[3] - b[3])^2)/L)
  end
  local e = run.d:energies(run.d.count)
  rows[#rows + 1] = { how, unknowns, error, e.balance/full.largest, run.d.linearisations }
  return error
end
local function draw(label, run)
  local x, z = {}, {}
  for i, p in ipairs(run.tip) do x[i], z[i] = p[1], p[3] end
  lines[#lines + 1] = { x = x, y = z, label = label }
end

full.largest = 0
for i = 1, full.d.count do full.largest = math.max(full.largest, full.d:energies(i).kinetic) end
note("full", full.d:state(1).unknowns, full)
draw("full", full)
for _, elements in ipairs{ 1, 2 } do
  local run = swing(bar(elements, "revolute", {0, 0, -g}))
  note(elements .. " elements", run.d:state(1).unknowns, run)
end

local held = bar(n, "fixed", {0, 0, -g})
for _, modes in ipairs{ 3, 4, 6 } do
  local reduced = hobe.reduce(held, { modes = modes, closed = 2, normal = {0, 1, 0},
                                      loads = { bar(n, "fixed", {g, 0, 0}) } })
  local run = swing(reduced:on(whole))
  local error = note("series, closed", reduced.unknowns, run)
  if modes == 6 then
    draw("series, closed", run)
    report.series = { error, expect = 0, within = 2e-3 }
  end
end

for _, modes in ipairs{ 60, 120, 156 } do
  local run = swing(whole, { modes = modes, deviation = 0.03 })
  local error = note("component modes", run.d.projected, run)
  if modes == 120 then
    draw("component modes", run)
    report.component_modes_120 = { error }
  elseif modes == 156 then
    report.all_modes = { error, expect = 0, within = 1e-3 }
  end
end
hobe.table{
  file = "pendulum_reduced.csv", title = "A pendulum through 180 degrees", columns = {
    "how", "unknowns", "error", "energy lost", "linearised" }, rows = rows,
}
hobe.plot{
  file = "pendulum_reduced.png", title = "Where the end of a pendulum goes", xlabel = "x, m",
  ylabel = "z, m", series = lines,
}
hobe.report(report)
