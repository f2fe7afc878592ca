-- expect: bad/taper_error\.lua:4: attempt to perform arithmetic on a nil value
local hobe = require "hobe"
hobe.taper(function(at)
  return hobe.square{ side = nil + at }
end)
