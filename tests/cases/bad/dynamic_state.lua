-- expect: bad/dynamic_state\.lua:8: state: the state must be from 1 to 3, got 4$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local blade = hobe.beam{ name = "blade", elements = 2, section = section, material = steel,
                         from = {0, 0, 0}, to = {1, 0, 0} }
local motion = hobe.dynamic(hobe.scene{ blade }, { to = 2e-3, step = 1e-3 })
motion:state(4)
