-- A flexible beam, thrown and spinning, flies free.
--
-- Without loads momentum, angular momentum and energy stay what they were (any mechanics text).
-- Generalised alpha keeps momentum to rounding; what it loses of the others falls with the square
-- of the step, four times for half of it, shown here with both ends of the damping that steps may
-- have, rho = 0.8 and 1 (Arnold & Bruls 2007, Multibody Syst. Dyn. 18).
local hobe = require "hobe"

local n = hobe.param("steps", 500)
local time = hobe.param("time", 0.1)                 -- s

local scene = hobe.scene{
  hobe.beam{
    name = "beam", element = hobe.param("element", "MGD30"), elements = 4,
    section = hobe.rectangle{ width = 0.05, height = 0.08 },
    material = { E = 1e8, nu = 0.3, rho = 1000 },
    from = {0, 0, 0}, to = {1, 0, 0},
  },
  hobe.motion{ velocity = {1, 2, 3}, angular_velocity = {5, 20, -10} },
}

local function distance(a, b)
  return math.sqrt((a[1] - b[1])^2 + (a[2] - b[2])^2 + (a[3] - b[3])^2)
end

-- The largest changes over the flight, relative.
local function fly(rho, steps)
  local d = hobe.dynamic(scene, { to = time, step = time / steps, rho = rho, store = time / 250 })
  local first, lost = d:energies(1), { momentum = 0, angular = 0, energy = 0 }
  local zero = {0, 0, 0}
  for i = 2, d.count do
    local e = d:energies(i)
    lost.momentum = math.max(lost.momentum,
      distance(e.momentum, first.momentum) / distance(first.momentum, zero))
    lost.angular = math.max(lost.angular,
      distance(e.angular_momentum, first.angular_momentum) / distance(first.angular_momentum, zero))
    lost.energy = math.max(lost.energy, math.abs(e.balance) / first.kinetic)
  end
  return lost, d
end

local rows, report, last = {}, {}
for _, rho in ipairs{ 0.8, 1 } do
  local coarse, fine
  for _, steps in ipairs{ n, 2 * n } do
    coarse = fine
    fine, last = fly(rho, steps)
    rows[#rows + 1] = { rho, steps, fine.momentum, fine.angular, fine.energy }
  end
  local name = rho == 1 and "full" or "damped"
  report[name .. "_momentum"] = { fine.momentum, expect = 0, within = 1e-12 }
  report[name .. "_angular_ratio"] = { coarse.angular / fine.angular, expect = 4, within = 0.1 }
  report[name .. "_energy_ratio"] = { coarse.energy / fine.energy, expect = 4, within = 0.1 }
end

hobe.table{ title = "What is lost in flight, relative",
            columns = { "rho", "steps", "momentum", "angular momentum", "energy" }, rows = rows }

local t, kinetic, strain = {}, {}, {}
for i = 1, last.count do
  local e = last:energies(i)
  t[i], kinetic[i], strain[i] = e.time, e.kinetic - last:energies(1).kinetic, e.strain
end
hobe.plot{
  file = "flight.png", title = "Energy goes to and fro", xlabel = "time, s", ylabel = "J",
  series = {
    { x = t, y = kinetic, label = "kinetic, less that of the start" },
    { x = t, y = strain, label = "strain" },
  },
}
hobe.report(report)
