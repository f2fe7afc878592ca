-- expect: bad/picture_mode\.lua:9: picture: the mode must be from 1 to 2, got 3$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 1, section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
}
local modes = hobe.modal(scene, { modes = 2 })
hobe.picture{ file = "w.png", mode = { modes, 3 } }
