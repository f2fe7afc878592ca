-- expect: bad/curve_up\.lua:4: up = \{0, 0, 1\} points along the curve at 0 of its length
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = function(t) return {t * t, 0, t} end },
  hobe.clamp{ "a", at = 0 },
}
