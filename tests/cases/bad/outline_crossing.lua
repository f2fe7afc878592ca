-- expect: bad/outline_crossing\.lua:3: data/crossing\.csv: the outline crosses or touches itself
local hobe = require "hobe"
local section = hobe.outline{ file = "data/crossing.csv" }
print(section.J)
