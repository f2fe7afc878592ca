-- Sections beyond the rectangle: properties with a solved warping function, beside thin-wall theory.
--
-- Outlines: Tang, Tian & Hu 2022, Fig. 7 (I-section, hollow rectangle, thin box; dimensions
-- recovered from the paper's numbers), a channel, a T and an angle with walls of 4 mm.  Expected J
-- of Fig. 7 and the Wagner constant: an independent finite element solution on other meshes.
-- Thin-wall theory (Bredt for closed walls, sum of b t^3/3 for open ones, Vlasov for Iw and shear
-- centres) takes walls for lines: a few percent off where they are thick.  Shear factors ky, kz are
-- those of the shear's energy without Poisson's coupling: 6/7 of a circle, 1/2 of a thin tube.
-- A cantilever that is free to warp everywhere twists by M L/(G J) under an end moment: GJ_* is the
-- moment over the twist, from the beam alone, over G times the section's J; both hold the same w.
local hobe = require "hobe"

local I = hobe.I{ height = 0.215, width = 0.1, flange = 0.015, web = 0.01 }
local hollow = hobe.hollow{ width = 0.16, height = 0.08, thickness = 0.01 }
local box = hobe.box{ width = 0.25, height = 0.05, thickness = 0.005 }
local thin = { height = 0.2, width = 0.08, flange = 0.004, web = 0.004 }
local channel, T, angle = hobe.channel(thin), hobe.T(thin), hobe.angle(thin)
local circle, tube = hobe.circle{ radius = 0.05 }, hobe.tube{ outer = 0.05, inner = 0.045 }

local function row(name, s)
  return { name, s.A, s.Iyy, s.Izz, s.Iyz, s.J, s.Iw, s.ys, s.zs, s.Wagner, s.ky, s.kz }
end
hobe.table{
  title = "Sections, about their centroids, m",
  columns = { "", "A", "Iyy", "Izz", "Iyz", "J", "Iw", "ys", "zs", "Wagner", "ky", "kz" },
  rows = {
    row("I 215 x 100 x 15 x 10", I), row("hollow 160 x 80 x 10", hollow),
    row("box 250 x 50 x 5", box), row("channel 200 x 80 x 4", channel), row("T 200 x 80 x 4", T),
    row("angle 200 x 80 x 4", angle), row("circle 50", circle), row("tube 50 / 45", tube),
  },
}

local function bredt(W, H, t)                          -- middle lines W - t, H - t
  return 2 * t * (W - t)^2 * (H - t)^2 / (W + H - 2*t)
end
local h, b, t = 0.196, 0.078, 0.004                    -- middle lines of the thin walls
hobe.table{
  title = "Beside thin-wall theory",
  columns = { "", "solved", "thin walls", "ratio" },
  rows = (function()
    local rows = {}
    local function add(name, solved, thin_wall)
      rows[#rows + 1] = { name, solved, thin_wall, solved / thin_wall }
    end
    add("J of the I, m^4", I.J, (2 * 0.1 * 0.015^3 + 0.2 * 0.01^3) / 3)
    add("Iw of the I, m^6", I.Iw, 0.1^3 * 0.015 * 0.2^2 / 24)
    add("J of the hollow, m^4", hollow.J, bredt(0.16, 0.08, 0.01))
    add("J of the box, m^4", box.J, bredt(0.25, 0.05, 0.005))
    add("J of the channel, m^4", channel.J, (h + 2*b) * t^3 / 3)
    add("Iw of the channel, m^6", channel.Iw, t * b^3 * h^2 / 12 * (3*b + 2*h) / (6*b + h))
    add("shear centre of the channel, m", channel.yc + channel.ys - t/2, -3 * b^2 / (6*b + h))
    add("shear centre of the T, m", T.zc + T.zs, 0.1 - t/2)
    return rows
  end)(),
}

-- The paper's closed forms are too stiff by J_w/J.
local function closed(make, sizes)
  sizes.warping = "paper"
  local s = make(sizes)
  return s.J_w / s.J
end
local function twisted(section)
  local E, nu, L, M = 210e9, 0.3, 1, 1                 -- Pa, m, N m: a small angle
  local r = hobe.static(hobe.scene{
    hobe.beam{
      name = "shaft", element = "MGD30w", elements = 4, section = section,
      material = { E = E, nu = nu }, from = {0, 0, 0}, to = {L, 0, 0},
    },
    hobe.clamp{ "shaft", at = 0, warping = "free" },
    hobe.moment{ "shaft", at = 1, value = {M, 0, 0} },
  })
  return M * L / r:twist("shaft", 1) / (E / (2 * (1 + nu)) * section.J)
end

hobe.report{
  GJ_I      = { twisted(I),      expect = 1, within = 1e-6 },
  GJ_hollow = { twisted(hollow), expect = 1, within = 1e-6 },
  GJ_box    = { twisted(box),    expect = 1, within = 1e-6 },
  J_I      = { I.J,      "m^4", expect = 2.7715e-7,  within = 3e-3 },
  J_hollow = { hollow.J, "m^4", expect = 1.05066e-5, within = 3e-3 },
  J_box    = { box.J,    "m^4", expect = 4.272e-6,   within = 3e-3 },
  Iw_I     = { I.Iw,     "m^6", expect = 2.5e-8,     within = 5e-3 },
  Wagner_I = { I.Wagner, "m^6", expect = 8.904e-8,   within = 1e-4 },
  J_circle = { circle.J, "m^4", expect = math.pi * 0.05^4 / 2, within = 1e-12 },
  ky_circle = { circle.ky, expect = 6/7, within = 1e-12 },
  shear_centre_channel = { channel.yc + channel.ys - t/2, "m",
                           expect = -3 * b^2 / (6*b + h), within = 1e-2 },
  eq34_I      = { closed(hobe.I, { height = 0.215, width = 0.1, flange = 0.015, web = 0.01 }) },
  eq36_hollow = { closed(hobe.hollow, { width = 0.16, height = 0.08, thickness = 0.01 }),
                  expect = 1.24, within = 5e-3 },
  eq36_box    = { closed(hobe.box, { width = 0.25, height = 0.05, thickness = 0.005 }),
                  expect = 1.16, within = 5e-3 },
}
