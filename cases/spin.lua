-- Beams that turn steadily: the centrifugal force stretches and stiffens them.
--
-- Simo & Vu-Quoc 1987, J. Sound Vib. 119, 487 (after Kane, Ryan & Banerjee 1987, J. Guid. Contr.
-- Dyn. 10, 139): L 10 m, EA 2.8e7 N, EI 1.4e4 N m^2, rho A 1.2 kg/m, turning at 6 rad/s about its
-- root, where they read a steady extension of 5.14e-4 m off a finite-strain rod.  As a square bar,
-- 8 x MGD30.  Expected: the extension of the rod that this element is along its axis, S = E e with
-- Green-Lagrange's strain e, by shooting; and frequencies of an independent prototype.
--
-- A slender bar, h/L = 1/400: Euler and Bernoulli's rotating beam.  First flapping frequencies of
-- Wright, Smith, Thresher & Wang 1982, J. Appl. Mech. 49, 197; higher ones by the power series of
--
--     w'''' - eta^2/2 ((1 - x^2) w')' = mu^2 w,
--
-- eta and mu speed and frequency in sqrt(EI/(rho A))/L^2; lag is mu^2 - eta^2 (Southwell).  The
-- diagram (Campbell's) shows where multiples of the speed meet frequencies.
--
-- Shafts that turn about their own axis at w: in the turning frame a round one whirls with omega - w
-- and omega + w; a flat one, with a < b for omega in its two planes, moves as exp(lambda t),
--
--     lambda^4 + (a^2 + b^2 + 2 w^2) lambda^2 + (a^2 - w^2)(b^2 - w^2) = 0,
--
-- and is unstable for w from a to b (Smith 1933, Proc. R. Soc. A 142, 92).
local hobe = require "hobe"

-- ---- the bar of the spin-up --------------------------------------------------------------------

local L, A, E, rho, speed = 10, 0.006, 4.6666667e9, 200, 6
local side = math.sqrt(A)

local function bar(w)
  return hobe.scene{
    hobe.beam{
      name = "bar", element = "MGD30", elements = hobe.param("n", 8),
      section = hobe.rectangle{ width = side, height = side },
      material = { E = E, nu = 0, rho = rho, k2 = 0.714286, k3 = 0.714286 },
      from = {0, 0, 0}, to = {L, 0, 0},
    },
    hobe.clamp{ "bar", at = 0, warping = "free" },
    hobe.spin{ axis = {0, 0, 1}, speed = w },
  }
end

-- Extension of the rod with N = E A s (s^2 - 1)/2, s = x', N' = -rho A w^2 x, x(0) = 0, N(L) = 0.
local function rod(w)
  local c = 2*rho*w^2/E
  local function ends(s0)                              -- Runge and Kutta's rule; N ~ g = s^3 - s
    local x, s, steps = 0, s0, 400
    local h = L/steps
    local function rate(x, s) return s, -c*x/(3*s^2 - 1) end
    for _ = 1, steps do
      local x1, s1 = rate(x, s)
      local x2, s2 = rate(x + h/2*x1, s + h/2*s1)
      local x3, s3 = rate(x + h/2*x2, s + h/2*s2)
      local x4, s4 = rate(x + h*x3, s + h*s3)
      x = x + h/6*(x1 + 2*x2 + 2*x3 + x4)
      s = s + h/6*(s1 + 2*s2 + 2*s3 + s4)
    end
    return s, x - L
  end
  local s0 = 1
  for _ = 1, 4 do s0 = s0 - (ends(s0) - 1) end         -- ds/ds0 is 1 + O(1e-4)
  return select(2, ends(s0))
end

local scene = bar(speed)
local steady = hobe.static(scene)
local at_rest, turning = hobe.modal(scene), hobe.modal(scene, { state = steady, modes = 4 })
local extension = steady:displacement("bar", 1)[1]

-- ---- a slender blade ---------------------------------------------------------------------------

-- Zero where mu is a flapping frequency at eta: w = sum a_k x^k with w''(1) = w'''(1) = 0.
local function determinant(eta, mu)
  local function column(first)                         -- a_2 or a_3 is 1
    local a = { [0] = 0, 0, 0, 0 }
    a[first] = 1
    local bend, shear = 0, 0
    for k = 0, 160 do
      -- ((1 - x^2) w')' has the coefficient (k + 2)(k + 1) a_(k+2) - k (k + 1) a_k
      a[k + 4] = (eta^2/2*((k + 2)*(k + 1)*a[k + 2] - k*(k + 1)*a[k]) + mu^2*a[k])
                 / ((k + 4)*(k + 3)*(k + 2)*(k + 1))
      bend = bend + (k + 2)*(k + 1)*a[k + 2]
      shear = shear + (k + 3)*(k + 2)*(k + 1)*a[k + 3]
    end
    return bend, shear
  end
  local b2, s2 = column(2)
  local b3, s3 = column(3)
  return b2*s3 - b3*s2
end

-- The first flapping frequencies at eta.
local function flapping(eta, count)
  local found, mu, last = {}, 0.5, determinant(eta, 0.5)
  while #found < count do
    local next = determinant(eta, mu + 0.5)
    if next*last < 0 then
      local low, high = mu, mu + 0.5
      for _ = 1, 50 do
        local middle = (low + high)/2
        if determinant(eta, middle)*last > 0 then low = middle else high = middle end
      end
      found[#found + 1] = low
    end
    mu, last = mu + 0.5, next
  end
  return found
end

local l, h = 1, 1/400
local unit = math.sqrt(70e9*h^2/12/2700)/l^2           -- rad/s

local function blade(eta)
  return hobe.scene{
    hobe.beam{
      name = "blade", element = "MGD30", elements = 20,
      section = hobe.rectangle{ width = h, height = h },
      material = { E = 70e9, nu = 0, rho = 2700 },
      from = {0, 0, 0}, to = {l, 0, 0},
    },
    hobe.clamp{ "blade", at = 0 },
    hobe.spin{ axis = {0, 0, 1}, speed = eta*unit },
  }
end

local flap, lag = { {}, {}, {} }, { {}, {}, {} }        -- [which][i]: mu at the i-th speed
local wright = { 3.5160, 3.6816, 4.1373, 4.7973, 5.5850, 6.4495, 7.3604, [13] = 13.1702 }
local etas, rows, highest = {}, {}, 0
for i = 1, 13 do
  local eta = i - 1
  local s = blade(eta)
  local m = hobe.modal(s, { state = hobe.static(s), modes = 6 })
  local flaps, lags = 0, 0
  etas[i] = eta
  for k = 1, m.count do
    local u = m:shape(k, "blade", 1)
    if math.abs(u[3]) > math.abs(u[2]) then
      flaps = flaps + 1
      flap[flaps][i] = m:frequency(k)/unit
    else
      lags = lags + 1
      lag[lags][i] = m:frequency(k)/unit
    end
  end
  local exact = flapping(eta, 3)
  for k = 1, 3 do
    highest = math.max(highest, math.abs(flap[k][i]/exact[k] - 1),
                       math.abs(lag[k][i]/math.sqrt(exact[k]^2 - eta^2) - 1))
  end
  rows[i] = { eta, flap[1][i], exact[1], wright[i] or "", flap[2][i], exact[2], lag[1][i],
              math.sqrt(exact[1]^2 - eta^2) }
end

hobe.table{
  title = "Frequencies of the slender blade, in sqrt(EI/(rho A))/L^2",
  columns = { "speed", "flap 1", "series", "Wright et al.", "flap 2", "series", "lag 1",
              "series" },
  rows = rows,
}

local curves = {}
for k = 1, 2 do
  curves[#curves + 1] = { label = "flap " .. k, x = etas, y = flap[k], colour = 1 }
  curves[#curves + 1] = { label = "lag " .. k, x = etas, y = lag[k], colour = 2 }
end
for k = 1, 4 do
  curves[#curves + 1] = { label = k .. " a turn", x = { 0, 12 }, y = { 0, 12*k }, colour = 0 }
end
curves[#curves + 1] = {
  label = "Wright et al.", style = "points", colour = 1,
  x = { 0, 1, 2, 3, 4, 5, 6, 12 }, y = { table.unpack(wright, 1, 7) },
}
table.insert(curves[#curves].y, wright[13])
hobe.plot{
  file = "campbell.png", title = "Frequencies of a turning blade",
  xlabel = "speed, sqrt(EI/(rho A))/L^2", ylabel = "frequency, sqrt(EI/(rho A))/L^2",
  series = curves,
}

-- ---- shafts ------------------------------------------------------------------------------------

local function shaft(section, w)
  local s = hobe.scene{
    hobe.beam{
      name = "shaft", element = "MGD30", elements = 6, section = section,
      material = { E = 210e9, nu = 0.3, rho = 7850 },
      from = {0, 0, 0}, to = {2, 0, 0},
    },
    hobe.clamp{ "shaft", at = 0 },
    hobe.spin{ axis = {1, 0, 0}, speed = w },
  }
  return hobe.modal(s, { state = hobe.static(s), modes = 2 }), hobe.modal(s, { modes = 2 })
end

local w = 20
local round, still = shaft(hobe.circle{ radius = 0.02 }, w)
local omega = still:frequency(1)
local crest, quarter = round:shape(1, "shaft", 1), round:quadrature(1, "shaft", 1)
local _, at_rest_flat = shaft(hobe.rectangle{ width = 0.04, height = 0.05 }, 0)
local a, b = at_rest_flat:frequency(1), at_rest_flat:frequency(2)
local between = (a + b)/2
local flat = shaft(hobe.rectangle{ width = 0.04, height = 0.05 }, between)
local half = (a^2 + b^2)/2 + between^2
local growth = math.sqrt(math.sqrt(half^2 - (a^2 - between^2)*(b^2 - between^2)) - half)

-- Wright et al. have four digits; the blade stretches by 4e-5 of its length, and shears.
-- The inertia of the shafts' sections is of the order (h/L)^2 = 4e-4.
hobe.report{
  extension   = { extension, "m", expect = rod(speed), within = 1e-6 },
  in_plane    = { turning:frequency(1), "rad/s", expect = 4.512, within = 1e-3 },
  out_of_plane = { turning:frequency(2), "rad/s", expect = 7.507, within = 1e-3 },
  at_rest     = { at_rest:frequency(1), "rad/s", expect = 3.798, within = 1e-3 },
  flap_at_6   = { flap[1][7], "", expect = 7.3604, within = 2e-5 },
  flap_at_12  = { flap[1][13], "", expect = 13.1702, within = 2e-5 },
  from_series = { highest, "" },
  forward     = { round:frequency(1), "rad/s", expect = omega - w, within = 1e-3 },
  backward    = { round:frequency(2), "rad/s", expect = omega + w, within = 1e-3 },
  whirl       = { round:whirl(1) - round:whirl(2), "", expect = 2, within = 1e-3 },
  circle      = { math.sqrt((quarter[2]^2 + quarter[3]^2)/(crest[2]^2 + crest[3]^2)), "",
                  expect = 1, within = 1e-6 },
  unstable    = { flat.unstable, "", expect = 1, within = 1e-9 },
  growth      = { flat:growth(1), "1/s", expect = growth, within = 2e-3 },
}
