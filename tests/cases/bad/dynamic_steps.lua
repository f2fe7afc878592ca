-- expect: bad/dynamic_steps\.lua:7: a motion needs step \(s\), or accuracy, relative to the scene's size, that chooses the steps$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local blade = hobe.beam{ name = "blade", elements = 2, section = section, material = steel,
                         from = {0, 0, 0}, to = {1, 0, 0} }
hobe.dynamic(hobe.scene{ blade }, { to = 1 })
