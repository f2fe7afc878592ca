-- Atlas of failures: round-off.  The same beam far from the origin, under tiny loads, slender, and
-- in other units, to how many digits it stays the same.
--
-- Reference: a steel cantilever, askew, 1 m, 20 x 30 mm, 10 of MGD30w, bent by 500 N; its
-- displacement and its first four frequencies.  Invariants of absolute positions would lose all
-- digits of strain at a kilometre from the origin; displacements from the reference, positions
-- relative to an element's first node and scaled equations lose few.  What is left far out is that
-- of the input: between two numbers of 3e8 a length of 1 is known to 6e-8 only.
local hobe = require "hobe"

-- A cantilever, its units of length, mass and time in m, kg and s, and its place in those units.
local function cantilever(how)
  local m, kg, s = how.m or 1, how.kg or 1, how.s or 1
  local L = (how.L or 1)/m
  local N, Pa = kg*m/s^2, kg/m/s^2
  local x = (how.at or 0)/3/m                          -- a third: rounded, as ends then are
  local F = (how.F or 1)*500/N/(how.L or 1)^2          -- bends alike whatever the length
  return hobe.scene{
    hobe.beam{ name = "beam", element = "MGD30w", elements = 10,
               section = hobe.rectangle{ width = 0.02/m, height = 0.03/m },
               material = { E = 210e9/Pa, nu = 0.3, rho = 7850/(kg/m^3) },
               from = {x, x, x}, to = {x + 0.48*L, x + 0.64*L, x + 0.6*L} },
    hobe.clamp{ "beam", at = 0 },
    hobe.force{ "beam", at = 1, value = {0.8*F, -0.6*F, 0} },
  }, m, s
end

-- u, m, over the load, and frequencies, rad/s.
local function answers(how)
  local scene, m, s = cantilever(how)
  local r = hobe.static(scene)
  local u, w = r:displacement("beam", 1), hobe.modal(scene, { modes = 4 }):frequencies()
  for a = 1, 3 do u[a] = u[a]*m end
  for i = 1, 4 do w[i] = w[i]/s end
  return u, w, r.change
end

local function digits(a, b)                            -- how many both have in common
  local difference, size = 0, 0
  for i = 1, #a do
    difference = math.max(difference, math.abs(a[i] - b[i]))
    size = math.max(size, math.abs(b[i]))
  end
  return difference > 0 and -math.log(difference/size, 10) or 16
end

local function scaled(u, factor) return { factor*u[1], factor*u[2], factor*u[3] } end

local u0, w0 = answers{}
local tiny = answers{ F = 1e-9 }                       -- linear from here on down, to 1e-10
local slim = answers{ L = 100, F = 1e-4 }              -- m: L/h 3e3 to 5e3; linear
-- Digits of a beam of length 1 and far out whose ends are rounded: u goes with L^3, and either end
-- is off by half a place, of the binary digits that coordinates have there.
local function input(at) return -math.log(3*2*2^-53*at/3, 10) end
-- What is different, what displacements should be, and how many digits of them should stay; of
-- other units 12, those that a stiffness with the condition of bending, n^4 elements, leaves.
local ways = {
  { "1 km from the origin /3", u0, input(1e3), at = 1e3 },
  { "1000 km/3", u0, input(1e6), at = 1e6 }, { "1e6 km/3", u0, input(1e9), at = 1e9 },
  { "load 1e-12, strain 1e-15", scaled(tiny, 1e-3), 9, F = 1e-12 },
  { "load 1e-15, strain 1e-18", scaled(tiny, 1e-6), 9, F = 1e-15 },
  { "mm, N, t", u0, 12, m = 1e-3, kg = 1e3 }, { "mm, kN, kg, ms", u0, 12, m = 1e-3, s = 1e-3 },
  { "um, ug, us", u0, 12, m = 1e-6, kg = 1e-9, s = 1e-6 },
  { "km, Gg, h", u0, 12, m = 1e3, kg = 1e6, s = 3600 },
  { "100 m long in km", slim, 9, L = 100, F = 1e-4, m = 1e3 },
  { "100 m long at 1000 km/3", slim, 8, L = 100, F = 1e-4, at = 1e6 },
}

local rows, x, y, report = {}, {}, {}, {}
for i, way in ipairs(ways) do
  local u, w, change = answers(way)
  local of_u = digits(u, way[2])
  local of_w = not way.L and digits(w, w0) or nil
  rows[i] = { way[1], of_u, of_w, change }
  local short = math.max(way[3] - math.min(of_u, (of_w or 16) + 2), 0)
  report[string.format("short_%02d", i)] = { short, "digits", expect = 0 }
end
hobe.table{
  title = "Digits that stay the same", rows = rows, file = "roundoff.csv",
  columns = { "", "of displacements", "of frequencies", "change" },
}

-- Over the distance from the origin, beside the digits that positions there have of a metre.
local positions = {}
for k = 0, 12 do
  x[k + 1], y[k + 1] = 10^k, digits(answers{ at = 10^k }, u0)
  positions[k + 1] = 15.95 - k
end
hobe.plot{
  file = "roundoff.png", title = "A beam of 1 m far from the origin",
  xlabel = "distance, m", ylabel = "digits that stay", xlog = true,
  series = { { x = x, y = y, label = "of displacements", style = "linespoints" },
             { x = x, y = positions, label = "of positions to a metre" } },
}
hobe.report(report)
