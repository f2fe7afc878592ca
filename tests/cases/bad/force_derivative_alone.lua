-- expect: bad/force_derivative_alone\.lua:7: force: only a value that is a function has a derivative$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
hobe.force{ "blade", at = 1, value = {0, 1, 0}, derivative = function() return 2 end }
