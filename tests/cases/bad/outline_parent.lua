-- expect: bad/outline_parent\.lua:3: outline: a case script reads files in its own folder and below: a relative name without "\.\." is needed, got "data/\.\./data/disc\.dxf" \(hobe run --trust allows others\)$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/../data/disc.dxf" }
print(section.J)
