-- A right-angle cantilever vibrates out of its plane, far.
--
-- Simo & Vu-Quoc 1988, Comput. Methods Appl. Mech. Eng. 66, 125: two legs of 10, a force on the
-- elbow that grows to 50 at t = 1 and is gone at t = 2 (no units).  A rod with EA = GA = 1e6, EI =
-- GJ = 1e3, a mass of 1 a length and inertias of its sections of 20 about the axis, 10 across.
--
-- No section of one material has these.  A square of the same EA and EI, nu = 0, has GJ = EI where
-- its sections stay plane, as those of MGD30 do, and GA = EA with a shear factor of 2 on the mean
-- strain.  Its mass is on arms: at the Gauss points of each element four point masses sqrt(20) off
-- the axis, 999/1000 of all mass; theirs is the inertia of the sections.  The sections can stretch
-- and shear, which is stiff.
--
-- They printed curves, no numbers.  Expected: our own, converged (64 elements a leg, steps of
-- 1/160: four digits); 3333, another interpolation, is within 2e-3 of the largest with 32
-- elements.
local hobe = require "hobe"

local n, element = hobe.param("n", 8), hobe.param("element", "MGD30")
local EA, EI, mass, rotary, L = 1e6, 1e3, 1, 10, 10
local side = math.sqrt(12*EI/EA)
local bare = 1e-3                                     -- the share of the mass in the square

local items = {}
local function add(item) items[#items + 1] = item end

local gauss = { {(1 - math.sqrt(3/5))/2, 5/18}, {1/2, 8/18}, {(1 + math.sqrt(3/5))/2, 5/18} }
local function leg(name, from, to)
  add(hobe.beam{
    name = name, element = element, elements = n, section = hobe.square{ side = side },
    material = { E = EA/side^2, nu = 0, rho = bare*mass/side^2, k2 = 2, k3 = 2, k = "average" },
    from = from, to = to,
  })
  local arm = math.sqrt(2*rotary/((1 - bare)*mass))   -- two masses of four are off each axis
  for e = 0, n - 1 do
    for _, point in ipairs(gauss) do
      for _, to in ipairs{ {arm, 0}, {-arm, 0}, {0, arm}, {0, -arm} } do
        add(hobe.mass{ name, at = (e + point[1])/n, y = to[1], z = to[2],
                       mass = (1 - bare)*mass*L/n*point[2]/4 })
      end
    end
  end
end

leg("first", {0, 0, 0}, {L, 0, 0})
leg("second", {L, 0, 0}, {L, L, 0})
add(hobe.join{ "first", "second", at = {1, 0} })
add(hobe.clamp{ "first", at = 0, warping = "free" })
add(hobe.force{ "second", at = 0, value = {0, 0, 50}, history = { {0, 0}, {1, 1}, {2, 0} } })
local scene = hobe.scene(items)
local d = hobe.dynamic(scene, { to = 30, step = hobe.param("step", 0.025), store = 0.1 })

local t, elbow, tip, states, worst = {}, {}, {}, {}, 0
local free = d:energies(21)                           -- at t = 2
for i, time in ipairs(d.times) do
  local state, e = d:state(i), d:energies(i)
  t[i], elbow[i], tip[i] = time, state:displacement("second", 0)[3],
                           state:displacement("second", 1)[3]
  if time > 2 then
    worst = math.max(worst, math.abs(e.kinetic + e.strain - free.kinetic - free.strain))
  end
  if i % 20 == 1 and i > 1 and i < 130 then
    states[#states + 1] = { state, string.format("t = %.0f", time) }
  end
end
hobe.plot{
  file = "right_angle.png", title = "Right-angle cantilever, out of its plane", xlabel = "t",
  ylabel = "u3",
  series = { { x = t, y = elbow, label = "elbow" }, { x = t, y = tip, label = "tip" } },
}
hobe.picture{
  file = "right_angle_states.png", title = "Right-angle cantilever", states = states, colour = "uz",
  view = { azimuth = -60, elevation = 20 }, columns = 3,
}
local function at(series, time) return series[1 + math.floor(10*time + 0.5)] end
hobe.report{
  elbow_3 = { at(elbow, 3), "", expect = 5.5017, within = 2e-3 },      -- 8 elements
  tip_10  = { at(tip, 10), "", expect = 4.4639, within = 4e-3 },
  tip_16  = { at(tip, 16), "", expect = -9.7085, within = 1e-3 },
  elbow_25 = { at(elbow, 25), "", expect = 6.0539, within = 2e-3 },
  energy  = { worst/(free.kinetic + free.strain), "", expect = 0, within = 1e-3 },
}
