-- expect: bad/table_nan\.lua:3: table: rows\[1\]\[2\] must be a finite number, got nan$
local hobe = require "hobe"
hobe.table{ columns = {"n", "u3"}, rows = {{1, 0/0}} }
