-- A gallery of sections and their functions: w of torsion, wy and wz of bending shear.
--
-- Pictures: gallery_w.png, gallery_wy.png and gallery_wz.png with the functions in colours, and
-- gallery.png, in which w is drawn as what it is: the warping of the end of a twisted beam.
local hobe = require "hobe"

local thin = { height = 0.2, width = 0.1, flange = 0.012, web = 0.012 }
local sections = {
  { hobe.rectangle{ width = 0.06, height = 0.12 }, "rectangle 60 × 120" },
  { hobe.square{ side = 0.1 }, "square 100" },
  { hobe.I{ height = 0.215, width = 0.1, flange = 0.015, web = 0.01 }, "I 215 × 100" },
  { hobe.channel(thin), "channel 200 × 100" },
  { hobe.T(thin), "T 200 × 100" },
  { hobe.angle(thin), "angle 200 × 100" },
  { hobe.hollow{ width = 0.16, height = 0.08, thickness = 0.01 }, "hollow 160 × 80" },
  { hobe.box{ width = 0.25, height = 0.05, thickness = 0.005 }, "thin box 250 × 50" },
  { hobe.tube{ outer = 0.05, inner = 0.04 }, "tube 100 × 10" },
  { hobe.polygon{ {0, 0}, {0.1, 0}, {0.16, 0.06}, {0.16, 0.12}, {0.05, 0.12}, {0, 0.07},
                  holes = { { {0.025, 0.025}, {0.075, 0.02}, {0.06, 0.06}, {0.03, 0.065} },
                            { {0.1, 0.06}, {0.135, 0.07}, {0.13, 0.1}, {0.09, 0.095} } } },
    "polygon with holes" },
}

hobe.picture{
  file = "gallery.png", title = "Sections warp: w, as the end of a twisted beam shows it",
  sections = sections, relief = true, columns = 5,
}
for field, what in pairs{ w = "Warping in torsion, w", wy = "Bending shear along y, wy",
                          wz = "Bending shear along z, wz" } do
  hobe.picture{
    file = "gallery_" .. field .. ".png", title = what, sections = sections, field = field,
    columns = 5,
  }
end
