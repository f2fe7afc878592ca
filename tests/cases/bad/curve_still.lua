-- expect: bad/curve_still\.lua:4: the curve stands still, or turns back, near t = 0\.5 at
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = function(t) return {(2 * t - 1)^3, 0, 0} end },
  hobe.clamp{ "a", at = 0 },
}
