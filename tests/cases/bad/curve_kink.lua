-- expect: bad/curve_kink\.lua:4: curve must be smooth, but it has a kink, or turns too sharply, near curve\(0\.(497|503)\); split the beam there$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = function(t) return {t, math.abs(t - 0.5), 0} end },
  hobe.clamp{ "a", at = 0 },
}
