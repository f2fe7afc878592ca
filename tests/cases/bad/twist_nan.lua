-- expect: bad/twist_nan\.lua:4: beam: twist\(0\.5\) must be a finite number, got nan$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    from = {0, 0, 0}, to = {1, 0, 0}, twist = function(at) return at == 0.5 and 0/0 or at end },
  hobe.clamp{ "a", at = 0 },
}
