-- expect: bad/report_within_alone\.lua:3: report: u3 has within but no expect$
local hobe = require "hobe"
hobe.report{ u3 = { 1.5, "m", within = 1e-3 } }
