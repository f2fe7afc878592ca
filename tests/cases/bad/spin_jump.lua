-- expect: bad/spin_jump\.lua:9: the speed of a spin cannot jump, at t = 1 s; let it rise in a short time$
local hobe = require "hobe"
hobe.scene{
  hobe.beam{
    name = "blade", elements = 2, section = hobe.rectangle{ width = 0.1, height = 0.1 },
    material = { E = 1e9, nu = 0.3, rho = 1000 }, from = {0, 0, 0}, to = {1, 0, 0},
  },
  hobe.clamp{ "blade", at = 0 },
  hobe.spin{ axis = {0, 0, 1}, speed = 6, history = { {0, 0}, {1, 0}, {1, 1} } },
}
