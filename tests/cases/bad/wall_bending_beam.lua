-- expect: bad/wall_bending_beam\.lua:11: there is no beam "bowl" in the scene; beams are: "box"$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "box", element = "MGD30w", elements = 2,
             section = hobe.circle{ radius = 0.1 },
             material = { E = 1e9, nu = 0.3 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "box", at = 0, warping = "free" },
  hobe.moment{ "box", at = 1, value = {1, 0, 0} },
}
local r = hobe.static(scene)
r:wall_bending("bowl")
