-- expect: bad/joint_rigid\.lua:9: a joint of kind rigid needs a body or the ground beside a beam, but "blade" and "blade" are beams; take fixed$
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.01, height = 0.02 }
local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local scene = hobe.scene{
  hobe.beam{ name = "blade", elements = 4, section = section, material = steel,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.joint{ "blade", "blade", at = {0, 1}, kind = "rigid" },
}
