-- expect: bad/curve_and_from\.lua:4: beam: from and curve exclude each other
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    from = {0, 0, 0}, curve = {{0, 0, 0}, {1, 0, 0}} },
  hobe.clamp{ "a", at = 0 },
}
