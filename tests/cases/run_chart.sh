#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# hobe chart from outside, on tiny ladders: errors and costs of every model, a front that is one,
# commands that give the same numbers again, failures with their sentence.
# shellcheck source=tests/cases/check.sh
. "$(dirname "$0")/check.sh"

cat >case.lua <<'LUA'
local hobe = require "hobe"
local P = hobe.param("P", 10)
hobe.chart{
  truth = { u = P == 10 and -3.2e-2 or nil }, quantities = { "u", "v" },
  ladder = {
    { element = { "BE24", "3333" }, elements = { 1, 2 } },
    { element = "3333", elements = 2, mechanics = "none" }, { elements = 2, element = "3333" },
  },
}
local r = hobe.static(hobe.scene{
  hobe.beam{ name = "a", element = hobe.param("element", "3333"),
             elements = hobe.param("elements", 1), section = hobe.square{ side = 0.01 },
             material = { E = 2e11, nu = 0.3, rho = 7800 }, from = {0, 0, 0}, to = {1, 0, 0},
             mechanics = hobe.param("mechanics", "average") },
  hobe.clamp{ "a", at = 0 }, hobe.force{ "a", at = 1, value = {0, P, -P} },
})
local u = r:displacement("a", 1)
hobe.report{ u = { u[3], "m" }, v = { u[2], "m", expect = 2e-2 }, w = u[1] }
LUA
grep -v truth case.lua | sed '/^  ladder/,/^}/d; /^hobe.chart/d' >plain.lua

"$hobe" chart case.lua --quick --out out --format json >chart.json 2>stderr ||
    complain "the chart"
[ ! -s stderr ] || complain "progress, and no terminal"
"$hobe" chart plain.lua P=5 element=3333,BE24 elements=1,2 --quick >plain.txt 2>stderr ||
    complain "the chart of a plain case"
"$hobe" chart plain.lua element=3333,34X3,MGD30w elements=1,2 integration=exact,paper --quick \
    --format json >any.json 2>stderr || complain "the chart of any case"
"$hobe" chart case.lua --model=MGD30w:2,3333:1:linear --quick --format csv >given.csv 2>stderr ||
    complain "the chart of given models"
[ "$(grep -c -e '^--model=MGD30w:2,' -e '^--model=3333:1:linear,' given.csv)" -eq 2 ] &&
    [ "$(wc -l <given.csv)" -eq 3 ] || complain "models that are given: $(cat given.csv)"

"$python" - "$hobe" <<'PYTHON' || complain "the results are not what they should be"
import csv, json, math, os, random, re, subprocess, sys

rows = json.load(open("chart.json"))["chart"]
assert json.load(open("out/chart.json"))["chart"] == rows
assert {r["model"] for r in rows} == {
    f"element={e} elements={n}" for e in ("BE24", "3333") for n in (1, 2)} | {
    "element=3333 elements=2 mechanics=none"} and len(rows) == 5, rows
assert "failure" in rows[-1] and not any("failure" in r for r in rows[:-1])
assert re.match(r"case.lua:\d+: .*mechanics.*none", rows[-1]["failure"]), rows[-1]
assert set(rows[-1]) == {"model", "failure", "command"}, rows[-1]

best = math.inf
times = [r["time, ms"] for r in rows[:-1]]
assert times == sorted(times) and times[0] > 0
for row in rows[:-1]:
    assert row["set-up, ms"] > 0 and row["solve, ms"] > 0 and row["unknowns"] > 0, row
    assert row["MB"] >= 0 and row["spread, %"] >= 0, row
    u, v = row["error of u"], row["error of v"]
    assert math.isclose(u, abs(row["u"] / -3.2e-2 - 1), rel_tol=1e-12), row
    assert math.isclose(v, abs(row["v"] / 2e-2 - 1), rel_tol=1e-12), row
    assert row["largest error"] == max(u, v)
    assert (row.get("front") == "yes") == (max(u, v) < best), row
    best = min(best, max(u, v))
    command = row["command"].split()
    again = subprocess.run([sys.argv[1], *command[1:], "--format", "json"], check=True,
                           stdout=subprocess.PIPE, text=True).stdout
    report = json.loads(again)["report"]
    assert all(report[q]["value"] == row[q] for q in "uv"), (row, report)

with open("out/chart.csv", newline="") as file:
    lines = list(csv.DictReader(file))
assert [line["command"] for line in lines] == [row["command"] for row in rows]
for line, row in zip(lines, rows):
    assert all(float(line[k]) == v for k, v in row.items() if not isinstance(v, str)), line

