-- Sections from files: an airfoil from a list of points and a slotted profile from a drawing.
--
-- naca0012.dat: points of the NACA 0012 (Abbott & von Doenhoff, Theory of Wing Sections, eq. 6.2) in
-- Selig's format.  slotted.dxf: a drawing in millimetres with arcs at the corners.  Expected: the
-- same points by their formula here, and integrals of the curve itself, of which chords cut off 0.1 %
-- of the area and 0.3 % of Iyy; the profile as a polygon with quarters and a whole of a circle.  J
-- of the airfoil: Roark's formula for slender solid sections, good to some percent.
local hobe = require "hobe"

-- ---- the airfoil ----------------------------------------------------------------------------------

local chord = 0.5
local wing = hobe.outline{ file = "naca0012.dat", scale = chord }

local function half(y)                                   -- half the thickness of a chord of 1
  return 0.6 * (0.2969 * y^0.5 - 0.1260 * y - 0.3516 * y^2 + 0.2843 * y^3 - 0.1015 * y^4)
end

-- Integrals over a polygon, about the origin: area, int y, int z, int y^2, int z^2.
local function polygon(p)
  local A, Sy, Sz, Syy, Szz = 0, 0, 0, 0, 0
  for i, a in ipairs(p) do
    local b = p[i % #p + 1]
    local c = (a[1] * b[2] - b[1] * a[2]) / 2
    A, Sy, Sz = A + c, Sy + c * (a[1] + b[1]) / 3, Sz + c * (a[2] + b[2]) / 3
    Syy = Syy + c * (a[1]^2 + a[1] * b[1] + b[1]^2) / 6
    Szz = Szz + c * (a[2]^2 + a[2] * b[2] + b[2]^2) / 6
  end
  return A, Sy, Sz, Syy, Szz
end

local points = {}
for i = 40, -40, -1 do
  local y = (1 - math.cos(math.pi * math.abs(i) / 40)) / 2
  local z = half(y) * (i < 0 and -1 or 1)
  points[#points + 1] = { chord * tonumber(("%.6f"):format(y)),
                          chord * tonumber(("%.6f"):format(z)) }
end
local A, Sy, Sz, Syy, Szz = polygon(points)

-- Simpson's rule for int f(y) dy over the chord, in s = sqrt y, of which everything is a polynomial.
local function integral(f)
  local n, sum = 200, 0
  for i = 0, n do
    local s = i / n
    sum = sum + (i % n == 0 and 1 or i % 2 == 1 and 4 or 2) * f(s^2) * 2 * s
  end
  return sum / (3 * n)
end
local curve = { A = integral(function(y) return 2 * half(y) end) * chord^2 }
curve.yc = integral(function(y) return 2 * y * half(y) end) * chord^3 / curve.A
curve.Iyy = integral(function(y) return 2 / 3 * half(y)^3 end) * chord^4
curve.Izz = integral(function(y) return 2 * y^2 * half(y) end) * chord^4 - curve.A * curve.yc^2
local roark = 4 * wing.Iyy / (1 + 16 * wing.Iyy / (wing.A * chord^2))

hobe.table{
  title = "NACA 0012, chord 0.5 m",
  columns = { "", "section", "polygon", "curve" },
  rows = {
    { "A, m^2", wing.A, A, curve.A },
    { "centroid from the nose, m", wing.yc, Sy / A, curve.yc },
    { "Iyy, m^4", wing.Iyy, Szz - Sz^2 / A, curve.Iyy },
    { "Izz, m^4", wing.Izz, Syy - Sy^2 / A, curve.Izz },
    { "J, m^4 (Roark's formula)", wing.J, nil, roark },
    { "shear centre from the nose, m", wing.yc + wing.ys },
  },
}

-- ---- the slotted profile --------------------------------------------------------------------------

local slotted = hobe.outline{ file = "slotted.dxf" }
local mm = 1e-3
local a, r, R = 10 * mm, 1.5 * mm, 2.1 * mm              -- half the side, corners, hole

-- A slot, of which there is one on each side: opening, room for the nut, tapered bottom.
local slot = {}
for i, p in ipairs{ {3, 10}, {-3, 10}, {-3, 8.2}, {-5.5, 8.2}, {-5.5, 6.5}, {-3, 4}, {3, 4},
                    {5.5, 6.5}, {5.5, 8.2}, {3, 8.2} } do
  slot[i] = { p[1] * mm, p[2] * mm }
end
local slot_A, _, _, slot_yy, slot_zz = polygon(slot)
-- What a corner lacks: a square of r without a quarter of a circle, about the middle of the profile.
local h = a - r
local quarter_zz = math.pi * r^4 / 16 + 2 * h * r^3 / 3 + h^2 * math.pi * r^2 / 4
local corner_A, corner_zz = (1 - math.pi / 4) * r^2, r * (a^3 - h^3) / 3 - quarter_zz
local shapes = {
  A = 4 * a^2 - 4 * slot_A - 4 * corner_A - math.pi * R^2,
  I = 4 / 3 * a^4 - 2 * slot_yy - 2 * slot_zz - 4 * corner_zz - math.pi * R^4 / 4,
}

hobe.table{
  title = "Slotted profile 20 x 20 mm",
  columns = { "", "section", "shapes" },
  rows = {
    { "A, m^2", slotted.A, shapes.A },
    { "Iyy, m^4", slotted.Iyy, shapes.I },
    { "Izz, m^4", slotted.Izz, shapes.I },
    { "J, m^4", slotted.J },
    { "Iw, m^6", slotted.Iw },
  },
}
print(wing.text)
print(slotted.text)

hobe.report{
  wing_A   = { wing.A,   "m^2", expect = A,                within = 1e-12 },
  wing_yc  = { wing.yc,  "m",   expect = Sy / A,           within = 1e-12 },
  wing_Iyy = { wing.Iyy, "m^4", expect = Szz - Sz^2 / A,   within = 1e-10 },
  wing_Izz = { wing.Izz, "m^4", expect = Syy - Sy^2 / A,   within = 1e-10 },
  wing_curve_A   = { wing.A,   "m^2", expect = curve.A,   within = 2e-3 },
  wing_curve_Iyy = { wing.Iyy, "m^4", expect = curve.Iyy, within = 4e-3 },
  wing_J   = { wing.J,   "m^4", expect = roark, within = 3e-2 },
  slotted_A   = { slotted.A,   "m^2", expect = shapes.A, within = 1e-12 },
  slotted_Iyy = { slotted.Iyy, "m^4", expect = shapes.I, within = 1e-5 },
  slotted_Izz = { slotted.Izz, "m^4", expect = shapes.I, within = 1e-5 },
  slotted_shear_centre = { slotted.ys, "m", expect = 0, within = 1e-8 },
}
