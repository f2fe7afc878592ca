-- expect: bad/twist_type\.lua:4: beam: twist must be an angle or a function of it, got "9"$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = hobe.square{ side = 0.1 },
    material = { E = 1e9, nu = 0.3 },
    from = {0, 0, 0}, to = {1, 0, 0}, twist = "9" },
  hobe.clamp{ "a", at = 0 },
}
