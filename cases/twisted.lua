-- A cantilever pretwisted by a right angle, under unit loads at its tip.
--
-- MacNeal & Harder 1985, "A proposed standard set of problems to test finite element accuracy", the
-- twisted beam (there in inches and pounds): its width stands along y at the clamp and along z at
-- the tip.  Expected numbers: theirs, of beam theory; this mesh, whose own error is 1e-5, differs
-- from them by 0.1 and 0.3 %.
local hobe = require "hobe"

local function tip(load)
  local scene = hobe.scene{
    hobe.beam{
      name = "beam", element = hobe.param("element", "MGD30w"), elements = hobe.param("n", 16),
      section = hobe.rectangle{ width = 1.1, height = 0.32 },
      material = { E = 29e6, nu = 0.22 },
      from = {0, 0, 0}, to = {12, 0, 0}, twist = math.pi/2,
    },
    hobe.clamp{ "beam", at = 0 },
    hobe.force{ "beam", at = 1, value = load },
  }
  return hobe.static(scene):displacement("beam", 1)
end

hobe.report{
  along_width     = { tip{0, 0, 1}[3], "m", expect = 5.424e-3, within = 5e-3 },
  along_thickness = { tip{0, 1, 0}[2], "m", expect = 1.754e-3, within = 5e-3 },
}