# No truth: that of a converged run, how far it has converged said; the parameter in all commands.
plain = open("plain.txt").read()
assert plain.startswith("plain.lua P=5: 4 models, "), plain
assert "each by: hobe run plain.lua P=5 MODEL" in plain
assert re.search(r"of --model=(\w+):8, from which --model=\1:4 differs by \d", plain), plain

# Models of any case by --model; points picked at random are what their commands give.
rows = json.load(open("any.json"))["chart"]
assert {r["model"] for r in rows} == {
    f"--model={e}:{n}{p}" for e in ("3333", "34X3", "MGD30w") for n in (1, 2)
    for p in ("", ":paper")}, rows
for row in random.Random(os.environ.get("HOBE_TEST_SEED")).sample(rows, 3):
    again = subprocess.run([sys.argv[1], *row["command"].split()[1:], "--format", "json"],
                           check=True, stdout=subprocess.PIPE, text=True).stdout
    report = json.loads(again)["report"]
    assert report["v"]["value"] == row["v"] and "error of u" not in row, (row, report)
PYTHON
[ -s out/chart.data.csv ] && [ -s out/chart.gp ] || complain "no figure"
! command -v gnuplot >/dev/null || [ -s out/chart.png ] || complain "no picture"

# refuses STATUS SENTENCE ARGUMENTS...
refuses() {
    status=$1 sentence=$2
    shift 2
    "$hobe" chart "$@" >stdout 2>stderr
    [ $? -eq "$status" ] || complain "$*: the status is not $status"
    grep -q "^hobe: .*$sentence" stderr || complain "$*"
    [ "$(wc -l <stderr)" -eq 1 ] && [ ! -s stdout ] || complain "$*: more than a sentence"
}
echo 'require("hobe").report{ u = 1 }' >none.lua
echo 'require("hobe").param("elements", 1)' >silent.lua
echo 'require("hobe").param("elements", 1) require("hobe").report{ u = 1 }' >still.lua
echo 'require("hobe").chart{ ladder = {{ element = {{}} }} }' >wrong.lua
echo 'require("hobe").chart{ doubt = -1 }' >doubt.lua
echo 'require("hobe").chart{ ladder = {{}} } require("hobe").report{ u = 1 }' >empty.lua
echo 'require("hobe").chart{ quantities = { "u" }, truth = { v = 1 } }' >truth.lua
sed 's/truth = .*/ladder = {{ elements = { 1, 2 } }},/; /^  ladder = {$/,/^  },/d' case.lua >early.lua
"$hobe" chart early.lua --quick --format csv | grep -q '^model,.*,error of v,largest error' ||
    complain "a chart without names does not take those of the report"
printf 'hobe = require "hobe"\nwhile hobe.param("elements", 1) > 0 do pcall(hobe.kernel) end\n' >ever.lua
refuses 2 'which case? hobe chart CASE'
refuses 2 'unknown option or missing value: --slow' case.lua --slow
refuses 2 '--limit must be a number of seconds from 1 to 86400, got "0"' case.lua --limit 0
refuses 2 'a parameter is given twice: elements' case.lua elements=1 elements=2,4
refuses 2 'words with commas between them, elements=2,4,8' case.lua elements=2,,4
refuses 1 'nowhere.lua' nowhere.lua
refuses 1 'no model runs; the first, .*, fails with: the case has no parameter "Q"' case.lua Q=3 --quick
refuses 1 'no model runs; the first, --model=BE24:2, fails with: it solves no scene' none.lua --model=BE24:2
refuses 1 'a model is ELEMENT:ELEMENTS' none.lua --model=BE24
refuses 1 'the ladder of the case is empty' empty.lua
refuses 1 'the case has no parameter "Q", did you mean "P"?$' plain.lua Q=3 elements=1,2
refuses 1 'the case reports no value' silent.lua
refuses 1 'no model runs; the first, --model=3333:1, fails with: it solves no scene' still.lua element=3333 \
    elements=1,2
refuses 1 'wrong.lua:1: chart: element must be a number, string or boolean, got a table' wrong.lua
refuses 1 'truth.lua:1: chart: truth has a name that is not among' truth.lua
refuses 1 'doubt.lua:1: chart: doubt must be' doubt.lua
refuses 1 'it takes more than 1 s of processor time' ever.lua --limit 1

[ "$failed" -eq 0 ] && echo "the charts are drawn"
