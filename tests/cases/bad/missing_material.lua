-- expect: bad/missing_material\.lua:4: beam: material is missing: a table \{E =, nu =, rho =\}$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
hobe.beam{ name = "blade", elements = 4, section = section, from = {0, 0, 0}, to = {1, 0, 0} }
