-- expect: bad/body_clamped\.lua:9: "disk" is a body; a beam is needed here$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.clamp{ "disk", at = 1 },
  hobe.body{ name = "disk", mass = 1, inertia = {1, 1, 1.5}, centre = {1, 0, 0} },
}
