-- expect: bad/body_inertia\.lua:3: no body has the principal inertias 1, 1, 3 kg m\^2 of "disk": none may be more than the sum of the others$
local hobe = require "hobe"
hobe.scene{ hobe.body{ name = "disk", mass = 2, centre = {0, 0, 0}, inertia = {1, 3, 1} } }
