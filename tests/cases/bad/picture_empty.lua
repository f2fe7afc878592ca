-- expect: bad/picture_empty\.lua:3: picture must be given something to draw in one of sections, .*; got 1 of them$
local hobe = require "hobe"
hobe.picture{ file = "w.png", sections = {} }
