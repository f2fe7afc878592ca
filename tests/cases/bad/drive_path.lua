-- expect: bad/drive_path\.lua:7: a path follows loads and cannot follow a driven joint; use hobe\.static with method = "newton"$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
local support = hobe.support{ "blade", at = 0, kind = "revolute", axis = {0, 0, 1}, angle = 1 }
hobe.path(hobe.scene{ beam, support, hobe.force{ "blade", at = 1, value = {0, 0, 1} } })
