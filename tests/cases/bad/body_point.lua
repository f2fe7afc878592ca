-- expect: bad/body_point\.lua:8: the place on body "disk" is missing: point, \{x, y, z\} in the reference$
local hobe = require "hobe"
local body = { mass = 1, inertia = {1, 1, 1.5}, centre = {1, 0, 0} }
local function named(name) body.name = name; return hobe.body(body) end
local scene = hobe.scene{
  named("disk"), named("other"),
  hobe.support{ "disk", point = {0, 0, 0}, kind = "fixed" },
  hobe.joint{ "disk", "other", at = 0, kind = "fixed" },
}
