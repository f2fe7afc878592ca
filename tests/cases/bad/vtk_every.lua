-- expect: bad/vtk_every\.lua:8: vtk: every = 2 needs a motion to choose from$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 1, section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
}
hobe.vtk{ file = "x.vtu", state = hobe.static(scene), every = 2 }
