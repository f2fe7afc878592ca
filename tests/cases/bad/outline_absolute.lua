-- expect: bad/outline_absolute\.lua:3: outline: a case script reads files in its own folder and below: a relative name without "\.\." is needed, got "/etc/passwd" \(hobe run --trust allows others\)$
local hobe = require "hobe"
local section = hobe.outline{ file = "/etc/passwd" }
print(section.J)
