-- expect: bad/taper_at_plain\.lua:3: this section is the same all along: rectangle
local hobe = require "hobe"
hobe.square{ side = 0.1 }:at(0.5)
