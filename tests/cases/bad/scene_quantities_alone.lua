-- expect: bad/scene_quantities_alone\.lua:3: scene: quantities are those of accuracy, which is missing$
local hobe = require "hobe"
hobe.scene{ hobe.gravity{0, 0, -9.81}, quantities = function(scene) return {} end }
