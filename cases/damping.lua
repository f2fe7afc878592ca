-- A cantilever that a spring props: at rest, its vibration, and how it comes to rest.
--
-- Source: Euler and Bernoulli's beam, EI w'''(L) = k w(L) - F.  A force F at the tip moves it by
-- F/(3 EI/L^3 + k).  The natural frequencies are sqrt(EI/(rho A)) (x/L)^2 with 1 + cos x cosh x =
-- k L^3/EI (cos x sinh x - sin x cosh x)/x^3.  Viscous material, tau dE/dt beside E (Kelvin, Voigt), and a damper c = tau k beside
-- the spring leave the mode as it is and damp it by exp(-zeta omega t), zeta = tau omega/2: after
-- each period by the logarithmic decrement 2 pi zeta/sqrt(1 - zeta^2).  Theory leaves out shear and
-- rotary inertia: 1e-4 of a beam 100 heights long.
local hobe = require "hobe"

local n, element = hobe.param("n", 8), hobe.param("element", "MGD30w")
local E, rho, L, h, F = 210e9, 7850, 1, 0.01, 1e-3
local I, A = h^4/12, h^2
local k = 5*E*I/L^3

-- The x between a and b where the frequency equation holds.
local function root(a, b)
  local function f(x)
    local c, s = math.cos(x), math.sin(x)
    local cosh, sinh = (math.exp(x) + math.exp(-x))/2, (math.exp(x) - math.exp(-x))/2
    return 1 + c*cosh - k*L^3/(E*I)*(c*sinh - s*cosh)/x^3
  end
  for _ = 1, 60 do
    local x = (a + b)/2
    if f(a)*f(x) > 0 then a = x else b = x end
  end
  return a
end

local omega = {}
for i, bracket in ipairs{{1, 3.9}, {3.9, 6}, {6, 9}} do
  omega[i] = math.sqrt(E*I/(rho*A))*(root(bracket[1], bracket[2])/L)^2
end

local zeta = 0.05
local tau = 2*zeta/omega[1]
local scene = hobe.scene{
  hobe.beam{ name = "beam", element = element, elements = n,
             section = hobe.rectangle{ width = h, height = h },
             material = { E = E, nu = 0, rho = rho }, damping = { stiffness = tau },
             from = {0, 0, 0}, to = {L, 0, 0} },
  hobe.clamp{ "beam", at = 0, warping = "free" },
  hobe.spring{ "beam", at = 1, kind = "bushing", name = "prop",
               stiffness = {0, 0, k}, damping = {0, 0, tau*k} },
  hobe.force{ "beam", at = 1, value = {0, 0, F} },
}

local rest = hobe.static(scene)
local modes = hobe.modal(scene, { modes = 8 })

-- Frequencies of bending in z: those of modes that move along z.
local found = {}
for i = 1, modes.count do
  if modes:effective_mass(i)[3] > 1e-6 then found[#found + 1] = modes:frequency(i) end
end

-- From the reference the tip swings about where it comes to rest.  Higher modes are damped more, and
-- gone after two periods; then so is a share of the first with each.
local period = 2*math.pi/(omega[1]*math.sqrt(1 - zeta^2))
local d = hobe.dynamic(scene, { to = 3*period, step = period/400, store = period, rho = 0.9 })
local function off(i)
  return d:state(i):displacement("beam", 1)[3] - rest:displacement("beam", 1)[3]
end

hobe.report{
  tip       = { rest:displacement("beam", 1)[3], "m", expect = F/(3*E*I/L^3 + k), within = 1e-3 },
  prop      = { rest:spring("prop").force[3], "N", expect = F*k/(3*E*I/L^3 + k), within = 1e-3 },
  omega_1   = { found[1], "rad/s", expect = omega[1], within = 1e-3 },
  omega_2   = { found[2], "rad/s", expect = omega[2], within = 1e-3 },
  omega_3   = { found[3], "rad/s", expect = omega[3], within = 1e-3 },
  decrement = { math.log(off(3)/off(4)), nil, within = 2e-3,
                expect = 2*math.pi*zeta/math.sqrt(1 - zeta^2) },
}
