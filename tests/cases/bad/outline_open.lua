-- expect: bad/outline_open\.lua:3: data/open\.dxf: the LINE of line 16 ends at \(0, 0\), where nothing goes on \(the nearest other end is 1 away\); an outline must be closed$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/open.dxf" }
print(section.J)
