-- expect: bad/curve_type\.lua:4: beam: curve must be a function of t or a list of points \{x, y, z\}, got 3$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = 3 },
  hobe.clamp{ "a", at = 0 },
}
