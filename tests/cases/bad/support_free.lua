-- expect: bad/support_free\.lua:6: beam "blade" is free to move: rotation about y; hold it by a clamp or a support, or join it to a held beam$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.support{ "blade", at = 0, kind = "revolute", axis = {0, 1, 0} },
  hobe.force{ "blade", at = 1, value = {0, 0, -10} },
}
local r = hobe.static(scene)
