-- expect: bad/damping_structural\.lua:6: beam "blade" cannot have damping\.stiffness: element 3333s has a structural law, and no viscous stress; use damping\.mass, or another element$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0}, element = "3333s", damping = { stiffness = 1e-5 } },
  hobe.clamp{ "blade", at = 0 },
}
local r = hobe.static(scene)
