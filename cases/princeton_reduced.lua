-- The Princeton beam of cases/princeton_angles.lua under its largest load at any angle, reduced:
-- one basis, made of the paths under two loads, down and sideways, serves all angles.  Expected:
-- the whole beam.  The picture has the error over the number of unknowns at three angles that the basis
-- was not made of, beside coarse meshes.
--
-- A path leads through states u = lambda u_1 + lambda^2 u_2 + ...; of two loads the products count,
-- too: 20 unknowns are what derivatives to the fifth order would span, and 27 to the sixth.
local hobe = require "hobe"

local n, P = hobe.param("n", 24), 13.345                                                       -- N
local section = hobe.rectangle{ width = 3.2024e-3, height = 12.377e-3 }
local angles = { 30, 52, 75 }                                                                -- deg

local function scene(angle, elements)
  local a = math.rad(angle)
  return hobe.scene{
    hobe.beam{
      name = "blade", element = "MGD30w", elements = elements or n, section = section,
      material = { E = 71.7e9, nu = 0.31, rho = 2700 }, from = {0, 0, 0}, to = {0.508, 0, 0},
    },
    hobe.clamp{ "blade", at = 0 },
    hobe.force{ "blade", at = 1, value = {0, -P*math.sin(a), -P*math.cos(a)} },
  }
end

local function tip(result) return result:displacement("blade", 1), result:twist("blade", 1) end

local whole = {}
for i, angle in ipairs(angles) do whole[i] = hobe.static(scene(angle)) end

-- The largest errors of displacement, relative to |u|, and of the twist over all angles, of results
-- made by solve(angle).
local function errors(solve)
  local worst, worst_twist, indicator = 0, 0, 0
  for i, angle in ipairs(angles) do
    local expect, expect_twist = tip(whole[i])
    local result = solve(angle)
    local u, twist = tip(result)
    local apart, size = 0, 0
    for k = 1, 3 do apart, size = apart + (u[k] - expect[k])^2, size + expect[k]^2 end
    worst = math.max(worst, math.sqrt(apart/size))
    worst_twist = math.max(worst_twist, math.abs(twist/expect_twist - 1))
    indicator = math.max(indicator, result.indicator)
  end
  return worst, worst_twist, indicator
end

-- ---- unknowns against error --------------------------------------------------------------------

local down, across = scene(0), scene(90)
local report, rows = {}, {}
local unknowns, u_errors, twist_errors, indicators = {}, {}, {}, {}
for i, modes in ipairs{ 12, 16, 20, 27 } do
  local r = hobe.reduce(down, { modes = modes, loads = { across } })
  local u, twist, indicator = errors(function(angle) return hobe.static(r:on(scene(angle))) end)
  unknowns[i], u_errors[i], twist_errors[i], indicators[i] = r.unknowns, u, twist, indicator
  rows[i] = { "reduced", r.unknowns, u, twist, indicator }
  if modes >= 20 then
    local within_twist = modes == 20 and 1.5e-2 or 1e-3
    assert(u < 1e-3 and twist < within_twist, modes .. " unknowns do not serve all angles")
    local is, is_twist = tip(hobe.static(r:on(scene(52))))
    local expect, expect_twist = tip(whole[2])
    report["u2_" .. modes] = { is[2], "m", expect = expect[2], within = 1e-3 }
    report["u3_" .. modes] = { is[3], "m", expect = expect[3], within = 1e-3 }
    report["twist_" .. modes] = { math.deg(is_twist), "deg", expect = math.deg(expect_twist),
                                  within = within_twist }
  end
end

local coarse, coarse_u, coarse_twist = {}, {}, {}
for elements = 1, 4 do
  local u, twist = errors(function(angle) return hobe.static(scene(angle, elements)) end)
  coarse[elements], coarse_u[elements], coarse_twist[elements] =
    scene(0, elements).unknowns, u, twist
  rows[#rows + 1] = { "mesh of " .. elements, coarse[elements], u, twist }
end

hobe.table{
  title = "The largest errors at 30, 52 and 75 deg", rows = rows, file = "errors.csv",
  columns = { "", "unknowns", "u", "twist", "indicator" },
}
hobe.plot{
  file = "errors.png", title = "Princeton beam at any angle from one basis",
  xlabel = "unknowns", ylabel = "error", ylog = true,
  series = {
    { label = "reduced, u", x = unknowns, y = u_errors, colour = 1 },
    { label = "reduced, twist", x = unknowns, y = twist_errors, colour = 2 },
    { label = "indicator", x = unknowns, y = indicators, colour = 0 },
    { label = "coarse mesh, u", x = coarse, y = coarse_u, colour = 1, style = "points" },
    { label = "coarse mesh, twist", x = coarse, y = coarse_twist, colour = 2, style = "points" },
  },
}
hobe.report(report)
