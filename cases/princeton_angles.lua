-- Figures 2-4 and Table 6 of Tang, Tian & Hu 2022: the Princeton beam under three loads at seven
-- angles, all elements with the meshes of the paper's Table 5, and the time it takes, each angle
-- starting from its neighbour.
--
-- Reference: MGD30w, 24 elements, by an independent prototype with exact quadrature, in the paper's
-- settings and integrated exactly (mechanics = "axis").  Twist is that of r_z.
-- The pictures show |u3|, |u2| and the twist of all elements, integrated exactly with the default
-- mechanics; the circles are the reference.
-- Long: not run under the sanitizers, where it takes minutes.
local hobe = require "hobe"

local loads, angles = { 4.448, 8.896, 13.345 }, { 0, 15, 30, 45, 60, 75, 90 }   -- N, deg

local elements = {                                   -- meshes of about equal size
  { "BE24", 38 }, { "BE42", 38 }, { "BE24w", 38 }, { "B4", 38 }, { "BE24w-II", 38 },
  { "3333", 24 }, { "3333w", 24 }, { "3363", 24 },
  { "MGD30", 24 }, { "MGD30w", 24 }, { "MGD30w-II", 24 },
  { "3433", 16 }, { "3433w", 16 }, { "34X3", 16 },
}

-- setting, P (N), angle (deg), u1, u2, u3 (m), twist (deg)
local reference = {
  { "paper", 4.448, 0, -3.391992150e-05, 0.000000000e+00, -5.359118238e-03, 0.00000 },
  { "paper", 4.448, 15, -5.436692169e-04, -2.079839896e-02, -5.209051884e-03, 0.22388 },
  { "paper", 4.448, 30, -1.916467340e-03, -3.994528042e-02, -4.748401284e-03, 0.38420 },
  { "paper", 4.448, 45, -3.746482986e-03, -5.605133212e-02, -3.961165455e-03, 0.43819 },
  { "paper", 4.448, 60, -5.526802529e-03, -6.812666041e-02, -2.858140273e-03, 0.37492 },
  { "paper", 4.448, 75, -6.800095011e-03, -7.557050795e-02, -1.500433544e-03, 0.21459 },
  { "paper", 4.448, 90, -7.260034645e-03, -7.808149012e-02, 0.000000000e+00, 0.00000 },
  { "paper", 8.896, 0, -1.356021779e-04, 0.000000000e+00, -1.071456253e-02, 0.00000 },
  { "paper", 8.896, 15, -2.238951669e-03, -4.210456076e-02, -1.061925983e-02, 0.91057 },
  { "paper", 8.896, 30, -7.655699833e-03, -7.942676243e-02, -1.012848087e-02, 1.51916 },
  { "paper", 8.896, 45, -1.438338878e-02, -1.090168074e-01, -8.860758121e-03, 1.67318 },
  { "paper", 8.896, 60, -2.046938734e-02, -1.299096159e-01, -6.626508388e-03, 1.38735 },
  { "paper", 8.896, 75, -2.458300608e-02, -1.422101439e-01, -3.551727482e-03, 0.77747 },
  { "paper", 8.896, 90, -2.602462638e-02, -1.462594157e-01, 0.000000000e+00, 0.00000 },
  { "paper", 13.345, 0, -3.048604293e-04, 0.000000000e+00, -1.606387587e-02, 0.00000 },
  { "paper", 13.345, 15, -5.288662933e-03, -6.442834751e-02, -1.648193498e-02, 2.10493 },
  { "paper", 13.345, 30, -1.714025118e-02, -1.178163053e-01, -1.671874272e-02, 3.34599 },
  { "paper", 13.345, 45, -3.033746854e-02, -1.565236033e-01, -1.525884044e-02, 3.50082 },
  { "paper", 13.345, 60, -4.119250813e-02, -1.818886657e-01, -1.163778210e-02, 2.78836 },
  { "paper", 13.345, 75, -4.807124088e-02, -1.961156878e-01, -6.281427179e-03, 1.52472 },
  { "paper", 13.345, 90, -5.040659667e-02, -2.006922465e-01, 0.000000000e+00, 0.00000 },
  { "exact", 4.448, 0, -3.391992148e-05, 0.000000000e+00, -5.359118238e-03, 0.00000 },
  { "exact", 4.448, 15, -5.433896118e-04, -2.079338626e-02, -5.207680615e-03, 0.21657 },
  { "exact", 4.448, 30, -1.915652777e-03, -3.993772015e-02, -4.743902206e-03, 0.37172 },
  { "exact", 4.448, 45, -3.745438398e-03, -5.604447491e-02, -3.954008622e-03, 0.42404 },
  { "exact", 4.448, 60, -5.526047589e-03, -6.812261130e-02, -2.850740711e-03, 0.36289 },
  { "exact", 4.448, 75, -6.799848390e-03, -7.556931735e-02, -1.495754927e-03, 0.20773 },
  { "exact", 4.448, 90, -7.260032033e-03, -7.808147129e-02, 0.000000000e+00, 0.00000 },
  { "exact", 8.896, 0, -1.356021778e-04, 0.000000000e+00, -1.071456253e-02, 0.00000 },
  { "exact", 8.896, 15, -2.234294799e-03, -4.206375375e-02, -1.060737871e-02, 0.87998 },
  { "exact", 8.896, 30, -7.643302971e-03, -7.937051933e-02, -1.009184919e-02, 1.46912 },
  { "exact", 8.896, 45, -1.436914727e-02, -1.089711447e-01, -8.806730802e-03, 1.61938 },
  { "exact", 8.896, 60, -2.046005123e-02, -1.298851944e-01, -6.574263140e-03, 1.34367 },
  { "exact", 8.896, 75, -2.458014619e-02, -1.422034121e-01, -3.520128553e-03, 0.75333 },
  { "exact", 8.896, 90, -2.602459413e-02, -1.462592922e-01, 0.000000000e+00, 0.00000 },
  { "exact", 13.345, 0, -3.048604288e-04, 0.000000000e+00, -1.606387586e-02, 0.00000 },
  { "exact", 13.345, 15, -5.263560793e-03, -6.428732431e-02, -1.643638022e-02, 2.03088 },
  { "exact", 13.345, 30, -1.708297739e-02, -1.176497589e-01, -1.659323289e-02, 3.23402 },
  { "exact", 13.345, 45, -3.028130245e-02, -1.564086493e-01, -1.509374722e-02, 3.38958 },
  { "exact", 13.345, 60, -4.115984856e-02, -1.818344924e-01, -1.149132036e-02, 2.70325 },
  { "exact", 13.345, 75, -4.806191784e-02, -1.961018209e-01, -6.197262677e-03, 1.47930 },
  { "exact", 13.345, 90, -5.040648068e-02, -2.006919243e-01, 0.000000000e+00, 0.00000 },
}

