-- expect: bad/body_free\.lua:4: body "disk" is free to move: rotation about z; hold it by a support, or join it to a held beam$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.body{ name = "disk", mass = 1, inertia = {1, 1, 1.5}, centre = {0, 0, 0} },
  hobe.support{ "disk", point = {0, 0, 0}, kind = "revolute", axis = {0, 0, 1} },
}
hobe.static(scene)
