-- expect: bad/composite_nested\.lua:4: composite: part 1: it is a composite section itself; give its parts instead$
local hobe = require "hobe"
local part = {section = hobe.square{side = 0.1}, material = {E = 210e9, nu = 0.3}}
local section = hobe.composite{ {section = hobe.composite{part}, material = part.material} }
