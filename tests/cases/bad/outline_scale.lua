-- expect: bad/outline_scale\.lua:3: outline: scale must be > 0, got -1$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/disc.dxf", scale = -1 }
print(section.J)
