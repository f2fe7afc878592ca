-- expect: bad/composite_overlap\.lua:4: composite: parts 1 and 2 overlap at .*; parts must touch only$
local hobe = require "hobe"
local square, steel = hobe.square{side = 0.1}, {E = 210e9, nu = 0.3}
local section = hobe.composite{ {section = square, material = steel}, {section = square, at = {0.05, 0}, material = steel} }
