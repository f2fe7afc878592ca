-- expect: bad/curve_error\.lua:6: bad argument #1 to .sqrt.
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = function(t) return { math.sqrt{}, 0, 0 } end },
  hobe.clamp{ "a", at = 0 },
}
