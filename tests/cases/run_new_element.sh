#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Adds two elements from declarations outside the source tree, builds a program that has them, and
# solves with it.  One extends BE24w by the mode yz; the other is the same element written out with
# functions of its own, so that both must give the same numbers.
#
# From ctest: HOBE_SOURCE, the source tree; HOBE_PYTHON, a Python with sympy.
set -eu

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
build=$folder/build

fail() {
    printf 'run_new_element: %s\n' "$*" >&2
    exit 1
}

# ---- the declarations ---------------------------------------------------------------------------

cat >"$folder/TEST2yz.toml" <<'END'
name    = "TEST2yz"
source  = "a test: BE24w with a warping mode more"
extends = "BE24w"

[[field]]
modes = ["yz"]
like  = "y"
END

cat >"$folder/TEST2explicit.toml" <<'END'
name   = "TEST2explicit"
nodes  = ["0", "1"]

[[field]]
modes     = ["1"]
dofs      = { 1 = ["value", "slope"], 2 = ["value", "slope"] }
functions = ["(1 - xi)**2*(1 + 2*xi)", "xi*(1 - xi)**2", "xi**2*(3 - 2*xi)", "-xi**2*(1 - xi)"]

[[field]]
modes     = ["y", "z", "w", "yz"]
dofs      = { 1 = ["value"], 2 = ["value"] }
functions = ["1 - xi", "xi"]
END

# ---- a build with these, touching nothing of the source tree ------------------------------------

tree() {
    git -C "$HOBE_SOURCE" status --porcelain -- elements generator generated 2>/dev/null || :
}
before=$(tree)

quietly() {
    "$@" >"$folder/log" 2>&1 || { cat "$folder/log" >&2; fail "failed: $*"; }
}

generator=
command -v ninja >/dev/null && generator=-GNinja
quietly cmake -S "$HOBE_SOURCE" -B "$build" $generator -DBUILD_TESTING=OFF \
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_FLAGS_RELEASE=-O1 -DHOBE_PYTHON="$HOBE_PYTHON" \
    -DHOBE_EXTRA_ELEMENTS="$folder/TEST2yz.toml;$folder/TEST2explicit.toml" -DHOBE_ELEMENTS=BE24w
quietly cmake --build "$build" --target hobe --parallel 2

[ "$(tree)" = "$before" ] || fail "the build changed the source tree"

listed=$("$build/hobe" elements | awk '/^[^ ]+  +[0-9]/ { printf "%s/%s ", $1, $3 }')
[ "$listed" = "BE24w/30 TEST2explicit/36 TEST2yz/36 " ] || fail "hobe elements lists $listed"

# ---- a cantilever, bent and twisted within its linear range -------------------------------------

cat >"$folder/case.lua" <<'END'
local hobe = require "hobe"
local F, M = 1, 1                                    -- N, N m
local r = hobe.static(hobe.scene{
  hobe.beam{
    name = "beam", element = hobe.param("element", "TEST2yz"), elements = 4,
    section = hobe.rectangle{ width = 0.1, height = 0.2 },
    material = { E = 1e9, nu = 0.3, rho = 1000 },
    from = {0, 0, 0}, to = {1, 0, 0},
  },
  hobe.clamp{ "beam", at = 0 },
  hobe.force{ "beam", at = 1, value = {0, 0, -F} },
  hobe.moment{ "beam", at = 1, value = {M, 0, 0} },
})
hobe.report{ sag = { -r:displacement("beam", 1)[3], "m" }, twist = { r:twist("beam", 1), "rad" } }
END

for element in BE24w TEST2yz TEST2explicit; do
    "$build/hobe" run "$folder/case.lua" element=$element --format csv >"$folder/$element.csv" ||
        fail "$element does not solve"
done

# A mode more can only make it softer; here it adds little to what w does.
awk -F, '
    FNR == 1 { file++ }
    FNR > 1 { u[file, $1] = $2 }
    function say(text) { print "run_new_element: " text; failed = 1 }
    END {
        split("sag twist", measure, " ")
        for (i = 1; i <= 2; i++) {
            m = measure[i]
            ratio = u[2, m] / u[1, m]
            if (!(ratio > 1 - 1e-6 && ratio < 1.05))
                say(m " of TEST2yz over that of BE24w: " ratio)
            ratio = u[3, m] / u[2, m]
            if (!(ratio > 1 - 1e-9 && ratio < 1 + 1e-9))
                say(m " of TEST2explicit over that of TEST2yz: " ratio)
        }
        exit failed
    }' "$folder/BE24w.csv" "$folder/TEST2yz.csv" "$folder/TEST2explicit.csv" ||
    fail "the new elements differ"

"$build/hobe" bench --element TEST2yz --quick --seconds 0.001 --format csv >"$folder/bench.csv" ||
    fail "TEST2yz cannot be timed"
grep -q "TEST2yz,.*,eq. 28," "$folder/bench.csv" || fail "no times of TEST2yz: $(cat "$folder/bench.csv")"

# ---- a bad declaration ends in its sentence -----------------------------------------------------

sed -i 's/like  = "y"/like  = "x"/' "$folder/TEST2yz.toml"
if cmake --build "$build" --target hobe >"$folder/log" 2>&1; then
    fail "a mode like an unknown one was built"
fi
grep -q "TEST2yz.toml: field 1: like = 'x': no such mode before" "$folder/log" ||
    { cat "$folder/log" >&2; fail "the sentence is missing"; }
