-- expect: bad/taper_file\.lua:4: a taper cannot be made of this section: 
local hobe = require "hobe"
local disc = hobe.outline{ file = "data/disc.dxf", scale = 0.001 }
hobe.taper{ from = disc, to = disc }
