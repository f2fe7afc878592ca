-- expect: bad/resultants_between\.lua:9: nodal forces give resultants at the ends of elements, multiples of 1/2 of the length of beam "blade", got 0\.3$
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 2, section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
}
local r = hobe.static(scene)
r:resultants("blade", 0.3, "forces")
