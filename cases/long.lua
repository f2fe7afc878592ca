-- A long beam in bays: clamped at every twentieth element, under its weight.  Each bay is a beam
-- clamped at both ends, whose middle sags by w l^4/384 EI + w l^2/8 G A k (Timoshenko).
--
-- What counts here is size: `./hobe run cases/long.lua n=100000` has 2.3 million unknowns, and takes
-- some seconds and 1.2 GB.  The figures for one element should hardly depend on n.
local hobe = require "hobe"
local n = hobe.param("n", 2000)                                     -- elements

local per_bay, l, side = 20, 1, 0.004                               -- m
local E, nu, rho, g = 210e9, 0.3, 7850, 1e-3                        -- Pa, kg/m^3, m/s^2
local bays = n//per_bay

local items = {
  hobe.beam{
    name = "rail", element = "MGD30w", elements = per_bay*bays,
    section = hobe.square{ side = side }, material = { E = E, nu = nu, rho = rho },
    from = {0, 0, 0}, to = {l*bays, 0, 0},
  },
  hobe.gravity{0, 0, -g},
}
for i = 0, bays do
  items[#items + 1] = hobe.clamp{ "rail", at = i/bays }
end
local r = hobe.static(hobe.scene(items))

local A, I, G = side^2, side^4/12, E/(2*(1 + nu))
local w = rho*A*g                                                   -- N/m
local theory = w*l^4/(384*E*I) + w*l^2/(8*G*A*5/6)
local first, last, worst = nil, nil, 0
for i = 1, bays, math.max(1, bays//100) do
  last = -r:displacement("rail", (i - 0.5)/bays)[3]
  first = first or last
  worst = math.max(worst, math.abs(last/first - 1))
end
assert(worst < 1e-6, "bays differ by more than 1e-6")               -- they are all the same

hobe.report{
  sag = { first, "m", expect = theory, within = 1e-4 },            -- clamps hold Poisson's swelling
  largest_difference = worst,
  unknowns = r.unknowns,
  setup = { r.setup_seconds/n*1e6, "us per element" },
  solve = { r.solve_seconds/n*1e6, "us per element" },
}
