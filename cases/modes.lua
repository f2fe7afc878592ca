-- Mode shapes of an I-beam as pictures: Fig. 9 of Tang, Tian & Hu 2022.
--
-- Beam (a) of Fig. 7, clamped at one end: L 2 m; I-section 215 x 100 x 15 x 10 mm; E 210 GPa, nu
-- 0.3, rho 7850 kg/m^3.  cases/table8.lua has the frequencies of all beams of Fig. 7.
--
-- fig9.png, like Fig. 9, shows modes of a single element MGD30w-II: in the first row sections stay
-- plane but for the warping of torsion; in the others they do what only an element with many
-- section modes can.  The paper prints no frequencies with its figure, and its elastic law (`axis`)
-- is indefinite there: the numbers of modes differ, their kinds do not.
--
-- modes.png shows the first modes of a fine mesh.  Expected are three of them from a converged
-- model of quadratic bricks with a clamped face.  Its section is free to bend in its own plane,
-- which a beam's is not: in torsion it is 1.5 % softer.
--
-- Long: not run under the sanitizers, where the pictures take a minute.
local hobe = require "hobe"

local n = hobe.param("n", 20)

local function modes(element, elements, count)
  local scene = hobe.scene{
    hobe.beam{
      name = "bar", element = element, elements = elements,
      section = hobe.I{ height = 0.215, width = 0.1, flange = 0.015, web = 0.01 },
      material = { E = 210e9, nu = 0.3, rho = 7850 },
      from = {0, 0, 0}, to = {2, 0, 0},
    },
    hobe.clamp{ "bar", at = 0 },
  }
  return hobe.modal(scene, { modes = count })
end

local one = modes("MGD30w-II", 1, 66)
local drawings = {}
for k, i in ipairs{ 1, 2, 3, 7, 8, 13, 17, 19, 24, 25, 30, 35 } do
  drawings[k] = { one, i, string.format("%d: %.4g rad/s", i, one:frequency(i)) }
end
hobe.picture{
  file = "fig9.png", title = "Modes of one element MGD30w-II on the I-section",
  modes = drawings, columns = 4,
}

local m = modes("MGD30w3", n, 12)
drawings = {}
for i = 1, 12 do
  drawings[i] = { m, i, string.format("%.4g rad/s", m:frequency(i)) }
end
hobe.picture{
  file = "modes.png", title = string.format("An I-beam vibrates: %d elements MGD30w3", n),
  modes = drawings, columns = 4,
}

hobe.report{
  weak_bending   = { m:frequency(1), "rad/s", expect = 103.445, within = 1e-3 },
  torsion        = { m:frequency(2), "rad/s", expect = 282.3,   within = 1.6e-2 },
  strong_bending = { m:frequency(3), "rad/s", expect = 377.24,  within = 2e-3 },
}
