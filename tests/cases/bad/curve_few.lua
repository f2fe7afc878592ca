-- expect: bad/curve_few\.lua:4: a curve needs 2 to 10000 points, got 1$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = {{0, 0, 0}} },
  hobe.clamp{ "a", at = 0 },
}
