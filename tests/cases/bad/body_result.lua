-- expect: bad/body_result\.lua:7: displacement: the point of the body must be three numbers \{x, y, z\}, got 0\.5$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.body{ name = "disk", mass = 1, inertia = {1, 1, 1.5}, centre = {0, 0, 0} },
  hobe.support{ "disk", point = {0, 0, 0}, kind = "fixed" },
}
hobe.static(scene):displacement("disk", 0.5)
