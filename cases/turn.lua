-- One model of one of the four cantilevers of Fig. 7, Tang, Tian & Hu 2022, turned by a torque.
--
-- L 2 m, nu 0.3, one end clamped, warping held; a moment Mx at the other.  Sections in mm: I 215 x
-- 100, flange 15, web 10, E 210 GPa; square 100, hollow 160 x 80, wall 10, and box 250 x 50, wall 5,
-- E 1 GPa.  Expected: converged quadratic bricks, geometrically nonlinear, which torsion.lua and
-- box.lua tell more of; their last digits, .2 % or less, are uncertain.
--
-- `hobe chart cases/turn.lua beam=square` compares models.  Elements with many modes turn further,
-- since the moment acts on the slopes y and z alone.
local hobe = require "hobe"

local beams = {                                       -- E, Pa; torque, kNm; twist, rad; section
  I      = { 210e9, 10, 0.6525, hobe.I, height = 0.215, width = 0.1, flange = 0.015, web = 0.01 },
  square = { 1e9, 10, 3.700, hobe.square, side = 0.1 },
  hollow = { 1e9, 1, 0.5034, hobe.hollow, width = 0.16, height = 0.08, thickness = 0.01 },
  box    = { 1e9, 0.08103, 0.1, hobe.box, width = 0.25, height = 0.05, thickness = 0.005 },
}
local size = beams[hobe.param("beam", "I")]
local E, M, solid, make = table.unpack(size)
for i = 1, 4 do size[i] = nil end                     -- what is left says the section
local section = make(size)

hobe.chart{
  truth = { twist = solid }, doubt = 2e-3,
  ladder = {
    { element = { "BE24", "MGD30", "BE24w", "3333w", "MGD30w", "3433w", "MGD30w3" },
      elements = { 1, 2, 4, 8, 16, 32 } },
    { element = { "34X3", "BE24w-II", "MGD30w-II", "MGD30d" }, elements = { 2, 4, 8 } },
    { element = "MGD30w", elements = { 4, 8, 16 }, mechanics = { "axis", "full" } },
  },
}

local r = hobe.static(hobe.scene{
  hobe.beam{
    name = "bar", element = hobe.param("element", "MGD30w"),
    elements = hobe.param("elements", 20), section = section,
    material = { E = E, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {2, 0, 0},
    mechanics = hobe.param("mechanics", "average"),
  },
  hobe.clamp{ "bar", at = 0 },
  hobe.moment{ "bar", at = 1, value = {1e3*M, 0, 0} },
}, { steps = math.ceil(M/10) })
hobe.report{ twist = { r:twist("bar", 1), "rad", expect = solid, within = 1e-2 } }
