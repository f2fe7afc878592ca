-- Table 7 of Tang, Tian & Hu 2022: convergence of the Princeton beam's tip displacement u3 with the
-- number of elements, at P = 13.345 N and 30 degrees, for all the ANCF elements.
--
-- Three numbers side by side: the published one; "paper", recomputed by an independent prototype in
-- the paper's settings (3 x 3 x 3 Gauss points, one term of eq. 33); "exact", the same prototype
-- with full integration and the converged series.  All with mechanics = "axis", the paper's law;
-- 34X3-unsplit is the published "34X3c [28]", unsplit continuum mechanics ("full"), and 3333s the
-- structural element of the same authors, which has its own law and points.
-- Long: not run under the sanitizers, where it takes minutes.
local hobe = require "hobe"

local meshes = { 1, 4, 8, 16, 32, 48 }
-- -u3 in m at 1, 4, 8, 16, 32, 48 elements
local rows = {
  { name = "BE24", element = "BE24", mechanics = "axis",
    published = { 0.007295, 0.013136, 0.013985, 0.014144, 0.014164, 0.014166 },
    paper = { 0.007295, 0.013139, 0.013985, 0.014144, 0.014164, 0.014166 },
  },
  { name = "BE42", element = "BE42", mechanics = "axis",
    published = { 0.007293, 0.013370, 0.015088, 0.015818, 0.016113, 0.016202 },
    paper = { 0.007295, 0.013368, 0.015066, 0.015818, 0.016102, 0.016190 },
  },
  { name = "BE24w", element = "BE24w", mechanics = "axis",
    published = { 0.007293, 0.013398, 0.015251, 0.016155, 0.016537, 0.016654 },
    paper = { 0.007295, 0.013396, 0.015251, 0.016155, 0.016519, 0.016634 },
    exact = { 0.007295, 0.013388, 0.015203, 0.016066, 0.016408, 0.016515 },
  },
  { name = "3333", element = "3333", mechanics = "axis",
    published = { 0.007925, 0.013451, 0.014066, 0.014159, 0.014168, 0.014170 },
    paper = { 0.007973, 0.013451, 0.014065, 0.014159, 0.014167, 0.014168 },
  },
  { name = "3333w", element = "3333w", mechanics = "axis",
    published = { 0.008008, 0.014398, 0.016120, 0.016641, 0.016750, 0.016750 },
    paper = { 0.008012, 0.014388, 0.016120, 0.016621, 0.016750, 0.016779 },
    exact = { 0.008001, 0.014344, 0.016021, 0.016501, 0.016623, 0.016650 },
  },
  { name = "3333s", element = "3333s",
    published = { 0.015532, 0.016771, 0.016777, 0.016777, 0.016777, 0.016777 },
  },
  { name = "MGD30", element = "MGD30", mechanics = "axis",
    published = { 0.012231, 0.014155, 0.014168, 0.014168, 0.014169, 0.014169 },
    paper = { 0.012170, 0.014153, 0.014167, 0.014168, 0.014168, 0.014168 },
    exact = { 0.011582, 0.014149, 0.014167, 0.014168, 0.014168, 0.014168 },
  },
  { name = "MGD30w", element = "MGD30w", mechanics = "axis",
    published = { 0.012711, 0.015960, 0.016424, 0.016664, 0.016752, 0.016779 },
    paper = { 0.012711, 0.015948, 0.016408, 0.016645, 0.016752, 0.016779 },
    exact = { 0.012147, 0.015851, 0.016300, 0.016524, 0.016624, 0.016650 },
  },
  { name = "34X3-unsplit", element = "34X3", mechanics = "full",
    published = { 0.013552, 0.015781, 0.016095, 0.016227, 0.016275, 0.016286 },
    exact = { 0.013556, 0.015779, 0.016095, 0.016227, 0.016275, 0.016286 },
  },
  { name = "34X3", element = "34X3", mechanics = "axis",
    published = { 0.016364, 0.016318, 0.016314, 0.016314, 0.016310, 0.016278 },
    paper = { 0.016364, 0.016318, 0.016314, 0.016314, 0.016315, 0.016315 },
    exact = { 0.014418, 0.016012, 0.016200, 0.016281, 0.016309, 0.016313 },
  },
  { name = "3433w", element = "3433w", mechanics = "axis",
    published = { 0.016852, 0.016811, 0.016802, 0.016798, 0.016793, 0.016756 },
    paper = { 0.016847, 0.016799, 0.016797, 0.016797, 0.016797, 0.016797 },
    exact = { 0.014507, 0.016304, 0.016532, 0.016629, 0.016661, 0.016666 },
  },
}

