-- expect: bad/body_redundant\.lua:10: the joint "second" of body "disk" stops motions that clamps or joints before it stop already; leave it out, or choose a kind that stops less$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.joint{ "blade", "disk", at = 1, kind = "fixed" },
  hobe.joint{ "blade", "disk", at = 1, kind = "spherical", name = "second" },
  hobe.body{ name = "disk", mass = 1, inertia = {1, 1, 1.5}, centre = {1, 0, 0} },
}
