-- Stress inside a rectangular bar beside the closed forms.
--
-- Torsion: the greatest shear stress of Saint-Venant's solution is T/(k a^2 b), a <= b the sides,
-- with k as printed by Timoshenko & Goodier, Theory of Elasticity, 3rd ed. 1970, art. 109.
-- Bending and shear of a cantilever by a force V at its end: M h/(2 I) at the edge, and in the
-- middle of the height Zhuravskii's 1.5 V/A.
--
-- Section forces at the clamp are those of the nodes: they balance the load exactly.
local hobe = require "hobe"

local n = hobe.param("n", 16)
local a, L = 0.1, 4                                                -- m
local T, V = 1e3, 1e3                                              -- N m, N

local function bar(b, load, warping)
  return hobe.static(hobe.scene{
    hobe.beam{ name = "bar", element = "MGD30w3", elements = n,
               section = hobe.rectangle{ width = a, height = b },
               material = { E = 210e9, nu = 0, rho = 7850 }, from = {0, 0, 0}, to = {L, 0, 0} },
    hobe.clamp{ "bar", at = 0, warping = warping },
    load,
  })
end

local printed = {                                                  -- b/a, k
  { 1, 0.208 }, { 1.5, 0.231 }, { 2, 0.246 }, { 3, 0.267 }, { 5, 0.291 }, { 10, 0.312 },
}
local rows, report = {}, {}
for i, p in ipairs(printed) do
  local b = p[1] * a
  local r = bar(b, hobe.moment{ "bar", at = 1, value = {T, 0, 0} }, "free")
  local k = T / (a*a*b * r:stress("bar", 0.5, a/2, 0).section[5])
  rows[i] = { p[1], k, p[2] }
  report["k" .. i] = { k, expect = p[2], within = 2.5e-3 }
end
hobe.table{ title = "Greatest stress of torsion, T/(k a^2 b)", columns = { "b/a", "k", "printed" },
            rows = rows, file = "torsion.csv" }

local h = 2*a
local r = bar(h, hobe.force{ "bar", at = 1, value = {0, 0, -V} })
local forces = r:resultants("bar", 0)
report.bending = { r:stress("bar", 0.5, 0, h/2).section[1], "Pa",
                   expect = V * L/2 * h/2 / (a*h^3/12), within = 1e-3 }
report.shear = { r:stress("bar", 0.5, 0, 0).section[5], "Pa", expect = -1.5*V/(a*h), within = 5e-3 }
report.shear_force = { forces.Vz, "N", expect = -V, within = 1e-8 }
report.moment = { forces.My, "N m", expect = V*L, within = 1e-6 }  -- the bar bends: a shorter arm
hobe.report(report)

hobe.picture{ file = "bending.png", title = "A cantilever under a force at its end", state = r,
              colour = "mises" }
hobe.vtk{ file = "bending.vtu", state = r }
