-- expect: bad/wall_thick\.lua:3: hollow: the wall must be thinner than half of 0\.05 \(m\), got 0\.03$
local hobe = require "hobe"
local section = hobe.hollow{ width = 0.1, height = 0.05, thickness = 0.03 }
print(section.J)
