-- expect: bad/curve_holes\.lua:4: beam: curve must be a list of points .*, got a table with other keys or holes$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = {{0, 0, 0}, {1, 0, 0}, closed = true} },
  hobe.clamp{ "a", at = 0 },
}
