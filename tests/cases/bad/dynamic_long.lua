-- expect: bad/dynamic_long\.lua:9: no motion was found beyond t = .* s: in a step of 0\.5 s .*; take a smaller step, or give an accuracy that chooses the steps$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 2, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.motion{ angular_velocity = {0, 30, 40} } }
hobe.dynamic(scene, { to = 10, step = 0.5 })
