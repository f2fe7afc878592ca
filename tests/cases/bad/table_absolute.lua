-- expect: bad/table_absolute\.lua:3: .*inside the output folder.*got "/tmp/t.csv"$
local hobe = require "hobe"
hobe.table{ columns = {"n"}, rows = {{1}}, file = "/tmp/t.csv" }
