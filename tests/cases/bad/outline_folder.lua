-- expect: bad/outline_folder\.lua:3: outline: bad/data could not be read: not a regular file; a case script reads regular files in its own folder and below, through no symbolic link \(hobe run --trust allows others\)$
local hobe = require "hobe"
local section = hobe.outline{ file = "data" }
print(section.J)
