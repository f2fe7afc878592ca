-- Equilibrium paths as power series: how many factorisations they need beside Newton's method.
--
-- The asymptotic numerical method (N. Damil & M. Potier-Ferry, Int. J. Engng Sci. 28, 1990;
-- B. Cochelin, Computers & Structures 53, 1994): about a state the path is a power series, each of
-- whose terms solves a linear problem with the one tangent stiffness that has been factored there.
-- The force is cubic in the displacements, so that the terms are exact.  A step goes as far as the
-- series is good, Newton's iteration corrects what is left, and the next series begins.
--
-- Problems: the Princeton beam under its largest load P3 at 30 deg; the elastica under a tip load
-- P L^2/EI = 10; a cantilever that its end moment 2 pi EI/L rolls up; a square bar that its end
-- torque turns by 29 rad.  Newton's load steps are those that come to the same state with the
-- fewest factorisations of a few that were tried; one step at 29 rad leads to another state.
-- Expected: the same end; the closed form of the elastica, which neglects shear and stretch.
local hobe = require "hobe"

local function cantilever(L, section, material, load)
  return hobe.scene{
    hobe.beam{ name = "beam", element = "MGD30w", elements = 20, section = section,
               material = material, from = {0, 0, 0}, to = {L, 0, 0} },
    hobe.clamp{ "beam", at = 0 }, load }
end

local E, side = 1e9, 0.1                             -- Pa, m
local EI = E*side^4/12
local square, soft = hobe.square{ side = side }, { E = E, nu = 0.3 }
local thirty = math.rad(30)

local problems = {
  { name = "Princeton beam, P3", steps = 1,
    scene = cantilever(0.508, hobe.rectangle{ width = 3.2024e-3, height = 12.377e-3 },
      { E = 71.7e9, nu = 0.31 }, hobe.force{ "beam", at = 1,
        value = { 0, -13.345*math.sin(thirty), -13.345*math.cos(thirty) } }) },
  { name = "elastica", steps = 1,
    scene = cantilever(10, square, { E = E, nu = 0 },
      hobe.force{ "beam", at = 1, value = { 0, 0, 10*EI/10^2 } }) },
  { name = "rolled up", steps = 8,
    scene = cantilever(10, square, { E = E, nu = 0 },
      hobe.moment{ "beam", at = 1, value = { 0, 2*math.pi*EI/10, 0 } }) },
  { name = "square in torsion", steps = 100,
    scene = cantilever(5, square, soft, hobe.moment{ "beam", at = 1, value = { 31e3, 0, 0 } }) },
}

local rows, apart = {}, 0
for _, problem in ipairs(problems) do
  local newton = hobe.static(problem.scene, { steps = problem.steps, tolerance = 1e-12 })
  local path = hobe.path(problem.scene, { method = "series" })
  problem.path, problem.tip = path, path[#path]:displacement("beam", 1)
  local n, difference, size = newton:displacement("beam", 1), 0, 0
  for a = 1, 3 do
    difference = math.max(difference, math.abs(n[a] - problem.tip[a]))
    size = math.max(size, math.abs(n[a]))
  end
  apart = math.max(apart, difference/size)
  rows[#rows + 1] = { problem.name, #path, path.factorisations, newton.steps,
                      newton.factorisations, difference/size }
end
hobe.table{
  file = "series.csv", title = "Steps and factorisations to the full load", columns = {
    "problem", "series", "factorisations", "Newton's steps", "factorisations of Newton",
    "difference at the tip" }, rows = rows,
}

local torsion = problems[4]
local torque, twist, at = { 0 }, { 0 }, { { 0 }, { 0 } }
for i, point in ipairs(hobe.path(torsion.scene, { method = "series", arc = 0.01 })) do
  torque[i + 1], twist[i + 1] = 31*point.load, point:twist("beam", 1)
end
for i, point in ipairs(torsion.path) do
  at[1][i + 1], at[2][i + 1] = 31*point.load, point:twist("beam", 1)
end
hobe.plot{
  file = "series.png", title = "A square bar in torsion: where its power series begin",
  xlabel = "torque, kNm", ylabel = "end twist, rad",
  series = { { x = torque, y = twist, label = "path" },
             { x = at[1], y = at[2], style = "points", label = "steps by series" } },
}

local elastica, rolled = problems[2].tip, problems[3].tip
hobe.report{
  princeton  = { problems[1].path.factorisations, expect = 3 },
  torsion    = { torsion.path.factorisations, expect = 55, within = 0.05 },  -- a step more or less
  twist      = { torsion.path[#torsion.path]:twist("beam", 1), "rad", expect = 28.99114403,
                 within = 1e-9 },
  apart      = { apart, expect = 0, within = 1e-10 },
  deflection = { elastica[3]/10, expect = 0.810609, within = 1e-3 },  -- the rest: shear, stretch
  shortening = { -elastica[1]/10, expect = 0.554996, within = 1e-3 },
  gap        = { math.sqrt((rolled[1] + 10)^2 + rolled[3]^2)/10, expect = 0, within = 2e-3 },
}
