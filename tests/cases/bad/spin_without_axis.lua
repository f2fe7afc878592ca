-- expect: bad/spin_without_axis\.lua:9: the axis of a spin must be a direction \{x, y, z\}, got \{0, 0, 0\}$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{
    name = "blade", elements = 2, section = hobe.rectangle{ width = 0.1, height = 0.1 },
    material = { E = 1e9, nu = 0.3, rho = 1000 }, from = {0, 0, 0}, to = {1, 0, 0},
  },
  hobe.clamp{ "blade", at = 0 },
  hobe.spin{ axis = {0, 0, 0}, speed = 6 },
}
