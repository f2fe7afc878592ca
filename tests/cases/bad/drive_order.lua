-- expect: bad/drive_order\.lua:7: support: position: points \{t, value\} must be in the order of time; 0\.5 s follows 1 s$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
hobe.support{ "blade", at = 0, kind = "prismatic", axis = {0, 0, 1}, position = {{0, 0}, {1, 0}, {0.5, 2}} }
