-- expect: bad/key_beam\.lua:6: beam: unknown key "elemnts", did you mean "elements"\? \(keys: name, .*integration, damping\)$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elemnts = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.force{ "blade", at = 1, value = {0, 0, -10} },
}
hobe.static(scene)
