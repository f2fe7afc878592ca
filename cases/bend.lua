-- A cantilever along an eighth of a circle, bent out of its plane and twisted by a dead tip load.
--
-- Bathe & Bolourchi 1979, "Large displacement analysis of three-dimensional beam structures" (there
-- in inches and pounds): radius 100, a square of side 1, E 1e7, nu 0, load 600.
-- Expected numbers: an independent prototype with a section that warps.  Rods that take the polar
-- moment 1/6 for the torsion constant, 0.1406, twist less: a line of the table.  The error of 16
-- elements is 4e-4.
local hobe = require "hobe"

local R, angle = 100, math.pi/4
local load = hobe.param("load", 600)                 -- N

local function arc(t)                                -- t from 0 to 1
  local a = angle*t
  return { R*math.sin(a), R*(1 - math.cos(a)), 0 }
end

local function tip(curve)
  local scene = hobe.scene{
    hobe.beam{
      name = "bend", element = hobe.param("element", "MGD30w"), elements = hobe.param("n", 16),
      section = hobe.square{ side = 1 }, material = { E = 1e7, nu = 0 },
      curve = curve,
    },
    hobe.clamp{ "bend", at = 0 },
    hobe.force{ "bend", at = 1, value = {0, 0, load} },
  }
  local u, r0 = hobe.static(scene):displacement("bend", 1), arc(1)
  return { r0[1] + u[1], r0[2] + u[2], r0[3] + u[3] }
end

local points = {}                                    -- the same for a spline
for i = 0, 8 do points[i + 1] = arc(i/8) end

local r, spline = tip(arc), tip(points)
local known = { [300] = {58.536, 22.113, 40.481}, [600] = {46.892, 15.558, 53.608} }
local expect = known[load] or {}

if load == 600 then
  hobe.table{
    title = "Tip of the bend under 600 N",
    columns = { "", "x, m", "y, m", "z, m" },
    rows = {
      { "this run",                   r[1],      r[2],      r[3] },
      { "through 9 points",           spline[1], spline[2], spline[3] },
      { "torsion constant 1/6",       47.150,    15.685,    53.476 },
      { "Bathe & Bolourchi 1979",     47.2,      15.9,      53.4 },
    },
  }
end
hobe.report{
  x = { r[1], "m", expect = expect[1], within = expect[1] and 5e-4 },
  y = { r[2], "m", expect = expect[2], within = expect[2] and 5e-4 },
  z = { r[3], "m", expect = expect[3], within = expect[3] and 5e-4 },
  spline_z = { spline[3], "m", expect = r[3], within = 1e-5 },  -- error (pi/32)^4 / 384 = 2e-7
}
