-- expect: bad/taper_twice\.lua:4: a taper cannot be made of this section: varies along the beam; at 0: rectangle
local hobe = require "hobe"
local section = hobe.taper{ from = hobe.square{ side = 0.1 }, to = hobe.square{ side = 0.2 } }
hobe.taper{ from = section, to = hobe.square{ side = 0.1 } }
