-- expect: bad/spring_at_two\.lua:9: spring: at must be two numbers \{a, b\}, got a table with 1$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.spring{ "blade", "blade", at = {1}, stiffness = 3 },
}
local r = hobe.static(scene)
