-- expect: bad/outline_link\.lua:3: outline: bad/data/link\.dxf could not be read: .*; a case script reads regular files in its own folder and below, through no symbolic link \(hobe run --trust allows others\)$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/link.dxf" }
print(section.J)
