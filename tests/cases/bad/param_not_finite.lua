-- expect: bad/param_not_finite\.lua:4: argument n=1e999: parameter n must be a number$
-- args: n=1e999
local hobe = require "hobe"
local n = hobe.param("n", 24)
