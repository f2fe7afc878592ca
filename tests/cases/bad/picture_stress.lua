-- expect: bad/picture_stress\.lua:9: beam "blade" has no stress at a point: the law of element 3333s is one of section forces; ask for its resultants at the ends of elements$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "blade", element = "3333s", elements = 1, section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
}
local r = hobe.static(scene)
hobe.picture{ file = "x.png", state = r, colour = "mises" }
