-- expect: bad/body_density\.lua:3: body "ball" needs a mass, kg, or a density, kg/m\^3: one of them, > 0$
local hobe = require "hobe"
hobe.scene{ hobe.body{ name = "ball", shape = "sphere", radius = 1, mass = 1, density = 1,
                       centre = {0, 0, 0} } }
