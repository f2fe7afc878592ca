-- expect: bad/polygon_point\.lua:3: polygon: \[3\] must be two numbers
local hobe = require "hobe"
local section = hobe.polygon{ {0, 0}, {1, 0}, {1, 1, 2} }
print(section.J)
