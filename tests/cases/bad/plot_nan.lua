-- expect: bad/plot_nan\.lua:3: plot: series\[1\].y\[2\] must be a finite number, got nan$
local hobe = require "hobe"
hobe.plot{ file = "u3.png", series = {{ x = {1, 2}, y = {1, 0/0} }} }
