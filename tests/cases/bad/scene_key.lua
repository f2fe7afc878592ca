-- expect: bad/scene_key\.lua:5: scene: unknown key "gravity"; a scene is a list of items, and may have accuracy and quantities$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  gravity = hobe.force{ "blade", at = 1, value = {0, 0, -10} },
}
hobe.static(scene)
