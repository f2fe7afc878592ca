-- expect: bad/composite_material\.lua:4: composite: part 1.material.nu must be
local hobe = require "hobe"
local square = hobe.square{side = 0.1}
local section = hobe.composite{ {section = square, material = {E = 210e9, nu = 0.5}} }
