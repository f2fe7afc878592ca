-- expect: bad/drive_loop\.lua:8: the script spent more than 0\.5 s in Lua itself
-- args: --time-limit 0.5
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
local support = hobe.support{ "blade", at = 0, kind = "revolute", axis = {0, 0, 1}, angle = function(t) while true do end end }
hobe.static(hobe.scene{ beam, support })
