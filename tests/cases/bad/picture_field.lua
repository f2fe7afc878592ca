-- expect: bad/picture_field\.lua:3: picture: field must be one of "w", "wy", "wz", got "wx"$
local hobe = require "hobe"
hobe.picture{ file = "w.png", field = "wx", sections = {{ hobe.square{ side = 1 } }} }
