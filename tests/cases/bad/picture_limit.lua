-- expect: bad/picture_limit\.lua:3: picture: limit must be > 0, got -1$
local hobe = require "hobe"
hobe.picture{ file = "w.png", sections = {{ hobe.square{ side = 1 } }}, limit = -1 }
