-- expect: bad/outline_key\.lua:3: outline: unknown key "name", did you mean
local hobe = require "hobe"
local section = hobe.outline{ name = "data/disc.dxf" }
print(section.J)
