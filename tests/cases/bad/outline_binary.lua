-- expect: bad/outline_binary\.lua:3: data/binary\.dxf: this is a binary DXF; save the drawing as DXF text \(ASCII\)$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/binary.dxf" }
print(section.J)
