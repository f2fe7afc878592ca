-- expect: bad/picture_two\.lua:8: picture must be given something to draw in one of sections, .*; got 2 of them$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 1, section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
}
hobe.picture{ file = "w.png", state = hobe.static(scene), sections = {{ hobe.square{ side = 1 } }} }
