-- Lee's frame: two hinged legs snap through, the whole path.
--
-- Legs of 120, section 3 wide and 2 high, E = 720, nu = 0.3, load at a fifth of the beam (Lee,
-- Manuel & Rossow 1968; any unit of length and force).  The load climbs to a limit point, falls
-- below zero, turns back, and climbs again.  Expected: Reissner's rod in the plane with the
-- section's EA, GA and EI, integrated by Runge and Kutta's method and shooting, which element 3333s
-- is a model of, within what its 20 elements leave.  (The same without stretch and shear has
-- 1.85588, 18.559 EI/L^2, and -0.94213.)  MGD30w is a continuum, whose law makes something else of
-- strains that reach 5 %: 0.12 and 0.5 % less.
--
-- The hinges' axes lie across the plane, but nothing else keeps the frame in it: it tips over
-- sideways before it snaps.  The path goes on in the plane, where the books follow it.
local hobe = require "hobe"

local L = 120
local arc = hobe.param("arc", 0.25)
local hinge = {0, 1, 0}

local function leg(name, element, from, to)
  return hobe.beam{
    name = name, element = element, elements = hobe.param("n", 20),
    section = hobe.rectangle{ width = 3, height = 2 }, material = { E = 720, nu = 0.3 },
    from = from, to = to,
  }
end

local function frame(element)
  return hobe.scene{
    leg("column", element, {0, 0, 0}, {0, 0, L}),
    leg("beam", element, {0, 0, L}, {L, 0, L}),
    hobe.join{ "column", "beam", at = {1, 0} },
    hobe.support{ "column", at = 0, kind = "revolute", axis = hinge, name = "foot" },
    hobe.support{ "beam", at = 1, kind = "revolute", axis = hinge, name = "wall" },
    hobe.force{ "beam", at = 1/5, value = {0, 0, -1} },
  }
end

local function follow(element)
  local path = hobe.path(frame(element), { arc = arc, to = 2.2 })
  local x, z, load = { 0 }, { 0 }, { 0 }
  for i, point in ipairs(path) do
    local u = point:displacement("beam", 1/5)
    x[i + 1], z[i + 1], load[i + 1] = u[1], -u[3], point.load
  end
  return path, x, z, load
end

local path, x, z, load = follow("MGD30w")
local rod = follow("3333s")

local limit, tip = path.limit_points, path.bifurcations[1]
local shown, rows = {}, {}
local function show(place)                            -- the point of the path nearest to a place
  shown[#shown + 1] = { path[place], string.format("P = %.3f", load[place + 1]) }
  local foot, wall = path[place]:reaction("foot").force, path[place]:reaction("wall").force
  rows[#rows + 1] = { load[place + 1], x[place + 1], z[place + 1], foot[1], foot[3], wall[3],
                      path[place].negative }
end
for _, place in ipairs{ limit[1].after//2, limit[1].after, (limit[1].after + limit[2].after)//2,
                        limit[2].after, #path } do
  show(place)
end
hobe.table{
  title = "States on the path: load, its way right and down, reactions",
  columns = { "P", "right", "down", "foot x", "foot z", "wall z", "negative" }, rows = rows,
}
local at_x, at_y = {}, {}
for _, event in ipairs{ limit[1], limit[2], tip } do
  local i = event.after + 1
  at_x[#at_x + 1], at_y[#at_y + 1] = (z[i] + z[i + 1])/2, event.load
end
hobe.plot{
  file = "lee.png", title = "Lee's frame", xlabel = "way of the load", ylabel = "P",
  series = {
    { x = z, y = load, label = "down" }, { x = x, y = load, label = "right" },
    { x = at_x, y = at_y, style = "points", label = "limits, and where it tips over" },
  },
}

hobe.picture{
  file = "lee_states.png", title = "Lee's frame on its path", states = shown, colour = "u",
  view = { azimuth = -90, elevation = 0 }, columns = 3,
}

-- The last state: what the hinges carry, and the lever of the load about the foot.
local last = path[#path]
local foot, wall = last:reaction("foot").force, last:reaction("wall").force
local at, to = last:position("beam", 1/5), last:position("beam", 1)
hobe.report{
  rod_upper = { rod.limit_points[1].load, expect = 1.854656, within = 1e-4 },
  rod_lower = { rod.limit_points[2].load, expect = -0.939614, within = 2e-4 },
  upper = { limit[1].load, expect = 1.854656, within = 2e-3 },
  lower = { limit[2].load, expect = -0.939614, within = 6e-3 },
  tips_over = tip.load,
  carried = { foot[3] + wall[3], expect = 2.2, within = 1e-8 },
  lever = { (to[1]*wall[3] - to[3]*wall[1])/last.load, expect = at[1], within = 1e-8 },
}
