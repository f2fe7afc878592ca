-- expect: bad/drive_point\.lua:7: support: velocity\[2\] must be two numbers \{a, b\}, got a table with 1$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
hobe.support{ "blade", at = 0, kind = "prismatic", axis = {0, 0, 1}, velocity = {{0, 0}, {1}} }
