#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# hobe bench from outside: every column is there, every number is one, files are written.  How long
# anything takes is nobody's business here.
# shellcheck source=tests/cases/check.sh
. "$(dirname "$0")/check.sh"

short="--quick --seconds 0.001"
# shellcheck disable=SC2086 # several options
"$hobe" bench $short --element 3333s,BE24,BE24 --out out --format json >bench.json 2>stderr ||
    complain "the benchmark"
[ ! -s stderr ] || complain "progress, and no terminal"

"$python" - <<'PYTHON' || complain "the results are not what they should be"
import csv, json, math

rows = json.load(open("bench.json"))["bench"]
for row in rows:
    for name, value in row.items():
        if not isinstance(value, str):
            assert math.isfinite(value) and value >= 0, (name, row)
            assert value > 0 or name == "spread, %", (name, row)


def select(**wanted):
    return [r for r in rows if all(r.get(k) == v for k, v in wanted.items())]


for element, baselines in (("BE24", {"points", "eq. 28"}), ("3333s", set())):
    found = select(element=element, kind="baseline")
    assert {r["plan"] for r in found} == baselines, found
    assert len(found) == 2 * len(baselines)
    sections = {"rectangle", "angle", "arc", "taper"}
    for task in ("force", "force, tangent"):
        kernels = select(element=element, kind="kernel", task=task)
        assert {r["section"] for r in kernels} == sections, kernels
        assert len([r for r in kernels if r.get("taken") == "yes"]) == len(sections), kernels
        for row in kernels:
            assert ("points / this" in row) == bool(baselines), row
            assert row["section"] == "taper" or row["elements"] == 8, row
        assert all("% of peak" in r for r in kernels if r["section"] == "rectangle")
    for n in (24, 240, 1000):
        steps = {r["task"] for r in select(element=element, kind="scene", elements=n)}
        assert steps == {"set-up", "residual", "residual, tangent", "factor", "solve",
                         "Newton iteration"}, steps
    assert "bytes per element" in select(element=element, task="Newton iteration",
                                         elements=1000)[0]
    table6, = select(element=element, kind="table 6")
    assert table6["elements"] == (38 if element == "BE24" else 24)
    reduced = select(element=element, kind="reduced")
    assert {r["elements"] for r in reduced} == ({20, 100} if baselines else set()), reduced
    for n in {r["elements"] for r in reduced}:
        rest = [r for r in reduced if r["elements"] == n and "offline, s" in r]
        assert [r["dofs"] for r in rest] == [6, 12, 20, 27, 35], rest
        assert all("whole / this" in r and "tensor, bytes" in r for r in rest), rest
    steps = {r["task"]: r for r in select(element=element, kind="motion")}
    assert set(steps) == {"step", "step, full Newton"}, steps
    assert all(r["elements"] == table6["elements"] for r in steps.values()), steps
    whole = steps["step, full Newton"]
    assert whole["factors per step"] >= whole["iterations per step"], whole
    assert steps["step"]["factors per step"] < whole["factors per step"], steps
assert select(kind="machine")

with open("out/bench.csv", newline="") as file:
    lines = list(csv.DictReader(file))
assert len(lines) == len(rows)
for line, row in zip(lines, rows):
    assert {k: v for k, v in line.items() if v} == {
        k: v if isinstance(v, str) else line[k] for k, v in row.items()}, (line, row)
    assert all(float(line[k]) == v for k, v in row.items() if not isinstance(v, str))
PYTHON

for name in kernels scenes reduced; do
    [ -s out/$name.data.csv ] && [ -s out/$name.gp ] || complain "no figure $name"
    ! command -v gnuplot >/dev/null || [ -s out/$name.png ] || complain "no picture $name"
done

# refuses SENTENCE ARGUMENTS...
refuses() {
    sentence=$1
    shift
    if "$hobe" bench "$@" >stdout 2>stderr; then complain "$* is taken"; fi
    grep -q "^hobe: .*$sentence" stderr || complain "$*"
    [ "$(wc -l <stderr)" -eq 1 ] && [ ! -s stdout ] || complain "$*: more than a sentence"
}
refuses 'unknown element "MGD31w"; known are' --element BE24,MGD31w
refuses 'unknown element ""' --element BE24,
refuses '--seconds must be a number > 0, at most 3600, got "-1"' --seconds -1
refuses '--format must be table, json or csv' --format xml
refuses 'unknown option or missing value: --slow' --slow
refuses 'unknown option or missing value: --element' --element
refuses 'could not be made' --element BE24 --out bench.json

[ "$failed" -eq 0 ] && echo "the benchmarks run"
