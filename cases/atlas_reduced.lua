-- Atlas of failures: reduced models against their modes and the distance from where they were made.
--
-- A square cantilever of 16 elements of MGD30w under an end torque; the basis holds the
-- derivatives of the path at rest.  Each result brings an indicator, what the displacements may
-- lack of those of the whole scene, from one correction of that.  Expected: the whole scene.
-- Where the indicator says less than 1 %, the twist must be right to 2 %; it is shown up to 9.99,
-- and infinite where the correction is not found, which the note on the result says, too.  A basis
-- of torsion knows no bending: a force across finds it stiff, and the indicator says that all is
-- missing.
local hobe = require "hobe"

local E, nu, L, side = 1e9, 0.3, 2, 0.1
local section = hobe.square{ side = side }
local GJ = E/(2*(1 + nu))*section.J

local function bar(load)
  return hobe.scene{
    hobe.beam{ name = "bar", element = "MGD30w", elements = 16, section = section,
               material = { E = E, nu = nu }, from = {0, 0, 0}, to = {L, 0, 0} },
    hobe.clamp{ "bar", at = 0 }, load }
end

local function torsion(angle)                          -- linear theory's torque for it
  return bar(hobe.moment{ "bar", at = 1, value = {angle*GJ/L, 0, 0} })
end

local angles, counts = { 0.1, 0.5, 1, 2, 4 }, { 1, 2, 4, 6, 9, 12 }
local whole, truth = torsion(1), {}
for j, angle in ipairs(angles) do
  truth[j] = hobe.static(torsion(angle), { steps = 8 }):twist("bar", 1)
end
local rows, curves, unsaid = {}, {}, 0
for i, count in ipairs(counts) do
  local reduced = hobe.reduce(whole, { modes = count })
  curves[i] = { label = count .. (count > 1 and " modes" or " mode"), style = "linespoints",
                x = {}, y = {} }
  for j, angle in ipairs(angles) do
    local ok, r = pcall(hobe.static, reduced:on(torsion(angle)), { steps = 8 })
    rows[#rows + 1] = { count, truth[j], ok and r:twist("bar", 1) or "no equilibrium" }
    if ok then
      local off = math.abs(r:twist("bar", 1)/truth[j] - 1)
      rows[#rows][4], rows[#rows][5] = off, math.min(r.indicator, 9.99)
      if r.indicator < 0.01 then unsaid = math.max(unsaid, off) end
      table.insert(curves[i].x, truth[j])
      table.insert(curves[i].y, math.max(off, 1e-12))
    end
  end
end
hobe.table{
  title = "Twist of the end by few modes", rows = rows, file = "reduced.csv",
  columns = { "modes", "whole, rad", "reduced, rad", "off", "indicator" },
}
hobe.plot{
  file = "reduced.png", title = "Torsion by few modes", xlabel = "twist of the end, rad",
  ylabel = "relative error of the twist", ylog = true, series = curves,
}

local across = bar(hobe.force{ "bar", at = 1, value = {0, 0, 0.1*E*section.Iyy/L^2} })
local ok, bent = pcall(hobe.static, hobe.reduce(whole, { modes = 6 }):on(across))
hobe.report{
  unsaid = { unsaid, "", expect = 0, within = 0.02 },
  across = { ok and math.min(bent.indicator, 1) or 1, "", expect = 1, within = 0.5 },
}
