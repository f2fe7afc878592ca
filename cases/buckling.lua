-- Critical loads of a column and of beams that tip over, beside classical theory.
--
-- Column: a cantilever 1 m long, 10 x 20 mm: Euler's pi^2 EI/(4 L^2) about both axes.
-- Blade: a cantilever 2 m long, 5 x 80 mm, under a force at the centroid of its tip: Prandtl's
-- (1899) 4.0126 sqrt(EIz GJ)/L^2, with the length less sqrt(EIw/GJ), by which the clamp's hold on
-- warping shortens it.
-- I: a cantilever 4 m long, 200 x 100 x 10 x 6 mm, under a moment at its end about the strong axis:
-- pi/(2 L) sqrt(EIz (GJ + EIw (pi/(2 L))^2)).  Theory leaves out shear and what bending before
-- buckling changes, which linear buckling leaves out, too.
local hobe = require "hobe"

local n, element = hobe.param("n", 32), hobe.param("element", "MGD30w")
local E, nu = 70e9, 0.3

local function first(length, section, load)
  local scene = hobe.scene{
    hobe.beam{ name = "beam", element = element, elements = n, section = section,
               material = { E = E, nu = nu }, from = {0, 0, 0}, to = {length, 0, 0} },
    hobe.clamp{ "beam", at = 0 },
    load,
  }
  return hobe.buckling(scene, { modes = 2 })
end

local bar = hobe.rectangle{ width = 0.01, height = 0.02 }
local column = first(1, bar, hobe.force{ "beam", at = 1, value = {-1, 0, 0} })
local euler = math.pi^2*E/4

local blade = hobe.rectangle{ width = 0.005, height = 0.08 }
local L, GJ = 2, E/(2*(1 + nu))*blade.J
local tips = first(L, blade, hobe.force{ "beam", at = 1, value = {0, 0, -1} })
local prandtl = 4.0126*math.sqrt(E*blade.Izz*GJ)/(L - math.sqrt(E*blade.Iw/GJ))^2

local I = hobe.I{ height = 0.2, width = 0.1, flange = 0.01, web = 0.006 }
local k, GJ_I = math.pi/(2*4), E/(2*(1 + nu))*I.J
local turns = first(4, I, hobe.moment{ "beam", at = 1, value = {0, 1, 0} })

hobe.picture{
  file = "buckling.png", title = "Critical shapes", columns = 2,
  modes = {
    { column, 1, string.format("column: %.4g N", column:factor(1)) },
    { column, 2, string.format("column: %.4g N", column:factor(2)) },
    { tips, 1, string.format("blade: %.4g N", tips:factor(1)) },
    { turns, 1, string.format("I: %.4g N m", turns:factor(1)) },
  },
}
hobe.report{
  column_weak   = { column:factor(1), "N", expect = euler*bar.Izz, within = 1e-3 },
  column_strong = { column:factor(2), "N", expect = euler*bar.Iyy, within = 1e-3 },
  blade         = { tips:factor(1), "N", expect = prandtl, within = 1e-2 },
  I             = { turns:factor(1), "N m", within = 5e-3,
                    expect = k*math.sqrt(E*I.Izz*(GJ_I + E*I.Iw*k^2)) },
}
