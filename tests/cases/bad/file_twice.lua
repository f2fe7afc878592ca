-- expect: bad/file_twice\.lua:4: file "t.csv" is written twice in this run$
local hobe = require "hobe"
hobe.table{ columns = {"n"}, rows = {{1}}, file = "t.csv" }
hobe.table{ columns = {"m"}, rows = {{1}}, file = "t.csv" }
