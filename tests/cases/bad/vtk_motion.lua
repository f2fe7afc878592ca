-- expect: bad/vtk_motion\.lua:8: vtk: motion must be a motion of hobe\.dynamic\(scene, \.\.\.\), got
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 1, section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
}
hobe.vtk{ file = "x.pvd", motion = hobe.static(scene) }
