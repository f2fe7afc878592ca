-- expect: bad/files_then_error\.lua:9: the solver is out of coffee$
local hobe = require "hobe"
hobe.report{ u3 = 1 }
hobe.table{ columns = {"n"}, rows = {{1}}, file = "t.csv" }
hobe.plot{ file = "u3.png", series = {{ x = {1, 2}, y = {1, 3} }} }
local f = io.open("notes.txt", "w")
f:write("half a not")
f:close()
error("the solver is out of coffee")
