-- expect: bad/table_outside\.lua:3: .*inside the output folder.*got "../t.csv"$
local hobe = require "hobe"
hobe.table{ columns = {"n"}, rows = {{1}}, file = "../t.csv" }
