-- Atlas of failures: constraints among the equations of a step, as the step gets short.
--
-- A step of generalised alpha solves [c M/h^2 + K, Phi_q'; Phi_q, 0] for displacements and
-- multipliers, c = (1 - am)/((1 - af) beta).  Of a mass m on a rod, |Phi_q| = 1, that matrix has
-- the eigenvalues a = c m/h^2 and (a +- sqrt(a^2 + 4))/2, so that its condition is a^2, as 1/h^4:
-- left as it is, rounding may leave no digit of a multiplier below h = 1e-4 s (Bottasso, Bauchau &
-- Cardona, SIAM J. Sci. Comput. 29, 2007).  hobe scales rows and columns, multipliers by their
-- constraints; then the eigenvalues are 1 and (1 +- sqrt 5)/2, at any step and in any units.
--
-- A rigid rod of 1 m and 2 kg falls from the horizontal about a hinge at its end: after a time t
-- so short it has turned by theta = 3 g t^2/4, and the hinge bears m g (1 + 9 theta^2)/4.  Twenty
-- steps in SI, in mm, t and s, and in km, g and s: what is missing is that of a scheme of second
-- order, (h w)^2, w^2 = 3 g/2, and of its tolerance, 1e-9 of the forces, and the hinge holds.  In
-- all units it is the same but for that tolerance; multipliers left unscaled weigh in the
-- iteration as their unit has it: it then ends too early, with forces that differ by 1e-5.
local hobe = require "hobe"

local g, m, count, rho = 9.81, 2, 20, 0.8
local units = { { "m, kg", 1, 1 }, { "mm, t", 1e-3, 1e3 }, { "km, g", 1e3, 1e-3 } }
local am, af = (2*rho - 1)/(rho + 1), rho/(rho + 1)
local c = (1 - am)/((1 - af)*(1 + af - am)^2/4)

-- The last state's relative error of the force of the hinge, and its greatest violation, over 1 m.
local function fall(h, length, mass)
  local I = m/12/mass/length^2
  local scene = hobe.scene{
    hobe.body{ name = "rod", mass = m/mass, centre = {0.5/length, 0, 0},
               inertia = {1e-2*I, I, I} },
    hobe.support{ "rod", point = {0, 0, 0}, kind = "revolute", axis = {0, 1, 0}, name = "hinge" },
    hobe.gravity{ 0, 0, -g/length },
  }
  local d = hobe.dynamic(scene, { to = count*h, step = h, rho = rho })
  local theta, violation = 3*g*(count*h)^2/4, 0
  for i = 1, d.count do violation = math.max(violation, d:energies(i).violation) end
  return d:state(d.count):reaction("hinge").force[3]*mass*length/(m*g*(1 + 9*theta^2)/4) - 1,
         violation, d.iterations/count
end

local rows, curves, first, excess, differ, violated = {}, {}, {}, 0, 0, 0
local lost = { label = "rounding, unscaled: 1e-16 times the condition", x = {}, y = {} }
for i, unit in ipairs(units) do
  curves[i] = { label = unit[1], style = "linespoints", x = {}, y = {} }
  for k = 3, 6 do
    local h = 10^-k
    local off, violation, each = fall(h, unit[2], unit[3])
    local condition = (c*m/unit[3]/h^2)^2
    rows[#rows + 1] = { unit[1], h, condition, (3 + math.sqrt(5))/2, off, violation, each }
    excess = math.max(excess, math.abs(off)/(1.5*g*h^2 + 1e-9))
    violated = math.max(violated, violation)
    first[k] = first[k] or off
    differ = math.max(differ, math.abs(off - first[k]))
    curves[i].x[k - 2], curves[i].y[k - 2] = -k, math.log(math.max(math.abs(off), 1e-16), 10)
    if i == 1 then
      lost.x[k - 2], lost.y[k - 2] = -k, math.min(0, math.log(1.1e-16*condition, 10))
    end
  end
end
curves[#curves + 1] = lost
hobe.table{
  title = "The force of a hinge after twenty steps", rows = rows, file = "constraints.csv",
  columns = { "units", "step, s", "condition, unscaled", "scaled", "force, relative error",
              "violation", "iterations a step" },
}
hobe.plot{
  file = "constraints.png", title = "The force of a hinge, its error over the step",
  xlabel = "log10 of the step, s", ylabel = "log10 of the relative error", series = curves,
}
hobe.report{
  excess = { excess, "of (h w)^2 + 1e-9", expect = 0, within = 1 },
  violated = { violated, "", expect = 0, within = 1e-10 },  -- where a step ends
  differ = { differ, "between units", expect = 0, within = 2e-9 }, -- the tolerance, of each
}
