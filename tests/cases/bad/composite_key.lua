-- expect: bad/composite_key\.lua:4: composite: part 1: unknown key "place", did you mean
local hobe = require "hobe"
local square, steel = hobe.square{side = 0.1}, {E = 210e9, nu = 0.3}
local section = hobe.composite{ {section = square, material = steel, place = {0, 0}} }
