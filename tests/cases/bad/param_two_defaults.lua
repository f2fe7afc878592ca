-- expect: bad/param_two_defaults\.lua:4: param: n has the default 24 already, got 12$
local hobe = require "hobe"
local n = hobe.param("n", 24)
local m = hobe.param("n", 12)
