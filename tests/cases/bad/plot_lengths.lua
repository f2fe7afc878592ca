-- expect: bad/plot_lengths\.lua:3: plot: series\[1\] must have as many numbers in y as in x, at least one, got 1 and 2$
local hobe = require "hobe"
hobe.plot{ file = "u3.png", series = {{ x = {1, 2}, y = {1} }} }
