-- expect: bad/body_shape\.lua:3: body: a body of shape cylinder needs length$
local hobe = require "hobe"
local disk = hobe.body{ name = "disk", shape = "cylinder", radius = 1, density = 1, centre = {0, 0, 0} }
