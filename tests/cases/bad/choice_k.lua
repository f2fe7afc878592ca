-- expect: bad/choice_k\.lua:3: beam: material.k must be one of "point", "average", got "mean"$
local hobe = require "hobe"
local beam = hobe.beam{ name = "b", elements = 1, section = hobe.square{side = 0.1}, from = {0, 0, 0}, to = {1, 0, 0},
  material = {E = 210e9, nu = 0.3, k2 = 5/6, k3 = 5/6, k = "mean"} }
