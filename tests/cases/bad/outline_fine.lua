-- expect: bad/outline_fine\.lua:3: data/disc\.dxf: an outline with its holes may have 1000 points, got more; where it has arcs a larger tolerance needs fewer$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/disc.dxf", tolerance = 1e-12 }
print(section.J)
