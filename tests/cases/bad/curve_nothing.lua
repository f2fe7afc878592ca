-- expect: bad/curve_nothing\.lua:4: beam: curve\(1\.0\) is missing: the function must return \{x, y, z\}$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    curve = function(t) end },
  hobe.clamp{ "a", at = 0 },
}
