-- expect: bad/dynamic_start\.lua:7: dynamic: start must be "equilibrium" or a result, got "rest"$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local blade = hobe.beam{ name = "blade", elements = 2, section = section, material = steel,
                         from = {0, 0, 0}, to = {1, 0, 0} }
hobe.dynamic(hobe.scene{ blade }, { to = 1, step = 1e-3, start = "rest" })
