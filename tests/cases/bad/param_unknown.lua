-- expect: ^hobe: the case has no parameter "elemnt", did you mean "element"\?$
-- args: elemnt=3333
local hobe = require "hobe"
print = nil
local element, n = hobe.param("element", "MGD30w"), hobe.param("n", 24)
hobe.report{ n = n }
