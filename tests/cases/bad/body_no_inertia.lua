-- expect: bad/body_no_inertia\.lua:3: body: inertia is missing: \{I1, I2, I3\}, kg m\^2; or a shape$
local hobe = require "hobe"
hobe.body{ name = "ball", mass = 1, centre = {0, 0, 0} }
