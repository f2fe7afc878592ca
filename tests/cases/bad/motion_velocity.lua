-- expect: bad/motion_velocity\.lua:9: the velocities of the start break the joint "pin" by 2 \(m/s or rad/s\); give such as fit it by hobe\.motion$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.motion{ velocity = {0, 0, 2} },
  hobe.beam{ name = "blade", elements = 2, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.support{ "blade", at = 0, kind = "spherical", name = "pin" } }
hobe.dynamic(scene, { to = 1, step = 1e-3 })
