-- expect: bad/missing_to\.lua:4: beam: to is missing: an end of the axis \{x, y, z\}, or a curve$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    from = {0, 0, 0} },
  hobe.clamp{ "a", at = 0 },
}
