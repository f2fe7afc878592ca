-- The spin-up of spinup.lua seen from the frame that turns with the beam, with few unknowns.
--
-- Centrifugal force stretches the beam and stiffens it, which linear modes do not know; in the
-- energy of fourth degree that a reduced model keeps it is there, as soon as the basis has what
-- bending does to the length.  The basis is made once, of the paths under a steady turn and under a
-- force like Euler's, across; it then serves every speed.  Expected: the motion of the whole scene
-- by the same steps to 1e-3 of its size with 7 unknowns, and its steady turns, at twice the speed,
-- too, to 1e-4.
local hobe = require "hobe"

local L, T, speed = 10, 15, 6
local side = math.sqrt(0.006)

local function scene(...)
  return hobe.scene{
    hobe.beam{
      name = "bar", element = "MGD30", elements = hobe.param("n", 8),
      section = hobe.rectangle{ width = side, height = side },
      material = { E = 4.6666667e9, nu = 0, rho = 200, k2 = 0.714286, k3 = 0.714286 },
      from = {0, 0, 0}, to = {L, 0, 0},
    },
    hobe.clamp{ "bar", at = 0, warping = "free" },
    ...
  }
end

local function spin(w, history)
  return hobe.spin{ axis = {0, 0, 1}, speed = w, history = history }
end

local function share(t)
  return t > T and 1 or t/T - math.sin(2*math.pi*t/T)/(2*math.pi)
end

-- A force across that grows along the beam as Euler's does, in 8 pieces.
local function across(F)
  local forces = {}
  for i = 1, 8 do
    forces[i] = hobe.force{ "bar", at = i/8, value = { 0, F*(i == 8 and 0.5 or i/8), 0 } }
  end
  return table.unpack(forces)
end

local turning = scene(spin(speed, share))
local basis = hobe.reduce(scene(spin(speed)), {
  modes = hobe.param("modes", 7), loads = { scene(across(-2)) },
})
local times_of = { to = 20, step = hobe.param("step", 0.01), store = 0.1 }
local whole = hobe.dynamic(turning, times_of)
local small = hobe.dynamic(basis:on(turning), times_of)

local times, lags, reduced = {}, {}, {}
local lag, lag_apart, along, along_apart = 0, 0, 0, 0
for i = 1, whole.count do
  local a = whole:state(i):displacement("bar", 1)
  local b = small:state(i):displacement("bar", 1)
  times[i], lags[i], reduced[i] = whole:state(i).time, a[2], b[2]
  lag, lag_apart = math.max(lag, math.abs(a[2])), math.max(lag_apart, math.abs(a[2] - b[2]))
  along, along_apart = math.max(along, math.abs(a[1])), math.max(along_apart, math.abs(a[1] - b[1]))
end
hobe.plot{
  file = "lag.png", title = "The tip across its hinge's direction",
  xlabel = "t, s", ylabel = "m",
  series = {
    { x = times, y = lags, label = "147 unknowns" },
    { x = times, y = reduced, label = "7 unknowns" },
  },
}

-- How well the steady turn at a speed agrees: its stretch, and the first frequency about it.
local function steady(w)
  local a, b = scene(spin(w)), basis:on(scene(spin(w)))
  local p, q = hobe.static(a), hobe.static(b)
  local m, n = hobe.modal(a, { modes = 1, state = p }), hobe.modal(b, { modes = 1, state = q })
  return { q:displacement("bar", 1)[1]/p:displacement("bar", 1)[1], "", expect = 1, within = 1e-4 },
         { n:frequency(1)/m:frequency(1), "", expect = 1, within = 1e-4 }
end
local stretch, frequency = steady(speed)
local stretch_double, frequency_double = steady(2*speed)

hobe.report{
  unknowns         = { basis.unknowns, "" },
  lag              = { 1 - lag_apart/lag, "", expect = 1, within = 1e-3 },
  along            = { 1 - along_apart/along, "", expect = 1, within = 1e-3 },
  stretch          = stretch,
  stretch_double   = stretch_double,
  frequency        = frequency,
  frequency_double = frequency_double,
}
