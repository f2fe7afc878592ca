-- expect: bad/body_size\.lua:3: body: a body of shape sphere has no size$
local hobe = require "hobe"
hobe.body{ name = "ball", shape = "sphere", radius = 1, size = {1, 1, 1}, mass = 1, centre = {0, 0, 0} }
