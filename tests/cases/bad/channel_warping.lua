-- expect: bad/channel_warping\.lua:3: channel: unknown key "warping"
local hobe = require "hobe"
local section = hobe.channel{ height = 0.2, width = 0.1, flange = 0.01, web = 0.01, warping = "paper" }
print(section.J)
