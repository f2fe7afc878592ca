-- Cantilevers in torsion by few unknowns: component modes, as the paper reduces them, coarse
-- meshes of as many unknowns, and the fields of the path's power series, beside the full model.
--
-- Tang, Tian & Hu 2022, sect. 5.2, Figs. 8 and 10: square, I and hollow cantilevers under an
-- end torque, "the modes can be reduced to 120 when theta is in [0, 2]" rad, of a model with
-- 495 unknowns, 250 to 16 rad.  There the structure is linearised again and again along the
-- path, and moves by constraint modes of its interfaces and the lowest normal modes between
-- them.  So here: K and its modes are those of the state where a load step begins, and the step
-- is solved in their space.  L 2 m, nu 0.3, E 210 GPa (I) and 1 GPa; 8 elements MGD30w, 192
-- unknowns; torques that turn the end by 2 rad, but 0.75 of the hollow one, whose walls bend
-- beyond.
--
-- A section that turns by theta asks for cos theta - 1 on its slopes: a stretch, to the modes
-- of the linear theory, and those are at the top of the spectrum.  Without them a step of d
-- theta is too stiff by its square.  So the error falls with the number of load steps, each of
-- which takes an eigenproblem, and not with the number of modes until nearly all are there: 120
-- of 192 lose 41 to 82 % of the angle in 16 steps, where a mesh of five elements with 120
-- unknowns loses 0.2 to 5 %. What the modes cannot see of the residual, relative to the load,
-- is "outside"; "indicator" is what hobe says of the error without the full solution, infinite
-- where it is out of its reach.
--
-- The fields of the path's series (hobe.reduce) hold that stretch: six of them lose less than
-- 1e-7, with an energy of their own that needs no element.
--
-- Expected: all modes give the full solution, to rounding; six fields less than 1e-4, as a
-- prototype found for the square.  Errors of coarse meshes and of modes are our own numbers: the
-- former are to be small.
-- Long: not run under the sanitizers, eigenproblems in each of many steps.
local hobe = require "hobe"

local n, L, steps = 8, 2, hobe.param("steps", 16)
local beams = {
  { name = "square", section = hobe.square{ side = 0.1 }, E = 1e9, M = 5.4e3 },
  { name = "I", E = 210e9, M = 41e3,
    section = hobe.I{ height = 0.215, width = 0.1, flange = 0.015, web = 0.01 } },
  { name = "hollow", E = 1e9, M = 1.5e3,
    section = hobe.hollow{ width = 0.16, height = 0.08, thickness = 0.01 } },
}

local function cantilever(beam, elements)
  return hobe.scene{
    hobe.beam{ name = "bar", element = "MGD30w", elements = elements, section = beam.section,
               material = { E = beam.E, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {L, 0, 0} },
    hobe.clamp{ "bar", at = 0 },
    hobe.moment{ "bar", at = 1, value = { beam.M, 0, 0 } },
  }
end

local report, rows, lines = {}, {}, {}

-- Appends what a result is worth: the error of the twist beside its unknowns.
local function note(beam, line, how, unknowns, r)
  local error = r:twist("bar", 1)/beam.full - 1
  rows[#rows + 1] = { beam.name, how, unknowns, r:twist("bar", 1), 100*error, r.outside,
                      r.indicator < math.huge and r.indicator or "infinite" }
  if line and math.abs(error) > 1e-12 then            -- above rounding
    line.x[#line.x + 1], line.y[#line.y + 1] = unknowns, math.abs(error)
  end
  return error
end

for _, beam in ipairs(beams) do
  local scene = cantilever(beam, n)
  local full = hobe.static(scene, { steps = 8 })
  beam.full = full:twist("bar", 1)
  note(beam, nil, "full", full.unknowns, full)
  local mesh = { x = {}, y = {}, label = beam.name .. ", coarse meshes" }
  for elements = 1, 6 do
    local r = hobe.static(cantilever(beam, elements), { steps = 8 })
    local error = note(beam, mesh, elements .. " elements", r.unknowns, r)
    if elements == 5 then
      report[beam.name .. "_mesh_120"] = { error, "", expect = 0, within = 0.05 }
    end
  end
  local modes = { x = {}, y = {}, label = beam.name .. ", component modes" }
  for _, count in ipairs{ 30, 60, 90, 120, 150, full.unknowns } do
    local r = hobe.static(scene, { steps = steps, projection = { modes = count } })
    local error = note(beam, modes, "component modes", r.projected, r)
    if count == 120 then report[beam.name .. "_modes_120"] = { error } end
    if count == full.unknowns then
      report[beam.name .. "_all_modes"] = { error, expect = 0, within = 1e-9 }
    end
  end
  local series = { x = {}, y = {}, label = beam.name .. ", path's series" }
  for count = 3, 6 do
    local reduced = hobe.reduce(scene, { modes = count })
    local r = hobe.static(reduced, { steps = 8 })
    local error = note(beam, series, "path's series", reduced.unknowns, r)
    if count == 6 then
      report[beam.name .. "_series_6"] = { error, expect = 0, within = 1e-4 }
    end
  end
  for _, line in ipairs{ mesh, modes, series } do lines[#lines + 1] = line end
end
hobe.table{
  file = "torsion_reduced.csv", title = "Twist of the end by few unknowns", columns = {
    "section", "how", "unknowns", "rad", "error, %", "outside", "indicator" }, rows = rows,
}
hobe.plot{
  file = "torsion_reduced.png", title = "Torsion to 2 rad: unknowns and error",
  xlabel = "unknowns", ylabel = "relative error of the twist", xlog = true, ylog = true,
  series = lines,
}

-- ---- load steps --------------------------------------------------------------------------------

local square, scene, errors = beams[1], cantilever(beams[1], 4), {}
local full = hobe.static(scene, { steps = 8 }):twist("bar", 1)
for i, count in ipairs{ 4, 16, 64, 256 } do
  local r = hobe.static(scene, { steps = count, projection = { modes = 40 } })
  errors[i] = { count, r:twist("bar", 1)/full - 1, r.outside, r.factorisations }
end
hobe.table{
  file = "load_steps.csv",
  title = "Square, 4 elements, 40 of 96 unknowns: each load step has modes "
    .. "of its own", columns = { "steps", "error", "outside", "factorisations" }, rows = errors,
}
report.steps_16, report.steps_256 = { errors[2][2] }, { errors[4][2] }
hobe.report(report)
