-- expect: bad/outline_unit\.lua:3: data/miles\.dxf: its unit, \$INSUNITS = 3, is not known; give scale, the metres in one unit$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/miles.dxf" }
print(section.J)
