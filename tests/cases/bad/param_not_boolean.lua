-- expect: bad/param_not_boolean\.lua:4: argument log=1: parameter log must be true or false$
-- args: log=1
local hobe = require "hobe"
local n = hobe.param("log", false)
