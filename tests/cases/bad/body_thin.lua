-- expect: bad/body_thin\.lua:3: body "rod" has the principal inertias 0, 1, 1 kg m\^2, and would turn freely where one is 0; give it some, or take hobe\.mass$
local hobe = require "hobe"
hobe.scene{ hobe.body{ name = "rod", mass = 2, centre = {0, 0, 0}, inertia = {0, 1, 1} } }
