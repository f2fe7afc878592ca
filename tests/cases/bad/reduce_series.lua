-- expect: reduce_series\.lua:14: method = "series" is for whole models
local hobe = require "hobe"
local function scene(length, element)
  return hobe.scene{
    hobe.beam{
      name = "beam", element = element or "MGD30", elements = 2,
      section = hobe.rectangle{ width = 0.1, height = 0.1 },
      material = { E = 1e9, nu = 0.3, rho = 1000 }, from = {0, 0, 0}, to = {length, 0, 0},
    },
    hobe.clamp{ "beam", at = 0 },
    hobe.force{ "beam", at = 1, value = {0, 0, 10} },
  }
end
hobe.static(hobe.reduce(scene(1), { modes = 2 }), { method = "series" })
