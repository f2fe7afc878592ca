-- expect: bad/picture_view\.lua:3: picture: view\.elevation must be from -90 to 90, got 100$
local hobe = require "hobe"
hobe.picture{ file = "w.png", view = { elevation = 100 }, sections = {{ hobe.square{ side = 1 } }} }
