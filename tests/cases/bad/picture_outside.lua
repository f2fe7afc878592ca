-- expect: bad/picture_outside\.lua:3: a file must be a plain name inside the output folder
local hobe = require "hobe"
hobe.picture{ file = "../w.png", sections = {{ hobe.square{ side = 1 } }} }
