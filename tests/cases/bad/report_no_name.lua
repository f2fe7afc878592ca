-- expect: bad/report_no_name\.lua:3: report: values have names, report\{u3 = 1.5\}$
local hobe = require "hobe"
hobe.report{ 1.5 }
