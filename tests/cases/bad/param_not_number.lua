-- expect: bad/param_not_number\.lua:4: argument n=many: parameter n must be a number$
-- args: n=many
local hobe = require "hobe"
local n = hobe.param("n", 24)
