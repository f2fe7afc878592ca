-- expect: bad/kernel_q_nan\.lua:8: tangent: q\[5\] must be a finite number, got nan$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local k = hobe.kernel{ section = section, material = steel, length = 1 }
local q = k:reference()
q[5] = 0/0
k:tangent(q)
