-- expect: bad/polygon_key\.lua:3: polygon: unknown key "hole"; it holds points
local hobe = require "hobe"
local section = hobe.polygon{ {0, 0}, {1, 0}, {1, 1}, hole = {} }
print(section.J)
