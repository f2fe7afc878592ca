-- expect: bad/composite_apart\.lua:4: composite: part 2 is apart from part 1; the parts of a section must hang together
local hobe = require "hobe"
local square, steel = hobe.square{side = 0.1}, {E = 210e9, nu = 0.3}
local section = hobe.composite{ {section = square, material = steel}, {section = square, at = {0.2, 0}, material = steel} }
