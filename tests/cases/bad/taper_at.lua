-- expect: bad/taper_at\.lua:4: at: the fraction of the length must be from 0 to 1, got 1\.5$
local hobe = require "hobe"
local section = hobe.taper{ from = hobe.square{ side = 0.1 }, to = hobe.square{ side = 0.2 } }
section:at(1.5)
