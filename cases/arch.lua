-- A clamped shallow arch snaps through under a load at its crown.
--
-- Radius 10 m, half its angle 0.1 rad, 50 x 10 mm, E 70 GPa.  hobe.path follows the load up to its
-- first limit point, down through a second one, and up again, where hobe.static would find nothing
-- or jump.  Expected: the theory of shallow arches (Schreyer & Masur 1966, closed form; its symmetric
-- states), which leaves out the square of the slopes, 1 %.
local hobe = require "hobe"

local R, beta = 10, 0.1                               -- m, rad
local P = hobe.param("P", 1000)                       -- N, at load factor 1

local scene = hobe.scene{
  hobe.beam{
    name = "arch", element = hobe.param("element", "MGD30"), elements = hobe.param("n", 32),
    section = hobe.rectangle{ width = 0.05, height = 0.01 }, material = { E = 70e9, nu = 0 },
    curve = function(t)
      local a = beta*(2*t - 1)
      return { R*math.sin(a), 0, R*math.cos(a) }
    end,
  },
  hobe.clamp{ "arch", at = 0 },
  hobe.clamp{ "arch", at = 1 },
  hobe.force{ "arch", at = 1/2, value = {0, 0, -P} },
}
local path = hobe.path(scene, { arc = hobe.param("arc", 0.2) })

local down, load, rows = { 0 }, { 0 }, {}             -- the reference first
for i, point in ipairs(path) do
  down[i + 1] = -point:displacement("arch", 1/2)[3]
  load[i + 1] = P*point.load
  rows[i] = { i, down[i + 1], load[i + 1], point.negative, point.energy }
end
hobe.table{
  file = "arch.csv", title = "Points of the path",
  columns = { "point", "crown, m", "P, N", "negative", "energy, J" }, rows = rows,
}
local at_limit = { {}, {} }
for _, limit in ipairs(path.limit_points) do
  at_limit[1][#at_limit[1] + 1] = (down[limit.after + 1] + down[limit.after + 2])/2
  at_limit[2][#at_limit[2] + 1] = P*limit.load
end
hobe.plot{
  file = "arch.png", title = "A clamped shallow arch under a load at its crown",
  xlabel = "way down of the crown, m", ylabel = "P, N",
  series = {
    { x = down, y = load, label = "path" },
    { x = at_limit[1], y = at_limit[2], style = "points", label = "limit points" },
  },
}
local limit = path.limit_points
hobe.report{
  upper_limit = { P*limit[1].load, "N", expect = 403.1, within = 5e-3 },
  lower_limit = { P*limit[2].load, "N", expect = 178.4, within = 5e-3 },
  crown_at_the_end = { down[#down], "m" },
}