local section = hobe.rectangle{ width = 3.2024e-3, height = 12.377e-3 }

-- start: a result of the same blade that is near, or nil.
local function run(element, n, P, angle, mechanics, integration, start)
  local a = math.rad(angle)
  local r = hobe.static(hobe.scene{
    hobe.beam{
      name = "blade", element = element, elements = n, section = section,
      material = { E = 71.7e9, nu = 0.31, rho = 2700 },
      from = {0, 0, 0}, to = {0.508, 0, 0}, mechanics = mechanics, integration = integration,
    },
    hobe.clamp{ "blade", at = 0 },
    hobe.force{ "blade", at = 1, value = {0, -P*math.sin(a), -P*math.cos(a)} },
  }, { start = start })
  return r, r:displacement("blade", 1), math.deg(r:twist("blade", 1))
end

-- Against the reference: displacements relative to |u|, twist in degrees.
local report, worst_u, worst_twist = {}, 0, 0
for _, line in ipairs(reference) do
  local integration, P, angle = line[1], line[2], line[3]
  local _, u, twist = run("MGD30w", 24, P, angle, "axis", integration)
  local size = math.sqrt(line[4]^2 + line[5]^2 + line[6]^2)
  for i = 1, 3 do
    worst_u = math.max(worst_u, math.abs(u[i] - line[3 + i])/size)
  end
  worst_twist = math.max(worst_twist, math.abs(twist - line[7]))
end
assert(worst_u < 1e-4, "displacements differ from the reference by more than 1e-4 of |u|")
assert(worst_twist < 0.01, "the twist differs from the reference by more than 0.01 deg")
report.worst_displacement = worst_u
report.worst_twist = { worst_twist, "deg" }

-- The curves and the times.
local times, curves = {}, { u3 = {}, u2 = {}, twist = {} }
local function add_curve(name, colour, style, P, values)
  for quantity, y in pairs(values) do
    local list = curves[quantity]
    list[#list + 1] = { label = P == loads[1] and name or nil, colour = colour, style = style,
                        x = angles, y = y }
  end
end

for colour, item in ipairs(elements) do
  local name, n = item[1], item[2]
  local setup, solve, iterations = 0, 0, 0
  for _, P in ipairs(loads) do
    local u3, u2, phi, r, u, twist = {}, {}, {}
    for i, angle in ipairs(angles) do
      r, u, twist = run(name, n, P, angle, "average", "exact", r)   -- from its neighbour
      u3[i], u2[i], phi[i] = math.abs(u[3])*1e3, math.abs(u[2])*1e3, twist
      setup, solve = setup + r.setup_seconds, solve + r.solve_seconds
      iterations = iterations + r.iterations
      if name == "MGD30w" and P == 13.345 and angle == 30 then
        report.u3_MGD30w = { u[3], "m", expect = -1.659323289e-02, within = 1e-4 }
      end
    end
    add_curve(name, colour, "line", P, { u3 = u3, u2 = u2, twist = phi })
  end
  times[#times + 1] = { name, n, setup, solve, iterations }
  if name == "MGD30w" then
    report.setup_MGD30w, report.solve_MGD30w = { setup, "s" }, { solve, "s" }
  end
end

for _, P in ipairs(loads) do
  local u3, u2, phi = {}, {}, {}
  for _, line in ipairs(reference) do
    if line[1] == "exact" and line[2] == P then
      u3[#u3 + 1], u2[#u2 + 1] = math.abs(line[6])*1e3, math.abs(line[5])*1e3
      phi[#phi + 1] = line[7]
    end
  end
  add_curve("reference", 0, "points", P, { u3 = u3, u2 = u2, twist = phi })
end

hobe.table{
  title = "Table 6: 21 load cases, one core",
  columns = { "element", "elements", "set-up, s", "solve, s", "Newton iterations" },
  rows = times, file = "times.csv",
}
for file, text in pairs{ u3 = "|u3|, mm", u2 = "|u2|, mm", twist = "twist, deg" } do
  hobe.plot{ file = file .. ".png", xlabel = "loading angle, deg", ylabel = text,
             title = "Princeton beam, tip under 4.448, 8.896 and 13.345 N",
             series = curves[file] }
end
hobe.report(report)
