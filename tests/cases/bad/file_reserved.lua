-- expect: bad/file_reserved\.lua:3: file "report.csv" is one that hobe itself writes$
local hobe = require "hobe"
hobe.table{ columns = {"n"}, rows = {{1}}, file = "report.csv" }
