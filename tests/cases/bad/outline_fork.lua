-- expect: bad/outline_fork\.lua:3: data/fork\.dxf: 3 ends meet at \(0, 0\), one of them the LINE.s of line 16; an outline goes on one way only$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/fork.dxf" }
print(section.J)
