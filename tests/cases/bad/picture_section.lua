-- expect: bad/picture_section\.lua:3: picture: sections\[1\]\.section must be a section, such as .*, got 3$
local hobe = require "hobe"
hobe.picture{ file = "w.png", sections = {{ 3 }} }
