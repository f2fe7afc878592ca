-- expect: bad/taper_zero\.lua:4: rectangle: height must be > 0, got 0\.0$
local hobe = require "hobe"
hobe.taper(function(at)
  return hobe.rectangle{ width = 0.1, height = 0.1*(1 - at) }
end)
