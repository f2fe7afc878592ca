-- expect: bad/outline_word\.lua:3: data/word\.csv: line 4 must hold two numbers, y and z, got "1,one"$
local hobe = require "hobe"
local section = hobe.outline{ file = "data/word.csv" }
print(section.J)
