-- expect: bad/table_row_long\.lua:3: table: rows\[1\] must be a list of at most 2 cells, got a table$
local hobe = require "hobe"
hobe.table{ columns = {"n", "u3"}, rows = {{1, 2, 3}} }
