-- expect: bad/picture_too_high\.lua:6: a picture of 12 drawings in 1 columns would be [0-9]+ pixels high, at most 30000 are possible: take more columns or fewer drawings$
local hobe = require "hobe"
local square = hobe.square{ side = 1 }
local sections = {}
for i = 1, 12 do sections[i] = { square } end
hobe.picture{ file = "w.png", columns = 1, width = 4000, sections = sections }
