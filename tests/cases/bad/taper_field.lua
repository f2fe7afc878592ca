-- expect: bad/taper_field\.lua:4: this section varies along the beam; ask for A where it is the same
local hobe = require "hobe"
local section = hobe.taper{ from = hobe.square{ side = 0.1 }, to = hobe.square{ side = 0.2 } }
print(section.A)
