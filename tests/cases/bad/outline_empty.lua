-- expect: bad/outline_empty\.lua:3: data/empty\.csv: there is no outline in it$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/empty.csv" }
print(section.J)
