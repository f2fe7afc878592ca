-- expect: bad/I_flanges_thick\.lua:3: I: both flanges together must be thinner than the height of 0\.2, got 0\.1 and 0\.15$
local hobe = require "hobe"
local section = hobe.I{ height = 0.2, width = 0.1, flange = 0.1, top_flange = 0.15, web = 0.01 }
print(section.J)
