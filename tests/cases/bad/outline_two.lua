-- expect: bad/outline_two\.lua:3: data/two\.csv: hole 1 at \(0, 0\) lies outside the outline$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/two.csv" }
print(section.J)
