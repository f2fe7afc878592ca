#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Files for ParaView: well-formed XML whose arrays have the lengths they announce, all finite.
# shellcheck source=tests/cases/check.sh
. "$(dirname "$0")/check.sh"

cat >case.lua <<'END'
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "arm", element = "MGD30w", elements = 3, section = hobe.square{ side = 0.1 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "arm", at = 0 },
  hobe.force{ "arm", at = 1, value = {0, 0, -100} },
}
local r = hobe.static(scene)
hobe.vtk{ file = "one.vtu", state = r }
hobe.vtk{ file = "mode.vtu", mode = { hobe.modal(scene), 2 } }
hobe.vtk{ file = "a & b/steps.pvd", states = { { r, 0.5 }, { r } } }
local d = hobe.dynamic(scene, { to = 0.01, step = 1e-3 })
hobe.vtk{ file = "motion.pvd", motion = d, every = 4 }
hobe.vtk{ file = "fifth.vtu", state = d:state(5) }
END
"$hobe" run case.lua --out out >stdout || exit 1

"$python" - <<'END'
import math
import xml.etree.ElementTree as tree


def arrays(element):
    return {a.get("Name"): (int(a.get("NumberOfComponents")), [float(x) for x in a.text.split()])
            for a in element.iter("DataArray")}


def check(name, names):
    piece = tree.parse("out/" + name).getroot().find("UnstructuredGrid/Piece")
    points, cells = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
    assert cells == 3 * 2 * 2 * 9, cells       # elements, layers, triangles of 3 x 3 squares
    assert points == (2 * 6 + 1) * 7 * 7, points
    data = arrays(piece.find("PointData"))
    assert set(data) == names, set(data)
    data |= arrays(piece.find("Points"))
    for components, numbers in data.values():
        assert len(numbers) == components * points
        assert all(map(math.isfinite, numbers))
    mesh = {key: numbers for key, (_, numbers) in arrays(piece.find("Cells")).items()}
    assert len(mesh["connectivity"]) == 18 * cells
    assert set(mesh["connectivity"]) == set(range(points))
    assert mesh["offsets"] == [18 * (c + 1) for c in range(cells)]
    assert mesh["types"] == [32] * cells


stressed = {"displacement", "stress", "strain", "von Mises"}
check("one.vtu", stressed)
check("mode.vtu", {"displacement"})
series = tree.parse("out/a & b/steps.pvd").getroot().findall("Collection/DataSet")
assert [float(s.get("timestep")) for s in series] == [0.5, 2]
for s in series:
    check("a & b/" + s.get("file"), stressed)
assert [s.get("file") for s in series] == ["steps-0001.vtu", "steps-0002.vtu"]
series = tree.parse("out/motion.pvd").getroot().findall("Collection/DataSet")
assert [s.get("file") for s in series] == [f"motion-000{i}.vtu" for i in (1, 2, 3)]
for s, time in zip(series, (0, 0.004, 0.008), strict=True):
    assert abs(float(s.get("timestep")) - time) < 1e-15   # sums of steps round
    check(s.get("file"), stressed)
with open("out/motion-0002.vtu") as second, open("out/fifth.vtu") as fifth:
    assert second.read() == fifth.read()
END
