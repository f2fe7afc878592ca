-- expect: bad/dynamic_jump\.lua:8: a drive with a jump: the joint "motor" starts with the speed 3 \(m/s or rad/s\) while all is at rest
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 2, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.support{ "blade", at = 0, kind = "revolute", axis = {0, 0, 1}, name = "motor",
                angular_velocity = 3 },
}
hobe.dynamic(scene, { to = 1, step = 1e-3 })
