-- expect: bad/picture_mode_twist\.lua:9: mode shapes cannot be coloured by "twist", only by u, ux, uy, uz, w
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 1, section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
}
local modes = hobe.modal(scene, { modes = 2 })
hobe.picture{ file = "w.png", modes = {{ modes, 1 }}, colour = "twist" }
