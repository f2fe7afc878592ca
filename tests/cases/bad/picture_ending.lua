-- expect: bad/picture_ending\.lua:3: picture: file must end with \.png, got "w\.jpg"$
local hobe = require "hobe"
hobe.picture{ file = "w.jpg", sections = {{ hobe.square{ side = 1 } }} }
