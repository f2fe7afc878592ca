-- expect: bad/curve_point\.lua:4: beam: curve\[2\]\[3\] must be a finite number, got nan$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = {{0, 0, 0}, {1, 0, 0/0}} },
  hobe.clamp{ "a", at = 0 },
}
