-- expect: bad/report_key\.lua:3: report: u3: unknown key "expected", did you mean "expect"\?
local hobe = require "hobe"
hobe.report{ u3 = { 1.5, "m", expected = 1 } }
