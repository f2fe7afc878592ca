-- expect: bad/taper_number\.lua:3: the function of a taper must return a section such as hobe\.rectangle\{\.\.\.\}, got 0\.1 at 0$
local hobe = require "hobe"
hobe.taper(function(at) return 0.1 + at end)
