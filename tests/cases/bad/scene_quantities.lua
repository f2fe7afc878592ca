-- expect: bad/scene_quantities\.lua:[0-9]+: scene: quantity sag must be a number, got "low"$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "b", elements = 1, section = hobe.square{ side = 0.1 },
             material = { E = 1e9, nu = 0.3 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "b", at = 0 },
  accuracy = 1e-3, quantities = function(scene) return { sag = "low" } end,
}
