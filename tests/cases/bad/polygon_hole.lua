-- expect: bad/polygon_hole\.lua:3: polygon: hole 1 at \(2, 2\) lies outside the outline$
local hobe = require "hobe"
local section = hobe.polygon{ {0, 0}, {1, 0}, {1, 1}, {0, 1}, holes = { { {2, 2}, {3, 2}, {2, 3} } } }
print(section.J)
