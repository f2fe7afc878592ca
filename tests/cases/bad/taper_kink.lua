-- expect: bad/taper_kink\.lua:3: the section must be smooth, but it has a kink, .* near the section\(0\.(497|503)\); split the beam there$
local hobe = require "hobe"
hobe.taper(function(at)
  return hobe.rectangle{ width = 0.1, height = 0.1 + math.abs(at - 0.5) }
end)
