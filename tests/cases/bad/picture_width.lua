-- expect: bad/picture_width\.lua:3: picture: width must be from 300 to 4000, got 20000$
local hobe = require "hobe"
hobe.picture{ file = "w.png", width = 20000, sections = {{ hobe.square{ side = 1 } }} }
