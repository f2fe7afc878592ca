-- The Princeton beam: a slender cantilever bent about both axes and twisted by a dead tip load.
--
-- Experiment: Dowell & Traybar 1975.  Model and dimensions: Tang, Tian & Hu 2022, section 5.1
-- (L 508 mm, section 3.2024 x 12.377 mm, E 71.7 GPa, nu 0.31, loads 4.448, 8.896, 13.345 N).
-- Expected numbers: 24 x MGD30w integrated exactly, by an independent prototype with complex-step
-- tangents and the Poisson coupling on the axis, which here differs from the default by 1e-5.
--
-- `hobe chart cases/princeton.lua` compares models by their errors beside the converged solid, whose
-- last digits are uncertain: what beams with warping converge to differs by 2e-3 in u2.
local hobe = require "hobe"

local P     = hobe.param("P", 13.345)                -- N
local theta = hobe.param("angle", 30)                -- deg, 0: along the stiff axis z
local angle = math.rad(theta)

local scene = hobe.scene{
  hobe.beam{
    name = "blade",
    element = hobe.param("element", "MGD30w"), elements = hobe.param("elements", 24),
    section = hobe.rectangle{ width = 3.2024e-3, height = 12.377e-3 },
    material = { E = 71.7e9, nu = 0.31, rho = 2700 },
    from = {0, 0, 0}, to = {0.508, 0, 0},
    mechanics = hobe.param("mechanics", "average"),
    integration = hobe.param("integration", "exact"),
  },
  hobe.clamp{ "blade", at = 0 },
  hobe.force{ "blade", at = 1, value = {0, -P*math.sin(angle), -P*math.cos(angle)} },
}

local fields = hobe.param("reduced", 0)               -- so many unknowns of a reduced model; 0: whole
local r = hobe.static(fields > 0 and hobe.reduce(scene, { modes = fields }) or scene)
local u = r:displacement("blade", 1)
local twist = math.deg(r:twist("blade", 1))          -- of the slope r_z in the Y-Z plane

local solid                                          -- converged quadratic bricks, clamped face
if P == 13.345 and theta == 30 then
  solid = { u2 = -0.117537, u3 = -0.016657, twist = 3.270 }
  hobe.table{
    title = "Tip of the Princeton beam beside other people's",
    columns = { "", "u1, m", "u2, m", "u3, m", "twist, deg" },
    rows = {
      { "this run",                        u[1],      u[2],      u[3],      twist },
      { "solid model, converged",          -0.017064, -0.117537, -0.016657, 3.270 },
      { "SOLID95 (Tang et al., Table 7)",  nil,       nil,       -0.016698 },
      { "BEAM188 (Table 7)",               nil,       nil,       -0.016664 },
      { "experiment (Table 7)",            nil,       nil,       -0.016903 },
    },
  }
end
hobe.report{
  u1    = { u[1],  "m",   expect = -1.708297739e-02, within = 1e-4 },
  u2    = { u[2],  "m",   expect = -1.176497589e-01, within = 1e-4 },
  u3    = { u[3],  "m",   expect = -1.659323289e-02, within = 1e-4 },
  twist = { twist, "deg", expect = 3.23402,          within = 3e-4 },
}
hobe.chart{
  quantities = { "u2", "u3", "twist" }, truth = solid, doubt = 2e-3,
  ladder = {
    { element = { "BE24", "3333", "MGD30", "3433", "BE24w", "3333w", "MGD30w", "3433w", "BE42", "3363",
                  "MGD30w3" }, elements = { 1, 2, 4, 8, 16, 32, 64 } },
    { element = "3333s", elements = { 1, 2, 4, 8, 16 }, mechanics = "structural" },
    { element = { "34X3", "B4", "BE24w-II", "MGD30w-II" }, elements = { 1, 2, 4, 8, 16, 32 } },
    { element = { "3333w", "MGD30w", "3433w" }, elements = { 4, 8, 16 }, integration = "paper" },
    { element = { "MGD30w", "34X3" }, elements = { 4, 8, 16 }, mechanics = { "axis", "full" } },
    { element = "MGD30w", elements = { 16, 64 }, reduced = { 4, 8 } },
  },
}
