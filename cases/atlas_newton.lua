-- Atlas of failures: Newton's iteration from zero against the size of the load, and what it finds.
--
-- One step with neither line search nor cut-back, with line search alone, with both (hobe.static
-- as it is), and the power series of the path, which does not leave it.  Bending is easy, to 1000
-- EI/L^2; torsion fails from two turns on.  With cut-backs it gets further, and at 31 kNm to a
-- state off the path: 33 rad instead of 29, walls turned nearly inside out, nine negative
-- eigenvalues instead of six.  Nothing is lost that is not said: no equilibrium is a sentence that
-- says how far it got, and an equilibrium that is not stable, whichever it is, is warned of.
--
-- A straight column stays straight under any load: above Euler's it is unstable, and warned of;
-- pushed aside by a thousandth of the load it bends away, stable, along its path, by series;
-- Newton finds the state on the other side, near straight, unstable, and warned of, too.  Above
-- its limit load a shallow arch (cases/arch.lua) jumps over to the other side: stable, but reached
-- by no path of rising load, as hobe.path says by its limit points.
local hobe = require "hobe"

local E, h = 1e9, 0.1
local section = hobe.square{ side = h }
local EI = E*section.Iyy

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

-- ---- against the size of the load --------------------------------------------------------------

local function elastica(a)
  return bar(10, 0, hobe.force{ "bar", at = 1, value = {0, 0, a*EI/100} })
end

local function torsion(M)
  return bar(5, 0.3, hobe.moment{ "bar", at = 1, value = {1e3*M, 0, 0} })
end

local function sag(r) return r:displacement("bar", 1)[3] end
local function twist(r) return r:twist("bar", 1) end

local rows, unsaid, found = {}, 0, {}
for _, problem in ipairs{ { "elastica, EI/L^2", elastica, sag, { 1, 10, 100, 1000 } },
                          { "torsion, kNm", torsion, twist, { 1, 2, 5, 10, 31 } } } do
  local name, make, value, loads = table.unpack(problem)
  for _, load in ipairs(loads) do
    local scene = make(load)
    local path = hobe.path(scene, { method = "series" })
    local truth = value(path[#path])
    for _, way in ipairs(ways) do
      local ok, r = pcall(hobe.static, scene, { line_search = way.line_search,
                                                smallest_step = way.smallest_step })
      local row = { name, load, way[1], ok and r.iterations, ok and r.cutbacks,
                    ok and value(r), truth, ok and r.negative,
                    ok and r.smallest_volume }
      if not ok then row = { name, load, way[1], nil, nil, "refused", truth } end
      rows[#rows + 1] = row
      found[name] = (found[name] or 0) + (ok and 1 or 0)
      if ok and r.negative == 0 then
        unsaid = math.max(unsaid, math.abs(value(r)/truth - 1))
      end
    end
  end
end
hobe.table{
  title = "From zero to the whole load", rows = rows, file = "loads.csv",
  columns = { "", "load", "with", "iterations", "cut-backs", "value", "on the path", "negative",
              "least det F" },
}
-- ---- a bifurcation -----------------------------------------------------------------------------

local L = 5
local euler = math.pi^2*EI/(4*L^2)
local function column(f, aside)                       -- under f times Euler's load
  local P = f*euler
  return bar(L, 0, hobe.force{ "bar", at = 1, value = {-P, 0, aside*P} })
end

local counts, marks = { 0, 0, 0 }, { { {}, {} }, { {}, {} }, { {}, {} } }
rows = {}
for i, f in ipairs{ 0.5, 0.9, 1.1, 1.5, 2 } do
  rows[i] = { f }
  for j, r in ipairs{ hobe.static(column(f, 0)), hobe.static(column(f, 1e-3)),
                       hobe.static(column(f, 1e-3), { method = "series" }) } do
    table.insert(rows[i], sag(r)/L)
    table.insert(rows[i], r.negative)
    counts[j] = counts[j] + (r.negative > 0 and 1 or 0)
    table.insert(marks[j][1], sag(r)/L)
    table.insert(marks[j][2], f)
  end
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
    { label = "pushed aside, one step", style = "points", x = marks[2][1], y = marks[2][2] },
    { label = "by series", style = "points", x = marks[3][1], y = marks[3][2] } },
}

-- ---- a limit point -----------------------------------------------------------------------------

local function arch(P)
  return hobe.scene{
    hobe.beam{ name = "arch", element = "MGD30", elements = 16,
               section = hobe.rectangle{ width = 0.05, height = 0.01 },
               material = { E = 70e9, nu = 0 },
               curve = function(t)
                 local a = 0.1*(2*t - 1)
                 return { 10*math.sin(a), 0, 10*math.cos(a) }
               end },
    hobe.clamp{ "arch", at = 0 }, hobe.clamp{ "arch", at = 1 },
    hobe.force{ "arch", at = 1/2, value = {0, 0, -P} } }
end
local path = hobe.path(arch(1500), { arc = 0.3 })
local limit = path.limit_points[1].load*1500
rows = {}
for i, f in ipairs{ 0.5, 0.9, 1.1, 1.5 } do
  local ok, r = pcall(hobe.static, arch(f*limit))
  rows[i] = { f, ok and -r:displacement("arch", 1/2)[3] or "refused", ok and r.negative or nil }
end
hobe.table{ title = string.format("A shallow arch; its limit load is %.5g N", limit), rows = rows,
            columns = { "P/limit", "crown, m", "negative" } }
hobe.report{
  unsaid = { unsaid, "", expect = 0, within = 1e-6 },            -- the tolerance of the residual
  elastica = { found["elastica, EI/L^2"], "of 12", expect = 12 },
  torsion = { found["torsion, kNm"], "of 15", expect = 11 },
  straight = { counts[1], "unstable", expect = 3 },
  one_step = { counts[2], "unstable", expect = 3 },
  series = { counts[3], "unstable", expect = 0 },
  limits = { #path.limit_points, "", expect = 2 },
}
