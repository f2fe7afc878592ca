-- expect: bad/wall_bending_taper\.lua:5: an outline that varies along the beam has the functions w, wy and wz only, and does not know how its walls bend$
local hobe = require "hobe"
local from = hobe.hollow{ width = 0.2, height = 0.1, thickness = 0.02 }
local to = hobe.hollow{ width = 0.1, height = 0.1, thickness = 0.02 }
hobe.taper{ from = from, to = to }:wall_bending()
