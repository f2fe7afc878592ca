-- expect: bad/kernel_length\.lua:5: kernel: length must be > 0, got -1$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local k = hobe.kernel{ section = section, material = steel, length = -1 }
