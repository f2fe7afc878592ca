-- expect: bad/polygon_crossing\.lua:3: polygon: the outline crosses or touches itself, between the edges
local hobe = require "hobe"
local section = hobe.polygon{ {0, 0}, {1, 1}, {1, 0}, {0, 1.5} }
print(section.J)
