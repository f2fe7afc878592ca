-- expect: bad/drive_rigid\.lua:7: the angle of a joint of kind rigid cannot be driven; that of kind fixed can$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
local support = hobe.support{ "blade", at = 0, kind = "rigid", axis = {0, 0, 1}, angle = 1 }
hobe.scene{ beam, support }
