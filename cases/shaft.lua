-- A shaft with an unbalanced disk at rest under its weight, and its natural frequencies there.
--
-- Bauchau et al. 2016: a tube of 6 m, its disk of 70.573 kg fixed at mid-span with the centre of
-- mass 50 mm above the axis; one end keeps its place and its mean section, the other may slide and
-- turn.  Shear correction 0.5306 on every shear strain, as published.  Expected: an independent
-- prototype, whose mesh leaves 1e-4 of the sag and whose frequencies have four digits.
local hobe = require "hobe"

local m, R, t = 70.573, 0.24, 0.05
local across = m*(R^2/4 + t^2/12)
local scene = hobe.scene{
  hobe.beam{
    name = "shaft", element = "MGD30", elements = hobe.param("n", 16),
    section = hobe.tube{ outer = 0.05, inner = 0.045 },
    material = { E = 210e9, nu = 0.3, rho = 7800, k2 = 0.5306, k3 = 0.5306 },
    from = {0, 0, 0}, to = {6, 0, 0},
  },
  hobe.support{ "shaft", at = 0, kind = "rigid" },
  hobe.support{ "shaft", at = 1, kind = "cylindrical", axis = {1, 0, 0} },
  hobe.body{ name = "disk", mass = m, centre = {3, 0, 0.05}, inertia = { m*R^2/2, across, across } },
  hobe.joint{ "disk", "shaft", at = 1/2, kind = "rigid" },
  hobe.gravity{0, 0, -9.81},
}
local r = hobe.static(scene)
local modes = hobe.modal(scene, { modes = 2, state = r })
hobe.report{
  sag    = { r:displacement("shaft", 1/2)[3], "m", expect = -3.3084e-3, within = 2e-4 },
  first  = { modes:frequency(1), "rad/s", expect = 56.58, within = 2e-4 },
  second = { modes:frequency(2), "rad/s", expect = 56.87, within = 2e-4 },
}
