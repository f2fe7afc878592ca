-- expect: bad/tube_inner\.lua:3: a tube needs radii outer > inner > 0 \(m\), got outer = 0\.05, inner = 0\.05$
local hobe = require "hobe"
local section = hobe.tube{ outer = 0.05, inner = 0.05 }
print(section.J)
