-- expect: bad/picture_slice_section\.lua:3: picture: slice needs a state or states to cut$
local hobe = require "hobe"
hobe.picture{ file = "w.png", sections = {{ hobe.square{ side = 1 } }}, slice = { "blade", 1 } }
