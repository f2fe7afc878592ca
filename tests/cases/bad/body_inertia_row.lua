-- expect: bad/body_inertia_row\.lua:3: body: inertia\[2\] must be three numbers \{x, y, z\}, got 1$
local hobe = require "hobe"
hobe.body{ name = "ball", mass = 1, centre = {0, 0, 0}, inertia = {{1, 0, 0}, 1, 1} }
