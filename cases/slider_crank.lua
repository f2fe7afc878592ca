-- A slider-crank with an elastic rod: how far the rod bends at 150 rad/s.
--
-- The mechanism of Jonker 1989 and Meijaard 1991: a rigid crank r = 0.15 m, a steel rod l = 0.3 m
-- of 6 mm, E 200 GPa, 7870 kg/m^3, on a slider of half its mass; no gravity.  At the start it is
-- in line, and moves as a stiff one does.
--
-- Expected, of a rod 10000 times as stiff: x = r cos(phi) + sqrt(l^2 - r^2 sin^2(phi)).  Of the
-- steel rod: its first mode, w = q sin(pi s/l) off the chord, at the angle b, from the pin P to
-- the slider, under the stiff rod's acceleration a(s) = P'' + b'' s n - b'^2 s e and tension N(s),
--
--     rho A l/2 (q'' - b'^2 q) + (EI (pi/l)^4 l/2 + int N (pi/l)^2 cos^2(pi s/l) ds) q
--         = -rho A int a.n sin(pi s/l) ds,
--
-- which we integrate by Runge and Kutta's method, with what q adds to N at first order.  It leaves
-- out the third mode, and what the rod's shortening by bending does to the slider, (w/l)^2:
-- little, but for nine periods: 3 % of the motion.  Nothing printed is compared.
local hobe = require "hobe"

local r, l, speed = 0.15, 0.3, 150                    -- m, m, rad/s
local E, rho, radius = 200e9, 7870, 0.003
local A, I = math.pi*radius^2, math.pi*radius^4/4
local slider = rho*A*l/2                              -- kg
local step = hobe.param("step", 1e-4)                 -- s
local turn = 2*math.pi/speed

local function mechanism(stiffer)
  local across = {0, 0, 1}
  return hobe.scene{
    hobe.body{ name = "crank", mass = 0.1, centre = {0, 0, 0}, inertia = {1e-3, 1e-3, 1e-3} },
    hobe.support{ "crank", point = {0, 0, 0}, kind = "revolute", axis = across,
                  angular_velocity = speed, name = "shaft" },
    hobe.beam{
      name = "rod", element = hobe.param("element", "MGD30"), elements = hobe.param("n", 4),
      section = hobe.circle{ radius = radius },
      material = { E = stiffer*E, nu = 0.3, rho = rho }, from = {r, 0, 0}, to = {r + l, 0, 0},
    },
    hobe.joint{ "crank", "rod", at = 0, kind = "revolute", axis = across },
    hobe.support{ "rod", at = 1, kind = "inplane", axis = {0, 1, 0} },
    hobe.mass{ "rod", at = 1, mass = slider },
    hobe.motion{ "crank", angular_velocity = {0, 0, speed} },
    hobe.motion{ "rod", velocity = {0, r*speed, 0}, about = {r, 0, 0},
                 angular_velocity = {0, 0, -r*speed/l} },
  }
end

-- q'' at the time t, v = q'.
local function bend(t, q, v)
  local phi = speed*t
  local px, py = -r*speed^2*math.cos(phi), -r*speed^2*math.sin(phi)    -- P''
  local sb = -r/l*math.sin(phi)                       -- sin b
  local cb = math.sqrt(1 - sb^2)
  local b1 = -r/l*speed*math.cos(phi)/cb
  local b2 = (r/l*speed^2*math.sin(phi) + b1^2*sb)/cb
  local along, across = px*cb + py*sb, -px*sb + py*cb -- P''.e, P''.n
  local x2 = px - l*(b2*sb + b1^2*cb)                 -- of the slider
  local end_n = rho*A*(l/2*across + l^2/3*b2)         -- what the rod is given there
  local end_e = (end_n*sb - slider*x2)/cb
  local N = end_e*l/2 - rho*A*(along*l^2/4 - b1^2*l^3*(1/3 - 1/(4*math.pi^2))/2
                               - (2*b1*v + b2*q)*l^2/(2*math.pi))
  -- end_n grows by rho A l/pi (q'' - b'^2 q) with q, N by sb/cb l/2 of that
  return b1^2*q - (((E*I*(math.pi/l)^4 + 2/l*(math.pi/l)^2*N)/(rho*A)*q
                    + 2/l*(2*l/math.pi*across + l^2/math.pi*b2)) / (1 + math.pi/l*q*sb/cb))
end

-- q at the times.
local function first_mode(times)
  local q, v, list, steps = 0, 0, { 0 }, 4
  for i = 2, #times do
    local h = (times[i] - times[i - 1])/steps
    for k = 0, steps - 1 do
      local t = times[i - 1] + k*h
      local a1 = bend(t, q, v)
      local a2 = bend(t + h/2, q + h/2*v, v + h/2*a1)
      local a3 = bend(t + h/2, q + h/2*v + h^2/4*a1, v + h/2*a2)
      local a4 = bend(t + h, q + h*v + h^2/2*a2, v + h*a3)
      q, v = q + h*v + h^2/6*(a1 + a2 + a3), v + h/6*(a1 + 2*a2 + 2*a3 + a4)
    end
    list[i] = q
  end
  return list
end

-- How far the slider is from where a stiff rod has it, and the middle of the rod off its chord, m.
local function measure(state)
  local phi = speed*state.time
  local pin, middle, slider = state:position("rod", 0), state:position("rod", 1/2),
                              state:position("rod", 1)
  local ex, ey = (slider[1] - pin[1])/l, (slider[2] - pin[2])/l
  return slider[1] - r*math.cos(phi) - math.sqrt(l^2 - r^2*math.sin(phi)^2),
         ex*(middle[2] - pin[2]) - ey*(middle[1] - pin[1])
end

local stiff = hobe.dynamic(mechanism(1e4), { to = turn, step = step, store = turn/40 })
local worst = 0
for i = 1, stiff.count do worst = math.max(worst, math.abs((measure(stiff:state(i))))) end

local d = hobe.dynamic(mechanism(1), { to = 2*turn, step = step/2, store = turn/100 })
local turns, found, theory, states = {}, {}, {}, {}
local sum, all, largest, expected = 0, 0, 0, 0
local q = first_mode(d.times)
for i, t in ipairs(d.times) do
  local _, middle = measure(d:state(i))
  turns[i], found[i], theory[i] = t/turn, middle/l, q[i]/l
  sum, all = sum + (middle - q[i])^2, all + q[i]^2
  largest, expected = math.max(largest, math.abs(middle)/l), math.max(expected, math.abs(q[i])/l)
  if i % 25 == 0 and i <= 150 then
    states[#states + 1] = { d:state(i), string.format("%.2f turns", t/turn) }
  end
end
hobe.plot{
  file = "slider_crank.png", title = "The rod's middle off its chord", xlabel = "turns",
  ylabel = "w/l",
  series = {
    { x = turns, y = found, label = "beam" }, { x = turns, y = theory, label = "first mode" },
  },
}
hobe.picture{
  file = "slider_crank_states.png", title = "Connecting rod", states = states, colour = "mises",
  view = { azimuth = -90, elevation = 90 }, columns = 3, reference = false,
}
local e = d:energies(d.count)
hobe.report{
  stiff_slider = { worst, "m", expect = 0, within = 1e-6 },
  first_mode = { math.sqrt(sum/all), "", expect = 0, within = 4e-2 },
  largest = { largest, "", expect = expected, within = 1e-2 },
  violation = { e.violation, "", expect = 0, within = 1e-12 },
}
