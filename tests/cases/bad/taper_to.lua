-- expect: bad/taper_to\.lua:3: taper: to is missing: the section at its end, of the same kind$
local hobe = require "hobe"
hobe.taper{ from = hobe.square{ side = 0.1 } }