local section = hobe.rectangle{ width = 3.2024e-3, height = 12.377e-3 }

local function solve(row, n, integration)
  local a = math.rad(30)
  local scene = hobe.scene{
    hobe.beam{
      name = "blade", element = row.element, elements = n, section = section,
      material = { E = 71.7e9, nu = 0.31, rho = 2700 },
      from = {0, 0, 0}, to = {0.508, 0, 0},
      mechanics = row.mechanics, integration = integration,
    },
    hobe.clamp{ "blade", at = 0 },
    hobe.force{ "blade", at = 1, value = {0, -13.345*math.sin(a), -13.345*math.cos(a)} },
  }
  return hobe.static(scene)
end

local function tip(row, n, integration)
  return solve(row, n, integration):displacement("blade", 1)[3]
end

-- The published digits hold to this; 3333 and MGD30 at one element do not (0.6 and 0.5 %), for us
-- as for the prototype, nor does 3333s (1.9 %).
local published_within, recomputed_within = 2.6e-3, 2e-4
local apart = { ["3333"] = true, MGD30 = true, ["3333s"] = true }

local lines, report = {}, {}
local worst = { published = 0, paper = 0, exact = 0 }

-- Prints ours, theirs and the relative difference under each other; ours is also checked.
local function compare(row, setting, ours, within)
  local theirs, line, reference, difference = row[setting], {}, {}, {}
  if not theirs then return end
  line[1], reference[1], difference[1] = row.name, "", ""
  line[2], reference[2], difference[2] = "ours", setting, "difference"
  for i, n in ipairs(meshes) do
    local d = -ours[i]/theirs[i] - 1
    local wrong = setting == "published" and n == 1 and apart[row.name]
    line[i + 2] = string.format("%.6f", -ours[i])
    reference[i + 2] = string.format("%.6f", theirs[i])
    difference[i + 2] = string.format("%+.1e%s", d, wrong and " *" or "")
    if not wrong then
      worst[setting] = math.max(worst[setting], math.abs(d))
      report[row.name .. "_" .. setting .. "_" .. n] =
        { ours[i], "m", expect = -theirs[i], within = within }
    end
  end
  for _, l in ipairs{ line, reference, difference } do lines[#lines + 1] = l end
end

for _, row in ipairs(rows) do
  local paper, exact = {}, {}
  for i, n in ipairs(meshes) do
    paper[i] = row.paper and tip(row, n, "paper")
    exact[i] = tip(row, n, "exact")
  end
  -- the unsplit element and 3333s were not published with the paper's points
  compare(row, "published", row.paper and paper or exact, published_within)
  compare(row, "paper", paper, recomputed_within)
  compare(row, "exact", exact, recomputed_within)
end

hobe.table{
  title = "Table 7: -u3 of the tip, m (* published value not reproduced, not checked)",
  columns = { "element", "", "n = 1", "4", "8", "16", "32", "48" },
  rows = lines, file = "table7.csv",
}

-- The default mechanics beside a solid model (converged quadratic bricks, clamped face, last digit
-- uncertain).  The solid's clamped face also keeps the section from bending across, which beams with
-- plane and warping modes do not feel: they converge to 0.2 % more u2, hence 0.3 % more u1.
local solid = { -0.017064, -0.117537, -0.016657, 3.270 }
local beside = { { "solid", "", solid[1], solid[2], solid[3], solid[4] } }
for _, name in ipairs{ "MGD30w", "3333w", "3433w", "BE24w" } do
  for _, mechanics in ipairs{ "average", "axis" } do
    local r = solve({ element = name, mechanics = mechanics }, 48, "exact")
    local u, difference = r:displacement("blade", 1), {}
    u[4] = math.deg(r:twist("blade", 1))
    for i = 1, 4 do difference[i] = string.format("%+.2f %%", 100*(u[i]/solid[i] - 1)) end
    beside[#beside + 1] = { name, mechanics, u[1], u[2], u[3], u[4] }
    beside[#beside + 1] = { "", "", table.unpack(difference) }
    if name == "MGD30w" and mechanics == "average" then
      report.solid_u1 = { u[1], "m", expect = solid[1], within = 3e-3 }
      report.solid_u2 = { u[2], "m", expect = solid[2], within = 2e-3 }
      report.solid_u3 = { u[3], "m", expect = solid[3], within = 2e-3 }
    end
  end
end
hobe.table{
  title = "48 elements, integrated exactly, beside a solid model",
  columns = { "element", "mechanics", "u1, m", "u2, m", "u3, m", "twist, deg" },
  rows = beside, file = "solid.csv",
}
report.worst_published, report.worst_paper = worst.published, worst.paper
report.worst_exact = worst.exact
hobe.report(report)
