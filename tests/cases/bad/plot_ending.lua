-- expect: bad/plot_ending\.lua:3: plot: file must end with .png, got "u3.svg"$
local hobe = require "hobe"
hobe.plot{ file = "u3.svg", series = {{ x = {1}, y = {1} }} }
