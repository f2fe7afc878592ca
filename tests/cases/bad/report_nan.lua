-- expect: bad/report_nan\.lua:3: report: u3 must be a finite number, got nan$
local hobe = require "hobe"
hobe.report{ u3 = 0/0 }
