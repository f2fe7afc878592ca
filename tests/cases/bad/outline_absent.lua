-- expect: bad/outline_absent\.lua:3: outline: bad/data/absent\.dxf could not be read: No such file or directory; a case script reads regular files in its own folder and below, through no symbolic link \(hobe run --trust allows others\)$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/absent.dxf" }
print(section.J)
