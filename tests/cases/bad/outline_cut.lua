-- expect: bad/outline_cut\.lua:3: data/cut\.dxf: line 24: the file ends without EOF; it was cut short$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/cut.dxf" }
print(section.J)
