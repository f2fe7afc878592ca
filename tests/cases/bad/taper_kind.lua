-- expect: bad/taper_kind\.lua:3: a taper needs two sections that differ in sizes only, got "rectangle .*" and "circle .*"$
local hobe = require "hobe"
hobe.taper{ from = hobe.square{ side = 0.1 }, to = hobe.circle{ radius = 0.05 } }
