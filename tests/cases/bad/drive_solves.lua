-- expect: bad/drive_solves\.lua:8: support: angle: .*static: a function that a solver calls cannot solve$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local beam = hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
                        from = {0, 0, 0}, to = {1, 0, 0} }
local scene
local support = hobe.support{ "blade", at = 0, kind = "revolute", axis = {0, 0, 1}, angle = function(t) hobe.static(scene) return t end }
scene = hobe.scene{ beam, support }
hobe.static(scene)
