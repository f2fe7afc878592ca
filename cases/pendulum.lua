-- A stiff bar swings about a hinge at its end, from level: a compound pendulum.
--
-- Its inertia about the hinge is that of the prism, m (L^2/3 + H^2/12) (any mechanics text).  The
-- angle is that of d2 theta/dt2 = -(m g L/2/I) cos theta by Runge and Kutta's method in a thousand
-- steps; when it hangs it has turned with I w^2/2 = m g L/2, so that the hinge carries
-- m g + m w^2 L/2.  The steps' errors fall as their square: both are extrapolated from two runs.
-- What is left is the elastic bar, which is let go of at once and trembles, 1e-5 of the angle.
local hobe = require "hobe"

local L, W, H, rho, g = 1, 0.03, 0.05, 7850, 9.81
local steps = hobe.param("steps", 100)             -- of a quarter of a period
local m = rho * L * W * H
local I = m * (L^2 / 3 + H^2 / 12)

-- The time after which it hangs, and the angle at a share of that.
local function reference()
  local function rate(x) return { x[2], -m * g * L / 2 / I * math.cos(x[1]) } end
  local function step(x, h)
    local k, sum, y = nil, { 0, 0 }, x
    for i, c in ipairs{ 0.5, 0.5, 1, 0 } do
      k = rate(y)
      y = { x[1] + c * h * k[1], x[2] + c * h * k[2] }
      for a = 1, 2 do sum[a] = sum[a] + ((i == 1 or i == 4) and 1 or 2) * k[a] end
    end
    return { x[1] + h / 6 * sum[1], x[2] + h / 6 * sum[2] }
  end
  local function angle(t)
    local x = { 0, 0 }
    for _ = 1, 1000 do x = step(x, t / 1000) end
    return x[1], x[2]
  end
  local t = 0.6
  for _ = 1, 10 do                                  -- Newton's iteration for theta = -pi/2
    local a, w = angle(t)
    t = t - (a + math.pi / 2) / w
  end
  return t, angle
end

local quarter, exact = reference()

local scene = hobe.scene{
  hobe.beam{
    name = "bar", element = hobe.param("element", "MGD30"), elements = 2,
    section = hobe.rectangle{ width = W, height = H },
    material = { E = 210e9, nu = 0.3, rho = rho },
    from = {0, 0, 0}, to = {L, 0, 0},
  },
  hobe.support{ "bar", at = 0, kind = "revolute", axis = {0, 1, 0}, name = "hinge" },
  hobe.gravity{ 0, 0, -g },
}

local function swing(n)
  local d = hobe.dynamic(scene, { to = quarter, step = quarter / n, store = quarter / 2 })
  local middle, bottom = d:state(2):position("bar", 1), d:state(3):position("bar", 1)
  return math.atan(middle[3], middle[1]), math.atan(bottom[3], bottom[1]),
         d:state(3):reaction("hinge").force[3], d:energies(3)
end

local a1, b1, f1 = swing(steps)
local a2, b2, f2, e = swing(2 * steps)
local function extrapolate(coarse, fine) return fine + (fine - coarse) / 3 end

hobe.report{
  middle = { extrapolate(a1, a2), "rad", expect = (exact(quarter / 2)), within = 1e-4 },
  bottom = { extrapolate(b1, b2), "rad", expect = -math.pi / 2, within = 1e-4 },
  hinge = { extrapolate(f1, f2), "N", expect = m * g * (1 + m * L^2 / 2 / I), within = 1e-3 },
  lost = { e.balance / e.kinetic },
  violation = { e.violation, expect = 0, within = 1e-12 },
}
