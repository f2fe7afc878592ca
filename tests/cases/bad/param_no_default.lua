-- expect: bad/param_no_default\.lua:3: param: the default of n must be a number, string or boolean, got nothing$
local hobe = require "hobe"
local n = hobe.param("n")
