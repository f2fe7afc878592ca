-- expect: bad/force_value_type\.lua:7: force: value must be three numbers \{x, y, z\}, got "up"$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
hobe.force{ "blade", at = 1, value = "up" }
