-- A rubber rod is thrown by its end and flies on, bent and spinning: what free motion keeps.
--
-- Noether's theorem: with no loads and no supports, momentum, angular momentum and energy last.
-- Two pushes by ramps up and down, of the force F and 2 T long in all, leave the momentum F T
-- whatever the rod does (Newton).  Of the three the integrator keeps momentum to rounding: mass is
-- constant, and inner forces sum to nothing; it loses angular momentum and energy by errors of the
-- second order, which halved steps quarter.
local hobe = require "hobe"

local L, side, T = 1, 0.02, 0.1                       -- m, m, s
local push, across = 0.8, 0.4                         -- N
local step = hobe.param("step", 2e-3)                 -- s
local to = hobe.param("to", 1)

local throw = hobe.ramp{ {0, 0}, {T, 1}, {2*T, 0} }
local scene = hobe.scene{
  hobe.beam{
    name = "rod", element = hobe.param("element", "MGD30"), elements = hobe.param("n", 8),
    section = hobe.square{ side = side }, material = { E = 5e6, nu = 0.3, rho = 1100 },
    from = {0, 0, 0}, to = {L, 0, 0},
  },
  hobe.force{ "rod", at = 0, value = {0, 0, push}, history = throw },
  hobe.force{ "rod", at = 1, value = {0, across, 0}, history = throw },
}

local function norm(v) return math.sqrt(v[1]^2 + v[2]^2 + v[3]^2) end
local function apart(a, b) return norm{ a[1] - b[1], a[2] - b[2], a[3] - b[3] } end

-- The motion, the greatest change of what should last since the rod is free, relative, and that of
-- the momentum against the push.
local function fly(h, rho)
  local d = hobe.dynamic(scene, { to = to, step = h, rho = rho, store = 0.01 })
  local lost = { momentum = 0, angular = 0, energy = 0 }
  local free
  for i, t in ipairs(d.times) do
    local e = d:energies(i)
    if t > 2*T - 1e-9 then
      free = free or e
      lost.momentum = math.max(lost.momentum, apart(e.momentum, free.momentum)/norm(free.momentum))
      lost.angular = math.max(lost.angular,
        apart(e.angular_momentum, free.angular_momentum)/norm(free.angular_momentum))
      lost.energy = math.max(lost.energy,
        math.abs(e.balance - free.balance)/(free.kinetic + free.strain))
    end
  end
  lost.thrown = apart(free.momentum, {0, across*T, push*T})/norm(free.momentum)
  return d, lost
end

local rows, order, kept, d = {}, {}, {}, nil
for _, rho in ipairs{ 0.8, 1 } do
  local last
  for halved = 0, 2 do
    local h, lost = step/2^halved, nil
    d, lost = fly(h, rho)
    rows[#rows + 1] = { rho, h, lost.thrown, lost.momentum, lost.angular, lost.energy,
                        last and math.log(last.angular/lost.angular, 2),
                        last and math.log(math.abs(last.energy/lost.energy), 2) }
    order[rho] = { rows[#rows][7], rows[#rows][8] }
    kept[rho] = math.max(kept[rho] or 0, lost.momentum)
    last = lost
  end
end
hobe.table{
  title = "Greatest relative change in free flight, and the order of its fall",
  columns = { "rho", "step, s", "thrown", "momentum", "angular", "energy", "order, angular",
              "order, energy" },
  rows = rows,
}

local states, t, kinetic, strain = {}, {}, {}, {}
for i, time in ipairs(d.times) do
  local e = d:energies(i)
  t[i], kinetic[i], strain[i] = time, e.kinetic, e.strain
  if i % 14 == 1 then states[#states + 1] = { d:state(i), string.format("%.2f s", time) } end
end
hobe.picture{ file = "flight.png", title = "A rod is thrown by its end", states = states,
              colour = "u" }
hobe.plot{
  file = "flight_energy.png", title = "Energies of the rod", xlabel = "t, s", ylabel = "J",
  series = { { x = t, y = kinetic, label = "kinetic" }, { x = t, y = strain, label = "strain" } },
}
hobe.report{
  momentum_08 = { kept[0.8], expect = 0, within = 1e-7 },
  momentum_1 = { kept[1], expect = 0, within = 1e-12 },
  angular_08 = { order[0.8][1], "", expect = 2, within = 0.02 },  -- terms of higher order
  angular_1 = { order[1][1], "", expect = 2, within = 0.02 },
  energy_08 = { order[0.8][2], "", expect = 2, within = 0.02 },
  energy_1 = { order[1][2], "", expect = 2, within = 0.02 },
}
