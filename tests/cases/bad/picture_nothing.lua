-- expect: bad/picture_nothing\.lua:3: picture must be given something to draw in one of sections, .*; got 0 of them$
local hobe = require "hobe"
hobe.picture{ file = "w.png" }
