-- expect: bad/composite_beam_material\.lua:7: beam: a composite section brings its materials; leave material out$
local hobe = require "hobe"
local half = hobe.rectangle{ width = 0.01, height = 0.01 }
local steel, brass = { E = 210e9, nu = 0.3 }, { E = 100e9, nu = 0.35 }
local section = hobe.composite{ { section = half, at = {0, 0.005}, material = steel },
                                { section = half, at = {0, -0.005}, material = brass } }
hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
           from = {0, 0, 0}, to = {1, 0, 0} }
