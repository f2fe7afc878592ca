-- Atlas of failures: generalised alpha against its step and its rho, on a stiff pendulum.
--
-- A steel bar of 1 m, 40 x 40 mm, falls from the horizontal about a hinge; its fastest vibrations
-- are a thousand times faster than any step.  rho is what a step leaves of those.  Without damping
-- in the scheme (rho = 1) the equations of joints let them grow until the accelerations leap: that
-- is seen in the step where it happens, which is an error with its time and a remedy; above 0.9
-- hobe.dynamic warns at once.  0.8, the default, holds for any step that is worth taking, and 0.5
-- and less take energy out of the motion itself: of the third order, but much.
--
-- What a fixed step costs is estimated in each; more than 0.001 of the scene's size is warned of.
-- Hinges hold to rounding at any step, since constraints are unknowns of each; their force
-- trembles by the elastic bar's own vibration, which begins when it is let go of at once.
--
-- Expected: the place of the end after 2 s, with a step of 0.25 ms and rho = 0.8.
local hobe = require "hobe"

local g, L, h, rho = 9.81, 1, 0.04, 7850
local weight = rho*h^2*L*g
local bar = hobe.scene{
  hobe.beam{ name = "bar", element = "MGD30", elements = 2, section = hobe.square{ side = h },
             material = { E = 210e9, nu = 0.3, rho = rho }, from = {0, 0, 0}, to = {L, 0, 0} },
  hobe.support{ "bar", at = 0, kind = "revolute", axis = {0, 1, 0}, name = "hinge" },
  hobe.gravity{ 0, 0, -g },
}

local function swing(step, decay)
  return hobe.dynamic(bar, { to = 2, step = step, rho = decay })
end
local function tip(d) return d:state(d.count):position("bar", 1) end

-- The greatest change of the hinge's force from step to step, over the weight; the greatest energy
-- lost, or won, over weight times length; and the greatest violation of the hinge.
local function judge(d)
  local jump, lost, won, violation, last = 0, 0, 0, 0, nil
  for i = 2, d.count do
    local f, e = d:state(i):reaction("hinge").force[3], d:energies(i)
    jump, last = last and math.max(jump, math.abs(f - last)) or 0, f
    lost, won = math.min(lost, e.balance), math.max(won, e.balance)
    violation = math.max(violation, e.violation)
  end
  return jump/weight, -lost/weight/L, won/weight/L, violation
end

local exact = tip(swing(0.25e-3, 0.8))
local steps = { 0.1, 0.05, 0.02, 0.01, 0.005, 0.002 }
local rows, curves, refused, unsaid, won, violated = {}, {}, 0, 0, 0, 0
for i, decay in ipairs{ 1, 0.95, 0.9, 0.8, 0.5, 0.1 } do
  curves[i] = { label = string.format("rho = %g", decay), style = "linespoints", x = {}, y = {} }
  for _, step in ipairs(steps) do
    local ok, d = pcall(swing, step, decay)
    local row = { decay, step, "no motion beyond" }
    if ok then
      local p = tip(d)
      local off = math.sqrt((p[1] - exact[1])^2 + (p[3] - exact[3])^2)/L
      local jump, loss, gain, violation = judge(d)
      row = { decay, step, off, d.largest_error, d.largest_error > 1e-3 and "warned" or "", jump,
              loss, gain, violation }
      if d.largest_error <= 1e-3 then unsaid = math.max(unsaid, off) end
      won, violated = math.max(won, gain), math.max(violated, violation)
      table.insert(curves[i].x, step)
      table.insert(curves[i].y, off)
    else
      row[4] = tonumber(d:match("beyond t = ([%d.e-]+) s"))
      refused = refused + 1
    end
    rows[#rows + 1] = row
  end
end
hobe.table{
  title = "After 2 s", rows = rows, file = "genalpha.csv",
  columns = { "rho", "step, s", "off, of L", "error of a step", "", "jump of force", "energy lost",
              "won", "violation" },
}
hobe.plot{
  file = "genalpha.png", title = "A stiff pendulum after 2 s; lines end where no motion is found",
  xlabel = "step, s", ylabel = "distance of its end from where it should be, over L",
  series = curves, xlog = true, ylog = true,
}
hobe.report{
  refused = { refused, "of 36" },
  unsaid = { unsaid, "of L", expect = 0, within = 0.01 },
  won = { won, "", expect = 0, within = 0.01 },                -- at the longest steps
  violated = { violated, "", expect = 0, within = 1e-12 },
}
