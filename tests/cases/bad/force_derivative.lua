-- expect: bad/force_derivative\.lua:7: force: derivative: the derivative by x must be three rows \{\{x, y, z\}, \.\.\.\}, got 2$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
local force = hobe.force{ "blade", at = 1, value = function(t, x, v) return {0, 1, x[3]} end, derivative = function() return 2 end }
hobe.static(hobe.scene{ beam, hobe.clamp{ "blade", at = 0 }, force })
