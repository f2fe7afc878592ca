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
-- Expected: the place of the end after 2 s, with a step of 0.25 ms and rho = 0.8, and off it what
-- theory says of the scheme's first two errors: expanded in its step h (D = d/dt) it solves
--
--     M u'' = (1 + C h^2 D^2 - d^3 h^3 D^3) f,   d = (1 - rho)/(1 + rho),   C = 1/6 + 3/4 d^2,
--
-- with its coefficients of Chung & Hulbert (1993), constraints in f (Arnold & Bruels 2007): the
-- second order shifts the motion, the third damps it.  Of a stiff pendulum f/M = u'' along its path
-- leaves an equation for what is off, which Runge and Kutta's method solves.  The fourth order is
-- left out, and the bar's own vibration, which is of the size of its sag 5 q L^4/384 EI.  For the
-- other two thresholds, steps too long for that, there is no closed form: they are what was found.
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

-- What is off after 2 s, per C h^2 and per d^3 h^3, along the path of the end: phi'' = k cos phi,
-- and (r'''' and r''''') across the bar.
local function expand()
  local k = 3*g/(2*L)
  local function slope(y)
    local v, c, s = y[2], k*math.cos(y[1]), k*math.sin(y[1])
    local j = -s*v
    local fourth, fifth = -c*v^2 - s*c, s*v^3 - 3*c^2*v - s*j
    return { v, c, y[4], -s*y[3] + fourth - 6*v^2*c,
             y[6], -s*y[5] - fifth + 15*v*c^2 + 10*v^2*j - v^5 }
  end
  local function beyond(y, h, f)
    local z = {}
    for i = 1, 6 do z[i] = y[i] + h*f[i] end
    return z
  end
  local y, dt = { 0, 0, 0, 0, 0, 0 }, 1e-3
  for _ = 1, 2000 do
    local f1 = slope(y)
    local f2 = slope(beyond(y, dt/2, f1))
    local f3 = slope(beyond(y, dt/2, f2))
    local f4 = slope(beyond(y, dt, f3))
    for i = 1, 6 do y[i] = y[i] + dt/6*(f1[i] + 2*f2[i] + 2*f3[i] + f4[i]) end
  end
  return y[1], L*y[3], L*y[5]
end
local phi, second, third = expand()
local sag = 5*rho*h^2*g*L^4/(384*210e9*h^4/12)

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
local rows, curves, refused, unsaid, won, violated, theory = {}, {}, 0, 0, 0, 0, 0
local function predict(step, decay)
  local d = (1 - decay)/(1 + decay)
  return (1/6 + 3/4*d^2)*step^2*second + d^3*step^3*third
end
for i, decay in ipairs{ 1, 0.95, 0.9, 0.8, 0.5, 0.1 } do
  curves[i] = { label = string.format("rho = %g", decay), style = "linespoints", x = {}, y = {} }
  for _, step in ipairs(steps) do
    local ok, d = pcall(swing, step, decay)
    local row = { decay, step, "no motion beyond" }
    if ok then
      local p = tip(d)
      local off = math.sqrt((p[1] - exact[1])^2 + (p[3] - exact[3])^2)/L
      local along = -(p[1] - exact[1])*math.sin(phi) - (p[3] - exact[3])*math.cos(phi)
      local expected = predict(step, decay)
      if step <= 0.005 then theory = math.max(theory, math.abs(along - expected)/sag) end
      local jump, loss, gain, violation = judge(d)
      row = { decay, step, off, math.abs(expected)/L, d.largest_error,
              d.largest_error > 1e-3 and "warned" or "", jump, loss, gain, violation }
      if d.largest_error <= 1e-3 then unsaid = math.max(unsaid, off) end
      won, violated = math.max(won, gain), math.max(violated, violation)
      table.insert(curves[i].x, step)
      table.insert(curves[i].y, off)
    else
      row[5] = tonumber(d:match("beyond t = ([%d.e-]+) s"))
      refused = refused + 1
    end
    rows[#rows + 1] = row
  end
end
hobe.table{
  title = "After 2 s", rows = rows, file = "genalpha.csv",
  columns = { "rho", "step, s", "off, of L", "theory", "error of a step", "", "jump of force",
              "energy lost", "won", "violation" },
}
hobe.plot{
  file = "genalpha.png", title = "A stiff pendulum after 2 s; lines end where no motion is found",
  xlabel = "step, s", ylabel = "distance of its end from where it should be, over L",
  series = curves, xlog = true, ylog = true,
}
hobe.report{
  refused = { refused, "of 36" },
  theory = { theory, "of the bar's sag", expect = 0, within = 1 },
  unsaid = { unsaid, "of L", expect = 0, within = 0.01 },
  won = { won, "", expect = 0, within = 0.01 },                -- at the longest steps
  violated = { violated, "", expect = 0, within = 1e-12 },
}
