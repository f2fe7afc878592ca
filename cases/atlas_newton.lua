-- Atlas of failures: Newton's iteration from zero against the size of the load, and what it finds.
--
-- One step with neither line search nor cut-back, with line search alone, with both (hobe.static
-- as it is), beside the power series of the path, which does not leave it.  An iteration that looks
-- as if it had jumped is followed by small steps of the load (runtime/jump.h): bending comes to
-- where theory has it, to 1000 EI/L^2, a column that is pushed aside bends away, and torsion stays
-- on its path, by many turns at the price of thousands of iterations, which steps by series spare.
-- No equilibrium is a sentence that says how far it got.  A straight column stays straight under
-- any load: above Euler's it is unstable, and warned of.
--
-- Above its limit load a shallow arch (cases/arch.lua) jumps over to the other side: stable, but no
-- path of rising load leads there; that is warned of, with the load at which the path turns.
--
-- Expected: under the elastica's loads Reissner's rod, by Runge and Kutta's method and shooting,
-- from which a continuum differs by the square of its strains, at most a h^2/2L^2 under a EI/L^2.
-- Of the column Euler's load with stretch and shear, between a stable and an unstable state:
-- P (1 - P/EA + P/GA) = (1 - 3 P/EA) pi^2 EI/4L^2, Reissner's (1972), but that bending at the
-- stretch 1 - P/EA has the tangent of Green's strain.  Of the arch 403.1 N (Schreyer & Masur 1966).
local hobe = require "hobe"

local E, h = 1e9, 0.1
local section = hobe.square{ side = h }
local EI, EA, GA = E*section.Iyy, E*h^2, E/2*h^2      -- nu = 0

local function bar(L, nu, ...)
  return hobe.scene{
    hobe.beam{ name = "bar", element = "MGD30w", elements = 20, section = section,
               material = { E = E, nu = nu }, from = {0, 0, 0}, to = {L, 0, 0} },
    hobe.clamp{ "bar", at = 0 }, ... }
end

local ways = {
  { "one step", line_search = false, smallest_step = 0.99 },
  { "line search", smallest_step = 0.99 },
  { "and cut-backs" },
}

-- The result of one of the ways, or nil.
local function try(scene, way)
  local ok, r = pcall(hobe.static, scene, { line_search = way.line_search,
                                            smallest_step = way.smallest_step })
  return ok and r or nil
end

-- ---- against the size of the load --------------------------------------------------------------

local function elastica(a)
  return bar(10, 0, hobe.force{ "bar", at = 1, value = {0, 0, a*EI/100} })
end

local function torsion(M)
  return bar(5, 0.3, hobe.moment{ "bar", at = 1, value = {1e3*M, 0, 0} })
end

local function sag(r) return r:displacement("bar", 1)[3] end
local function twist(r) return r:twist("bar", 1) end

-- Reissner's rod from its end, free under P across, to its clamp: the angle from the load, phi,
-- there, and the sag.  phi' = -k, M = EI k, N = P cos phi, Q = P sin phi.
local function rod(P, L, phi)
  local steps, sag, M = 1000, 0, 0
  local function slope(angle, moment)
    local N, Q = P*math.cos(angle), P*math.sin(angle)
    local stretch, shear = 1 + N/EA, Q/GA
    return moment/EI, stretch*Q - shear*N, stretch*math.cos(angle) + shear*math.sin(angle)
  end
  local ds = L/steps
  for _ = 1, steps do
    local a1, m1, z1 = slope(phi, M)
    local a2, m2, z2 = slope(phi + ds/2*a1, M + ds/2*m1)
    local a3, m3, z3 = slope(phi + ds/2*a2, M + ds/2*m2)
    local a4, m4, z4 = slope(phi + ds*a3, M + ds*m3)
    phi, M = phi + ds/6*(a1 + 2*a2 + 2*a3 + a4), M + ds/6*(m1 + 2*m2 + 2*m3 + m4)
    sag = sag + ds/6*(z1 + 2*z2 + 2*z3 + z4)
  end
  return phi, sag
end

-- Its sag where the clamp is across the load; the end's angle by halving its logarithm.
local function rod_sag(P, L)
  local low, high = -60, math.log(math.pi/2)
  for _ = 1, 50 do
    local middle = (low + high)/2
    if rod(P, L, math.exp(middle)) < math.pi/2 then low = middle else high = middle end
  end
  local _, sag = rod(P, L, math.exp(low))
  return sag
end

