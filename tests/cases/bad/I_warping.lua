-- expect: bad/I_warping\.lua:3: I: warping = "paper" \(eq\. 34\) is for equal flanges, got 0\.1 x 0\.01 and 0\.05 x 0\.01 m; use "solved"$
local hobe = require "hobe"
local section = hobe.I{ height = 0.2, width = 0.1, top_width = 0.05, flange = 0.01, web = 0.01, warping = "paper" }
print(section.J)
