-- expect: bad/body_second\.lua:3: body "ball" is not round about its axis: it needs second, the direction \{x, y, z\} of its second one$
local hobe = require "hobe"
hobe.scene{ hobe.body{ name = "ball", mass = 1, inertia = {1, 1, 1.5}, axis = {0, 0, 1},
                       centre = {0, 0, 0} } }
