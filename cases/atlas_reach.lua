-- Atlas of failures: how far elements of each order can be turned, and what ends them.
--
-- A square bar of 5 m, side 0.1 m, E = 1 GPa, nu = 0.3, is twisted by a torque at its end; one of
-- 10 m is rolled up by a moment, 8 pi EI/L, beside 80 elements of 3433w.  Slopes that turn are
-- interpolated between nodes and so too short there, which stiffens: linear ones (BE24, BE42, B4)
-- go wrong from 0.2 rad an element on, quadratic ones (3333, MGD30) from 1 rad, cubic ones (3433)
-- from 3 rad.  The paper's 29 rad of a square bar are 1.5 rad an element for 20 of MGD30w.
-- Nothing fails to converge: `r:mesh_error` knows, and hobe.static and hobe.path warn where it is
-- 1 %.
--
-- Expected: the twist of 100 elements of 3433w, 28.7089 rad at 30 kNm (MGD30w with 100: 28.7049).
-- What a mesh misses must be said where it is 1 %, by an estimate that is as near as a quarter.
local hobe = require "hobe"

local E, nu, side = 1e9, 0.3, 0.1
local section = hobe.square{ side = side }
local EI = E*section.Iyy
local elements = { "BE24w", "3333w", "MGD30w", "3433w" }
local meshes = { 4, 8, 12, 20, 40 }

local function scene(element, n, L, moment)
  return hobe.scene{
    hobe.beam{ name = "bar", element = element, elements = n, section = section,
               material = { E = E, nu = nu }, from = {0, 0, 0}, to = {L, 0, 0} },
    hobe.clamp{ "bar", at = 0 }, hobe.moment{ "bar", at = 1, value = moment } }
end

-- The last point of the path to the whole load, and how often the path gains negative eigenvalues.
local function follow(...)
  local path = hobe.path(scene(...), { method = "series" })
  return path[#path], #path.bifurcations
end

-- ---- torsion -----------------------------------------------------------------------------------

local truth, rows, curves, unsaid, warned = 28.7089, {}, {}, 0, 0
for i, element in ipairs(elements) do
  curves[i] = { label = element, style = "linespoints", x = {}, y = {} }
  for _, n in ipairs(meshes) do
    local r, branches = follow(element, n, 5, {30e3, 0, 0})
    local twist, estimate = r:twist("bar", 1), r:mesh_error("bar")
    local missing = 1 - twist/truth
    rows[#rows + 1] = { element, n, twist, twist/n, missing, estimate,
                        estimate >= 0.01 and "warned" or "", branches, r.smallest_volume }
    table.insert(curves[i].x, n)
    table.insert(curves[i].y, twist)
    if estimate < 0.01 then unsaid = math.max(unsaid, missing) else warned = warned + 1 end
  end
end
hobe.table{
  title = string.format("A torque of 30 kNm twists the bar by %g rad", truth),
  columns = { "element", "elements", "twist, rad", "an element", "missing", "estimate", "",
              "bifurcations", "least det F" }, rows = rows, file = "reach.csv",
}
curves[#curves + 1] = { label = "100 elements", colour = 0, x = { 4, 40 }, y = { truth, truth } }
hobe.plot{
  file = "reach.png", title = "A square bar under 30 kNm: the twist that a mesh can hold",
  xlabel = "elements", ylabel = "twist of the end, rad", series = curves,
}

-- ---- bending -----------------------------------------------------------------------------------

-- The turn of the end: the turns of pieces of the axis against each other, eight an element, added
-- up, and half a piece more.
local function turn(r, n)
  local sum, before, last = 0, 0, r:position("bar", 0)
  for i = 1, 8*n do
    local here = r:position("bar", i/(8*n))
    local heading = math.atan(here[3] - last[3], here[1] - last[1])
    sum = sum + (heading - before + math.pi) % (2*math.pi) - math.pi
    before, last = heading, here
  end
  return sum*8*n/(8*n - 1/2)
end

local function roll(element, n)
  local r = follow(element, n, 10, { 0, -8*math.pi*EI/10, 0 })
  return turn(r, n), r:mesh_error("bar")
end

local rolled, unsaid_rolled = roll("3433w", 80), 0
rows = {}
for _, element in ipairs(elements) do
  for _, n in ipairs{ 8, 20, 40 } do
    local angle, estimate = roll(element, n)
    local missing = 1 - angle/rolled
    rows[#rows + 1] = { element, n, angle, angle/n, missing, estimate,
                        estimate >= 0.01 and "warned" or "" }
    if estimate < 0.01 then unsaid_rolled = math.max(unsaid_rolled, missing) end
  end
end
hobe.table{
  title = string.format("A moment rolls the bar up by %g rad", rolled), rows = rows,
  columns = { "element", "elements", "turn, rad", "an element", "missing", "estimate", "" },
}
hobe.report{
  finest = { rows[10 + 2][3], "rad", expect = rolled, within = 1e-3 },
  unsaid = { unsaid, "", expect = 0, within = 0.0125 },
  unsaid_rolled = { unsaid_rolled, "", expect = 0, within = 0.0125 },
  warned = { warned, "", expect = 16 },
}
