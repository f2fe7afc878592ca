-- expect: bad/force_function\.lua:7: force: value: the force at t = 0\.0 must be three numbers \{x, y, z\}, got a table with 2$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
local force = hobe.force{ "blade", at = 1, value = function(t, x, v) return {0, 1} end }
hobe.static(hobe.scene{ beam, hobe.clamp{ "blade", at = 0 }, force })
