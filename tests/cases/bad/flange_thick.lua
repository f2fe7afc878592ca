-- expect: bad/flange_thick\.lua:3: I: the flange must be thinner than half the height of 0\.2, got 0\.1$
local hobe = require "hobe"
local section = hobe.I{ height = 0.2, width = 0.1, flange = 0.1, web = 0.01 }
print(section.J)
