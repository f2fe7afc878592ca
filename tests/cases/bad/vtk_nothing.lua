-- expect: bad/vtk_nothing\.lua:3: vtk must be given one of state, states, motion, mode; got 0 of them$
local hobe = require "hobe"
hobe.vtk{ file = "x.vtu" }
