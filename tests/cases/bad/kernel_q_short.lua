-- expect: bad/kernel_q_short\.lua:6: force: q must be a list of 39 numbers \(see :dofs\(\)\), got a table with 3$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local k = hobe.kernel{ section = section, material = steel, length = 1 }
k:force{1, 2, 3}
