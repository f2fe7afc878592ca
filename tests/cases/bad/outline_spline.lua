-- expect: bad/outline_spline\.lua:3: data/spline\.dxf: line 16: SPLINE is not read; turn it into lines, arcs or polylines$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/spline.dxf" }
print(section.J)