local rows, off, found, theory = {}, 0, {}, 0
for _, problem in ipairs{ { "elastica, EI/L^2", elastica, sag, { 1, 10, 100, 1000 } },
                          { "torsion, kNm", torsion, twist, { 1, 2, 5, 10, 31 } } } do
  local name, make, value, loads = table.unpack(problem)
  for _, load in ipairs(loads) do
    local scene = make(load)
    local path = hobe.path(scene, { method = "series" })
    local truth = value(path[#path])
    local exact = make == elastica and rod_sag(load*EI/100, 10) or nil
    if exact then
      theory = math.max(theory, math.abs(truth/exact - 1)/(load*h^2/200))
    end
    for _, way in ipairs(ways) do
      local r = try(scene, way)
      rows[#rows + 1] = { name, load, way[1], r and r.iterations, r and r.cutbacks,
                          r and value(r) or "refused", truth, exact, r and r.negative,
                          r and r.smallest_volume }
      found[name] = (found[name] or 0) + (r and 1 or 0)
      off = r and math.max(off, math.abs(value(r)/truth - 1)) or off
    end
  end
end
hobe.table{
  title = "From zero to the whole load", rows = rows, file = "loads.csv",
  columns = { "", "load", "with", "iterations", "cut-backs", "value", "on the path", "theory",
              "negative", "least det F" },
}

-- ---- a bifurcation -----------------------------------------------------------------------------

local L = 5
local inextensible = math.pi^2*EI/(4*L^2)
local c, b = 1/GA - 1/EA, 1 + 3*inextensible/EA       -- c P^2 + b P = Euler's
local euler = (math.sqrt(b^2 + 4*c*inextensible) - b)/(2*c)
local function column(f, aside)                       -- under f times Euler's load
  local P = f*euler
  return bar(L, 0, hobe.force{ "bar", at = 1, value = {-P, 0, aside*P} })
end

local counts, marks = { 0, 0, 0 }, { { {}, {} }, { {}, {} }, { {}, {} } }
local aside = 0
rows = {}
for i, f in ipairs{ 0.5, 0.9, 1 - 1e-5, 1 + 1e-5, 1.5, 2 } do
  rows[i] = { f }
  local states = { hobe.static(column(f, 0)), hobe.static(column(f, 1e-3)),
                   hobe.static(column(f, 1e-3), { method = "series" }) }
  for j, r in ipairs(states) do
    table.insert(rows[i], sag(r)/L)
    table.insert(rows[i], r.negative)
    counts[j] = counts[j] + (r.negative > 0 and 1 or 0)
    table.insert(marks[j][1], sag(r)/L)
    table.insert(marks[j][2], f)
  end
  aside = math.max(aside, math.abs(sag(states[2]) - sag(states[3]))/L)
end
hobe.table{
  title = "A column under P", rows = rows,
  columns = { "P/Euler's", "straight: sag/L", "negative", "pushed aside", "negative",
              "by series", "negative" },
}
local bent, load = { 0 }, { 0 }
for i, point in ipairs(hobe.path(column(2, 1e-3), { method = "series", arc = 20 })) do
  bent[i + 1], load[i + 1] = sag(point)/L, 2*point.load
end
hobe.plot{
  file = "newton.png", title = "A column, and where Newton finds it",
  xlabel = "sag of its end/L", ylabel = "P/Euler's load", series = {
    { label = "path, pushed aside by P/1000", x = bent, y = load },
    { label = "straight", style = "points", x = marks[1][1], y = marks[1][2] },
    { label = "pushed aside, one step", style = "points", x = marks[2][1], y = marks[2][2] } },
}

-- ---- a limit point -----------------------------------------------------------------------------

local function arch(P)
  return hobe.scene{
    hobe.beam{ name = "arch", element = "MGD30", elements = 24,
               section = hobe.rectangle{ width = 0.05, height = 0.01 },
               material = { E = 70e9, nu = 0 },
               curve = function(t)
                 local a = 0.1*(2*t - 1)
                 return { 10*math.sin(a), 0, 10*math.cos(a) }
               end },
    hobe.clamp{ "arch", at = 0 }, hobe.clamp{ "arch", at = 1 },
    hobe.force{ "arch", at = 1/2, value = {0, 0, -P} } }
end
local function crown(r) return -r:displacement("arch", 1/2)[3] end

local path = hobe.path(arch(800), { arc = 0.2 })
local limit = path.limit_points[1].load*800
local down, P = { 0 }, { 0 }
for i, point in ipairs(path) do down[i + 1], P[i + 1] = crown(point), 800*point.load end
local turns = down[path.limit_points[1].after + 1]

local said, silent, turned = 0, 0, 0
local on, beyond = { x = {}, y = {} }, { x = {}, y = {} }
rows = {}
for _, f in ipairs{ 0.5, 0.9, 1.05, 1.5, 5, 50 } do
  for _, way in ipairs(ways) do
    local r = try(arch(f*limit), way)
    local at = r and r.limit_load > 0 and r.limit_load*f*limit or nil
    rows[#rows + 1] = { f, way[1], r and r.iterations, r and r.cutbacks,
                        r and crown(r) or "refused", r and r.negative, at }
    if r and crown(r) > 2*turns then
      said, silent = said + (at and 1 or 0), silent + (at and 0 or 1)
    end
    if at then turned = math.max(turned, math.abs(at/limit - 1)) end
    if r and f < 2 then
      local to = at and beyond or on
      table.insert(to.x, crown(r))
      table.insert(to.y, f*limit)
    end
  end
end
hobe.table{
  title = string.format("A shallow arch; its limit load is %.5g N", limit), rows = rows,
  columns = { "P/limit", "with", "iterations", "cut-backs", "crown, m", "negative",
              "said to turn at, N" },
}
hobe.plot{
  file = "jump.png", title = "A shallow arch, and where hobe.static finds it",
  xlabel = "way down of its crown, m", ylabel = "P, N", series = {
    { label = "path", x = down, y = P },
    { label = "found on the path", style = "points", x = on.x, y = on.y },
    { label = "found beyond, with a warning", style = "points", x = beyond.x, y = beyond.y },
    { label = "where it says the path turns", style = "points", x = { turns }, y = { limit } } },
}
hobe.report{
  off_the_path = { off, "", expect = 0, within = 1e-6 },         -- the tolerance of the residual
  theory = { theory, "of the strain squared", expect = 0, within = 1 },
  elastica = { found["elastica, EI/L^2"], "of 12", expect = 12 },
  torsion = { found["torsion, kNm"], "of 15" },
  straight = { counts[1], "of 6 unstable, above Euler's load", expect = 3 },
  pushed = { counts[2] + counts[3], "unstable", expect = 0 },
  aside = { aside, "of L", expect = 0, within = 1e-6 },
  limit = { limit, "N", expect = 403.1, within = 5e-3 },         -- leaves out squares of slopes
  said = { said, "jumps" },
  silent = { silent, "jumps", expect = 0 },
  turned = { turned, "", expect = 0, within = 1e-4 },            -- the path's cubic, by its steps
}
