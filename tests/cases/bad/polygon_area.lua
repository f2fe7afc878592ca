-- expect: bad/polygon_area\.lua:3: polygon: the outline encloses no area$
local hobe = require "hobe"
local section = hobe.polygon{ {0, 0}, {1, 1}, {2, 2} }
print(section.J)
