-- A crank turned through a whole turn at a ramp of speed drives a slider against a gas spring.
--
-- Crank r = 0.1 m, rod l = 0.3 m, in the plane; the slider at x = r cos(phi) + sqrt(l^2 - r^2
-- sin^2(phi)) (any book on the theory of machines).  Shut in a cylinder, a gas pushes it back by
-- F(x) = F0 (d/(x0 + d - x))^1.4, x0 = r + l its dead centre, d = 0.05 m what is left there.  In
-- statics each time is an equilibrium: with stiff bars, virtual work asks the crank for a torque
-- T = F(x) dx/dphi, whose power is T times the speed.  Expected: these closed forms, but for what
-- the crank bends, T r^2/(3 E I) = 2e-4 r.
local hobe = require "hobe"

local r, l, F0, d = 0.1, 0.3, 2e3, 0.05
local speed = hobe.ramp{ {0, 0}, {0.2, 20}, {1, 20} }  -- rad/s
local function turned(t)
  return t < 0.2 and 10*(t - 0.2*math.sin(math.pi*t/0.2)/math.pi) or 20*t - 2
end

local steel = { E = 210e9, nu = 0.3, rho = 7850 }
local bar = hobe.rectangle{ width = 0.03, height = 0.03 }
local function link(name, from, to)
  return hobe.beam{ name = name, elements = hobe.param("n", 1), section = bar, material = steel,
                    from = {from, 0, 0}, to = {to, 0, 0} }
end
local function gas(x) return F0*(d/(r + l + d - x))^1.4 end

local across, along = {0, 0, 1}, {0, 1, 0}
local scene = hobe.scene{
  link("crank", 0, r), link("rod", r, r + l),
  hobe.support{ "crank", at = 0, kind = "revolute", axis = across, angular_velocity = speed,
                name = "shaft" },
  hobe.joint{ "crank", "rod", at = {1, 0}, kind = "revolute", axis = across },
  hobe.support{ "rod", at = 1, kind = "inplane", axis = along, name = "cylinder" },
  hobe.force{ "rod", at = 1, value = function(_, x) return {-gas(x[1]), 0, 0} end },
}

local rows, states, worst = {}, {}, { x = 0, torque = 0, power = 0 }
local largest = 0
for i = 1, 12 do
  local t = i/12*(2*math.pi + 2)/20                    -- the last ends the turn
  local phi, omega = turned(t), t < 0.2 and 10*(1 - math.cos(math.pi*t/0.2)) or 20
  local s = math.sqrt(l^2 - (r*math.sin(phi))^2)
  local x = r*math.cos(phi) + s
  local torque = -gas(x)*(r*math.sin(phi) + r^2*math.sin(phi)*math.cos(phi)/s)
  local state = hobe.static(scene, { time = t, steps = 2*i })
  local shaft = state:reaction("shaft")
  local slider, moment = state:position("rod", 1), shaft.moment[3]
  largest = math.max(largest, math.abs(torque))
  worst.x = math.max(worst.x, math.abs(slider[1] - x)/r)
  worst.torque = math.max(worst.torque, math.abs(moment - torque))
  worst.power = math.max(worst.power, math.abs(shaft.power - moment*omega))
  rows[i] = { t, phi, x, slider[1], torque, moment, shaft.power }
  states[i] = { state, string.format("%.3f s", t) }
end

hobe.table{
  title = "The slider and the crank: closed forms beside the equilibria",
  columns = { "t, s", "phi, rad", "x, m", "found", "torque, N m", "found", "power, W" },
  rows = rows,
}
hobe.picture{
  file = "crank.png", title = "Crank and slider", states = states, colour = "mises",
  view = { azimuth = -90, elevation = 90 }, columns = 4,
}
hobe.report{
  position = { worst.x, expect = 0, within = 3e-4 },
  torque = { worst.torque/largest, expect = 0, within = 3e-4 },
  power = { worst.power, "W", expect = 0, within = 1e-9*20*largest },
}
