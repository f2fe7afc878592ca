-- expect: bad/radius_zero\.lua:3: circle: radius must be > 0, got 0$
local hobe = require "hobe"
local section = hobe.circle{ radius = 0 }
print(section.J)
