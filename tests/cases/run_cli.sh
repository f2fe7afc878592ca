#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The program from outside: results, formats, parameters, files, the sandbox's walls, exit status.
#
# From ctest: HOBE_BUILD, the build folder with lua/hobe.so.
module=$(realpath "${HOBE_BUILD:?set HOBE_BUILD to the build folder}")/lua
# shellcheck source=tests/cases/check.sh
. "$(dirname "$0")/check.sh"

one_error() {
    [ "$(wc -l <stderr)" -eq 1 ] || complain "not one line of error"
    [ ! -s stdout ] || complain "an error, and something on standard output"
}

# ---- cases --------------------------------------------------------------------------------------

cat >beam.lua <<'END'
local hobe = require "hobe"
local element, n = hobe.param("element", "MGD30w"), hobe.param("n", 4)
local P, log = hobe.param("P", 10.5), hobe.param("log", false)
local scene = hobe.scene{
  hobe.beam{ name = "blade", element = element, elements = n,
             section = hobe.square{ side = 0.01 },
             material = { E = 210e9, nu = 0.3, rho = 7850 },
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "blade", at = 0 },
  hobe.force{ "blade", at = 1, value = {0, 0, -P} },
}
local r = hobe.static(scene)
local u = r:displacement("blade", 1)
print("printed by the script")
io.write("written by the script\n")
hobe.report{ u3 = { u[3], "m", expect = -0.02, within = 0.5 } }
hobe.report{ n = n, element = #element, P = { P, "N" }, log = log and 1 or 0 }
local x, y = {}, {}
for i = 0, 10 do
  x[i + 1], y[i + 1] = i / 10, r:displacement("blade", i / 10)[3]
end
hobe.table{ title = "Axis", columns = { "x", "u3, m" }, file = "axis.csv",
            rows = { { x[1], y[1] }, { x[11], y[11] }, { 'quoted, "', nil } } }
hobe.plot{ file = "figures/axis.png", title = "it's `id` {a}_b", xlabel = "x, m", ylabel = "u3, m",
           series = { { label = "u3", x = x, y = y, style = "linespoints" } } }
hobe.picture{ file = "figures/beam.png", width = 300, state = r, title = "it's `id` {a}_b" }
END

# ---- formats ------------------------------------------------------------------------------------

run 0 run beam.lua
has stdout '^name +value +unit +expected +difference$'
has stdout '^u3 +-0\.0[0-9]+ +m +-0\.02 .* ok$'
has stdout '^Axis$'
has stdout '^beam blade: MGD30w, mechanics average, integration exact$'
has stderr 'printed by the script'
has stderr 'written by the script'
lacks stdout 'by the script'

run 0 run beam.lua --format json
"$python" - <<'END' || complain "the JSON is not one object with sorted keys"
import json
text = open("stdout").read()
pairs = json.loads(text, object_pairs_hook=list)
report = dict(pairs)["report"]
names = [name for name, _ in report]
assert [key for key, _ in pairs] == ["report"], pairs
assert names == sorted(names) and names == ["P", "element", "log", "n", "u3"], names
report = json.loads(text)["report"]
assert report["P"] == {"value": 10.5, "unit": "N"} and report["n"] == {"value": 4}
assert report["u3"]["expect"] == -0.02 and report["u3"]["within"] == 0.5
assert -0.021 < report["u3"]["value"] < -0.018
END

run 0 run beam.lua --format=csv
has stdout '^name,value,unit$'
has stdout '^P,10\.5,N$'
has stdout '^n,4,$'
[ "$(wc -l <stdout)" -eq 6 ] || complain "CSV of five values should have six lines"

# ---- parameters ---------------------------------------------------------------------------------

run 0 run beam.lua element=3333 n=2 P=1e1 log=true --format csv
has stdout '^element,4,$'
has stdout '^n,2,$'
has stdout '^P,10,N$'
has stdout '^log,1,$'
run 0 run beam.lua P=100          # away from the defaults expectations are shown, not checked
lacks stdout 'ok|FAIL'
run 0 run beam.lua P=10.5         # the default by another road
has stdout ' ok$'
run 1 run beam.lua P=ten
has stderr '^hobe: beam.lua:3: argument P=ten: parameter P must be a number$'
one_error
run 1 run beam.lua n=2.5
has stderr '^hobe: beam.lua:5: beam: elements must be a whole number, got 2.5$'
run 1 run beam.lua elemnt=3333 --out unknown
has stderr '^hobe: the case has no parameter "elemnt", did you mean "element"\?$'
[ -z "$(find unknown -type f)" ] || complain "files after an unknown parameter"
[ ! -s stdout ] || complain "results after an unknown parameter"

echo 'require("hobe").report{ u = { 1, "m", expect = 2, within = 0.1 }, v = 3 }' >miss.lua
run 1 run miss.lua
has stdout '^u +1 +m +2 +0\.5 +FAIL$'
has stderr '^hobe: miss.lua:1: report: u is 1 m but 2 is expected, a relative difference of 0.5'

# ---- files --------------------------------------------------------------------------------------

run 0 run beam.lua --out deep/results
for file in report.json report.csv newton.csv report-notes.txt axis.csv figures/axis.gp figures/axis.data.csv \
    figures/beam.png; do
    [ -s "deep/results/$file" ] || complain "$file is missing"
done
[ -z "$(find deep -name '.*' -type f)" ] || complain "temporary files are left"
has deep/results/axis.csv '^"quoted, """,$'
has deep/results/newton.csv '^solve,step,iteration,load,residual,energy,line,note$'
has deep/results/newton.csv '^1,1,1,'
if command -v gnuplot >/dev/null; then
    [ "$(head -c 4 deep/results/figures/axis.png | tail -c 3)" = PNG ] || complain "no PNG"
fi
[ "$(head -c 4 deep/results/figures/beam.png | tail -c 3)" = PNG ] || complain "no picture"
# Without gnuplot in the PATH: a line that says so, no error.
PATH=$scratch/none "$hobe" run beam.lua --out plain >stdout 2>stderr || complain "no gnuplot"
has stderr 'gnuplot is not installed: 1 picture not drawn'
cmp -s plain/figures/beam.png deep/results/figures/beam.png || complain "two pictures of a scene"
[ -s plain/figures/axis.gp ] && [ ! -e plain/figures/axis.png ] || complain "files without gnuplot"

# A run that fails leaves the good results of an earlier one as they were.
cp -r deep/results before
sed 's/^hobe.plot/error "late" hobe.plot/' beam.lua >late.lua
run 1 run late.lua --out deep/results
has stderr '^hobe: late.lua:[0-9]+: late$'
diff -r before deep/results >/dev/null || complain "a failed run has changed files"

echo 'taken' >taken
run 1 run beam.lua --out taken
has stderr '^hobe: taken could not be made: '
if [ -w /dev/full ]; then
    timeout 60 "$hobe" run miss.lua >/dev/full 2>stderr
    [ $? -eq 1 ] || complain "a full disk goes unnoticed"
    has stderr '^hobe: standard output could not be written: '
fi

# ---- walls of the sandbox -----------------------------------------------------------------------

cat >files.lua <<'END'
local f <close> = assert(io.open("notes.txt", "w"))
f:write("one ", 2, "\n")
f:flush()
assert(io.open("notes.txt"):read("a") == "one 2\n")
assert(io.open("sub/more.txt", "w")):write("more")
local none, why = io.open("absent.txt")
assert(not none and why:find("absent.txt"))
END
run 0 run files.lua --out box
is box/notes.txt 'one 2'
is box/sub/more.txt 'more'
run 1 run files.lua
has stderr '^hobe: files.lua:1: io.open: there is no output folder; run with --out DIR$'

echo secret >outside
mkdir -p box elsewhere
ln -sf ../outside box/link
ln -sfn ../elsewhere box/tunnel
mkfifo box/pipe
echo 'for _, name in ipairs{"link", "pipe", "tunnel/x"} do assert(not io.open(name), name) end' \
    >link.lua
run 0 run link.lua --out box
echo 'io.open("link", "w"):write("mine")' >replace.lua
run 0 run replace.lua --out box
is outside secret
is box/link mine
echo 'io.open("tunnel/x", "w"):write("mine")' >tunnel.lua
run 1 run tunnel.lua --out box
has stderr '^hobe: box/tunnel/x could not be written: '
[ ! -e elsewhere/x ] || complain "a symbolic link leads out of the output folder"

printf '\033Lua' >compiled.lua
run 1 run compiled.lua
has stderr '^hobe: compiled.lua: this is compiled Lua; a case must be source$'
one_error

cat >trust.lua <<'END'
os.execute("echo from a process")
local hobe, f = require "hobe", assert(io.open("trusted.txt", "w"))
f:close()
hobe.report{ a = 1 }
END
run 1 run trust.lua
run 0 run trust.lua --trust --format json
is stdout '{"report":{"a":{"value":1}}}'
has stderr 'from a process'
[ -e trusted.txt ] || complain "--trust does not reach files"

# Outlines come from the folder of the case, wherever the run is started.
mkdir -p cases/below
printf '0 0\n3 0\n0 4\n' >cases/below/corner.csv
printf '0 0\n3 0\n0 5\n' >elsewhere/corner.csv
ln -sfn ../elsewhere cases/tunnel
ln -sf ../../elsewhere/corner.csv cases/below/link.csv
mkfifo cases/pipe
truncate -s 17M cases/large.csv
cat >cases/outline.lua <<'END'
local hobe = require "hobe"
hobe.report{ A = hobe.outline{ file = hobe.param("file", "below/corner.csv") }.A }
END
run 0 run cases/outline.lua --format csv
has stdout '^A,6,$'
for file in tunnel/corner.csv below/link.csv pipe; do
    run 1 run cases/outline.lua file=$file
    has stderr "^hobe: cases/outline.lua:2: outline: cases/$file could not be read: .*; a case script \
reads regular files in its own folder and below, through no symbolic link"
done
for file in ../elsewhere/corner.csv "$scratch/elsewhere/corner.csv" below/../below/corner.csv; do
    run 1 run cases/outline.lua "file=$file"
    has stderr '^hobe: cases/outline.lua:2: outline: a case script reads files in its own folder'
done
run 1 run cases/outline.lua file=large.csv
has stderr 'large.csv: a file of an outline may have at most 16 MB$'
for file in ../elsewhere/corner.csv "$scratch/elsewhere/corner.csv" tunnel/corner.csv; do
    run 0 run cases/outline.lua "file=$file" --trust --format csv
    has stdout '^A,7\.5,$'
done
run 1 run cases/outline.lua file=absent.csv --trust
has stderr 'outline: cases/absent.csv could not be read: No such file or directory$'
run 1 run cases/outline.lua file=below --trust
has stderr 'outline: below could not be read: Is a directory$'

# ---- the rest of the command line ---------------------------------------------------------------

run 0 run beam.lua --log
has stderr '^ +step +iter +load +residual'
run 0 elements
has stdout '^MGD30w +3 +39 +5 +[0-9]+ +average +1 y z w$'
run 0 elements --explain MGD30w
has stdout 'node 3 \(x/l = 1\): value of the coefficient of w'
has stdout '^on a section that drops its other modes it is, and costs no more than, MGD30$'
has stdout 'tensor 3713 \(taken\), 20165 \(taken\) at 1.5, 1.8 times the speed'
run 0 elements --explain 34X3    # which its tensor makes hardly faster
has stdout 'straight, symmetric in y and z: section [0-9]+ \(taken\), [0-9]+ \(taken\); tensor [0-9]+, [0-9]+ at'
export HOBE_PLAN=fastest
run 1 run beam.lua
has stderr 'HOBE_PLAN in the environment is "fastest"; it must be "section", "tensor" or "points"'
HOBE_PLAN=points
run 0 run beam.lua
unset HOBE_PLAN
run 1 elements --explain MGD31w
run 0 docs
has stdout '^### `hobe.beam\{'
has stdout '^\| `material.E` \| number \| Pa \| > 0 \| required \|'
run 0 version
has stdout '^hobe [0-9]+\.[0-9]+\.[0-9]+$'
run 0 help
run 1 run absent.lua
has stderr '^hobe: cannot open absent.lua'
one_error
run 2 run
run 2 run beam.lua late.lua
run 2 run beam.lua n=1 n=2
run 2 run beam.lua --format xml
run 2 run beam.lua --colour
run 2 run beam.lua --time-limit soon
run 2 dance
run 2

long=$(printf 'folder%.0s' 1 2 3 4 5 6 7 8 9 10 11 12)
mkdir "$long"
echo 'error "where"' >"$long/case.lua"
run 1 run "$long/case.lua"       # Lua would shorten the name
has stderr "^hobe: $long/case.lua:1: where\$"

# ---- warnings -----------------------------------------------------------------------------------

cat >box.lua <<'END'
local hobe = require "hobe"
local T = hobe.param("T", 20)
local scene = hobe.scene{
  hobe.beam{ name = "box", element = "MGD30w", elements = 16,
             section = hobe.box{ width = 0.25, height = 0.05, thickness = 0.005 },
             material = { E = 1e9, nu = 0.3 }, from = {0, 0, 0}, to = {2, 0, 0} },
  hobe.clamp{ "box", at = 0 },
  hobe.moment{ "box", at = 1, value = {T, 0, 0} },
}
local r = hobe.static(scene)
hobe.report{ torque = r:wall_bending("box").torque }
hobe.path(scene, { arc = 0.2 })
END
run 0 run box.lua
is stderr ""
lacks stdout 'walls'
run 0 run box.lua T=150 --format json
has stderr '^box\.lua:10: warning: beam box: .* of 150 N m .* element MGD30w .* collapses'
has stderr '^hobe: warning: besides the first of each kind, 1 of bent walls: --log tells all, and '
lacks stdout 'walls'
[ "$(wc -l <stderr)" -eq 2 ] || complain "not the first warning and how many more"
run 0 run box.lua T=150 --log --out all
has stderr '^box\.lua:10: warning: beam box: '
has stderr '^box\.lua:12: warning: beam box: .* \(load factor [0-9.]+\)$'
lacks stderr 'besides'
has all/report-notes.txt '\(load factor [0-9.]+\)$'
run 0 run box.lua T=800
has stdout '^beam box: .* 800 N m, is beyond .* means nothing'
[ "$(wc -l <stderr)" -eq 2 ] || complain "not the first warning and how many more"

cat >start.lua <<'END'
local hobe = require "hobe"
hobe.dynamic(hobe.scene{
  hobe.beam{ name = "b", element = "MGD30", elements = 4, section = hobe.square{ side = 0.1 },
             material = { E = 1e9, nu = 0, rho = 1e3 }, from = {0, 0, 0}, to = {5, 0, 0} },
  hobe.clamp{ "b", at = 0 },
  hobe.force{ "b", at = 1, value = {-1e3, 0, 0} },   -- Euler: 822 N, about both axes
}, { to = 1e-3, step = 1e-3, start = "equilibrium" })
END
run 0 run start.lua
has stderr '^start\.lua:2: warning: dynamic: the equilibrium at the start is unstable: .* 2 negative eig'

# A sweep warns once of what it meets often, in any Lua; --format and files are what they were.
cat >sweep.lua <<'END'
local hobe = require "hobe"
for n = 1, 12 do
  hobe.static(hobe.scene{
    hobe.beam{ name = "b", element = "BE24", elements = n, section = hobe.square{ side = 0.01 },
               material = { E = 1e9, nu = 0 }, from = {0, 0, 0}, to = {10, 0, 0} },
    hobe.clamp{ "b", at = 0 }, hobe.force{ "b", at = 1, value = {0, 0, 1e-9} } })
end
END
run 0 run sweep.lua --out sweep
has stderr '^sweep\.lua:3: warning: beam b: '
has stderr '^hobe: warning: besides the first of each kind, [1-9] of coarse meshes: --log tells all'
[ "$(wc -l <stderr)" -eq 2 ] || complain "a sweep warns of every mesh"
lacks stdout 'warning'
[ "$(grep -c 'elements cannot follow' sweep/report-notes.txt)" -gt 2 ] || complain "report-notes.txt has not all"

# ---- stock Lua ----------------------------------------------------------------------------------

# A module built with gcc's sanitizers needs theirs to be loaded first; clang's cannot be.
asan=$(ldd "$module/hobe.so" | sed -n 's/.*libasan.* => \([^ ]*\) .*/\1/p')
loadable=yes
[ -z "$asan" ] && grep -q __asan_init "$module/hobe.so" && loadable=no
cat >stock.lua <<'END'
local hobe = require "hobe"
assert(hobe.version and hobe.elements()[1].name)
hobe.output("stock")
hobe.table{ columns = { "a" }, rows = { { 1 } }, file = "a.csv" }
hobe.report{ half = { 1 / 2, "m" } }
local ok, sentence = pcall(hobe.report, { half = { 1 / 2, expect = 1, within = 0.1 } })
assert(not ok and sentence:find("stock.lua:6: report: half is 0.5 but 1 is expected", 1, true))
local k = hobe.kernel{ section = hobe.rectangle{ width = 1, height = 2 }, length = 3,
                       material = { E = 1e9, nu = 0.3, rho = 2 } }
local q, M, total = k:reference(), k:mass(), 0
assert(#q == 39 and #k:dofs() == 39 and k:dofs()[1] == "r1x" and k.mechanics == "average")
for i, row in ipairs(M) do
  for j, m in ipairs(row) do
    if k:dofs()[i]:find("^r%dx") and k:dofs()[j]:find("^r%dx") then total = total + m end
  end
end
assert(math.abs(total - 12) < 1e-9, total)
assert(k:energy(q) == 0 and #k:force(q) == 39 and #k:tangent(q)[39] == 39)
assert(math.abs(hobe.outline{ file = "elsewhere/corner.csv" }.A - 7.5) < 1e-12)
END
if [ "$loadable" = yes ] && command -v lua5.4 >/dev/null; then
    LD_PRELOAD=$asan LUA_CPATH="$module/?.so" lua5.4 stock.lua >stdout 2>stderr ||
        complain "stock Lua fails"
    has stdout '^half +0\.5 +m$'
    has stdout '^a$'
    is stock/a.csv "$(printf 'a\n1')"
else
    echo "run_cli: no lua5.4, or a module it cannot load: not tested" >&2
fi

[ "$failed" -eq 0 ] && echo "the command line behaves"
