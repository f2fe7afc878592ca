-- expect: bad/T_top\.lua:3: T: unknown key "top_width"
local hobe = require "hobe"
local section = hobe.T{ height = 0.2, width = 0.1, top_width = 0.05, flange = 0.01, web = 0.01 }
print(section.J)
