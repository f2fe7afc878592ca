-- Proper orthogonal decomposition (L. Sirovich, Quart. Appl. Math. 45, 1987): a basis from the
-- states of one load, and what it knows of others.
--
-- A cantilever, L 1 m, 50 x 80 mm, E 1 GPa, nu 0.3, is bent by end forces along z up to 2 kN,
-- P L^2/EI = 0.94; the main directions of eight such states are the basis.  Tang, Tian & Hu
-- 2022, sect. 1, say of such models that they are "only the optimal approximation to the prior
-- training data".  So it is: where it was trained, and one and a half times beyond, four
-- unknowns do as asked for, to 1e-6 of the states.  Under a force along y or a torque nothing
-- moves at all, since in no state has anything moved there; and of a force in between, only the
-- part along z does.  Component modes of the state at each load step (Craig & Bampton 1968)
-- know no load: they are far too stiff where sections turn (cases/torsion_reduced.lua), but
-- nowhere blind.  Twenty fields of the paths' series under a force along either axis and a torque
-- (hobe.reduce) hold for all of them.
--
-- Error: the distance of the ends, by the full model's displacement.  Expected: 1 where the
-- basis is blind, exactly.  At 45 deg the linear theory's, u_y : u_z = 80^2 : 50^2, of which
-- u_y is lost; the square of the displacement is left out.  Of the series 1e-3, an engineer's.
local hobe = require "hobe"

local L, section = 1, hobe.rectangle{ width = 0.05, height = 0.08 }

local function cantilever(load)
  return hobe.scene{
    hobe.beam{ name = "bar", element = "MGD30w", elements = 6, section = section,
               material = { E = 1e9, nu = 0.3, rho = 1000 }, from = {0, 0, 0}, to = {L, 0, 0} },
    hobe.clamp{ "bar", at = 0 }, load }
end

local function force(y, z) return hobe.force{ "bar", at = 1, value = { 0, y, z } } end

local training = {}
for i = 1, 8 do training[i] = hobe.static(cantilever(force(0, 250*i))) end
local pod = { method = "pod", training = training }
local torque = hobe.moment{ "bar", at = 1, value = { 100, 0, 0 } }
local series = hobe.reduce(cantilever(force(0, 2000)), {
  modes = 20, loads = { cantilever(force(2000, 0)), cantilever(torque) } })

local function apart(a, b)
  local sum, size = 0, 0
  for _, z in ipairs{ 0, 0.04 } do                    -- the axis, and a point that a torque moves
    local u, v = a:displacement("bar", 1, 0, z), b:displacement("bar", 1, 0, z)
    for i = 1, 3 do sum, size = sum + (u[i] - v[i])^2, size + v[i]^2 end
  end
  return math.sqrt(sum/size)
end

local tests = {
  { "between", force(0, 1100), "within the training", expect = 0, within = 1e-5 },
  { "beyond", force(0, 3000), "one and a half times beyond", expect = 0, within = 1e-4 },
  { "across", force(1100, 0), "along y", expect = 1, within = 1e-9 },
  { "torque", torque, "a torque", expect = 1,
    within = 1e-9 },
  { "slanting", force(200, 200), "at 45 deg", expect = 0.64/math.sqrt(0.64^2 + 0.25^2),
    within = 5e-3 },
}
local rows, report = {}, {}
for i, test in ipairs(tests) do
  local scene = cantilever(test[2])
  local full = hobe.static(scene, { steps = 4 })
  local few = hobe.static(scene, { steps = 4, projection = pod })
  local modes = hobe.static(scene, { steps = 4, projection = { modes = 30 } })
  local along = hobe.static(series:on(scene), { steps = 4 })
  local error, other = apart(few, full), apart(along, full)
  rows[i] = { test[3], few.projected, error, series.unknowns, other, modes.projected,
              apart(modes, full), full.unknowns }
  report["pod_" .. test[1]] = { error, expect = test.expect, within = test.within }
  report["series_" .. test[1]] = { other, expect = 0, within = 1e-3 }
end
hobe.table{
  file = "pod.csv", title = "What bases know of loads: error of the end's displacement",
  columns = { "load", "POD", "error", "series", "error", "component modes", "error", "full" },
  rows = rows,
}
hobe.report(report)
