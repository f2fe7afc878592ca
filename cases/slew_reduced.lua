-- A robot's flexible arm is slewed by a quarter turn, from rest to rest, with few unknowns.
--
-- Aluminium, 1.2 m, 4 x 60 mm upright, with 0.25 kg at its tip: turned about a vertical axis it bends
-- where it is soft.  The hub follows a cycloid, theta = pi/2 (s - sin(2 pi s)/(2 pi)), s = t/T, whose
-- accelerations begin and end at zero; T is two periods of the arm, so that some of what the slew
-- excites stays, which is what its control is about.  Seen from the hub the arm is a cantilever in a
-- frame that turns at a changing speed (hobe.spin), with Euler's, centrifugal and Coriolis' forces.
--
-- The basis is made of the paths under the inertia of the arm's first two modes in the plane, and
-- under a steady turn.
-- Expected: the tip's motion in the hub's frame, of the whole arm by the same steps, to 1e-3 of its
-- largest deflection; and that of the whole arm on a driven hinge in the frame at rest, which is
-- another way to the same motion, to the square of the step.
local hobe = require "hobe"

local L, width, height, rho, m, quarter = 1.2, 0.004, 0.06, 2700, 0.25, math.pi/2

local function arm(root, ...)
  return hobe.scene{
    hobe.beam{
      name = "arm", element = "MGD30w", elements = hobe.param("elements", 8),
      section = hobe.rectangle{ width = width, height = height },
      material = { E = 70e9, nu = 0.33, rho = rho }, from = {0, 0, 0}, to = {L, 0, 0},
    },
    hobe.mass{ "arm", at = 1, mass = m },
    root, ...
  }
end
local clamp = hobe.clamp{ "arm", at = 0 }

local modes = hobe.modal(arm(clamp), { modes = 2 })     -- both across its width
local T = 2*2*math.pi/modes:frequency(1)
local function angle(t)
  local s = math.min(t/T, 1)
  return quarter*(s - math.sin(2*math.pi*s)/(2*math.pi))
end
local function rate(t)
  return t < T and quarter/T*(1 - math.cos(2*math.pi*t/T)) or 0
end
local fastest = 2*quarter/T

local function spin(speed, history)
  return hobe.spin{ axis = {0, 0, 1}, speed = speed, history = history }
end

-- The inertia of a mode, in eighths of the arm and the tip's mass: forces whose sizes have the sum F.
local function inertia(mode, F)
  local forces, sum = {}, 0
  for i = 1, 8 do
    local mass = rho*width*height*L/8*(i == 8 and 0.5 or 1) + (i == 8 and m or 0)
    forces[i] = mass*modes:shape(mode, "arm", i/8)[2]
    sum = sum + math.abs(forces[i])
  end
  for i = 1, 8 do
    forces[i] = hobe.force{ "arm", at = i/8, value = {0, F*forces[i]/sum, 0} }
  end
  return arm(clamp, table.unpack(forces))
end

local options = { to = 2*T, step = hobe.param("step", T/400), store = T/50 }
local slewed = arm(clamp, spin(1, rate))
local whole = hobe.dynamic(slewed, options)
local basis = hobe.reduce(arm(clamp, spin(fastest)), {
  modes = hobe.param("modes", 7), loads = { inertia(1, 6), inertia(2, 6) },
})
local small = hobe.dynamic(basis:on(slewed), options)
local hinge = hobe.support{ "arm", at = 0, kind = "revolute", axis = {0, 0, 1}, angle = angle }
local driven = hobe.dynamic(arm(hinge), options)

local times, tips, reduced = {}, {}, {}
local largest, apart, frames, left = 0, 0, 0, 0
for i = 1, whole.count do
  local t = whole:state(i).time
  local a = whole:state(i):displacement("arm", 1)
  local b = small:state(i):displacement("arm", 1)
  local p = driven:state(i):position("arm", 1)
  local c, s = math.cos(angle(t)), math.sin(angle(t))
  times[i], tips[i], reduced[i] = t, 1e3*a[2], 1e3*b[2]
  largest, apart = math.max(largest, math.abs(a[2])), math.max(apart, math.abs(a[2] - b[2]))
  frames = math.max(frames, math.abs(c*p[2] - s*p[1] - a[2]))
  if t > T then left = math.max(left, math.abs(a[2])) end
end
hobe.plot{
  file = "slew.png", title = "The arm's tip, seen from its hub", xlabel = "t, s", ylabel = "mm",
  series = {
    { x = times, y = tips, label = "all unknowns" },
    { x = times, y = reduced, label = basis.unknowns .. " unknowns", style = "points" },
  },
}
hobe.report{
  unknowns = { basis.unknowns, "" },
  largest  = { largest, "m" },
  left     = { left, "m" },
  tip      = { 1 - apart/largest, "", expect = 1, within = 1e-3 },
  frames   = { 1 - frames/largest, "", expect = 1, within = 5e-3 },
}
