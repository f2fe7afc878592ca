#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Lets each allocation of a small run fail in turn, up to the Lua line that asked: every run must end
# with one sentence (after warnings of results it had, from a mesh as coarse as this) and status 1,
# without a crash, a leak or a file, until one gets through.  Needs a build with the sanitizers, which
# is where HOBE_FAIL_ALLOCATION means something.
# shellcheck source=tests/cases/check.sh
. "$(dirname "$0")/check.sh"

printf '0 0\n3 0\n0 4\n' >corner.csv
cat >case.lua <<'LUA'
local hobe = require "hobe"
local section = hobe.rectangle{ width = 0.02, height = 0.05 }
local material = { E = 2e11, nu = 0.3, rho = 7800 }
local scene = hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = section, material = material,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.beam{ name = "b", element = "3333", elements = 1, section = section, material = material,
             curve = function(t) return {1 + t * t, t, 0} end, twist = function(at) return at end },
  hobe.clamp{ "a", at = 0 }, hobe.join{ "a", "b", at = {1, 0} }, hobe.gravity{ 0, 0, -9.81 },
  hobe.force{ "b", at = 1, value = {0, 0, 10}, follower = true },
  hobe.moment{ "b", at = 1, value = {1, 0, 0} },
}
local r = hobe.static(scene)
local m = hobe.modal(scene, { modes = 2 })
local arm = hobe.scene{
  hobe.beam{ name = "a", elements = 2, section = section, material = material,
             from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "a", at = 0 }, hobe.force{ "a", at = 1, value = {-100, 0, 10} },
}
local path = hobe.path(arm, { arc = 0.5, reach = { "a", at = 1, value = {0, 0, 1} } })
local element = hobe.kernel{ element = "BE24", section = section, material = material, length = 1 }
hobe.report{ u = r:displacement("b", 1)[3], U = element:energy(element:reference()),
             P = hobe.buckling(arm, { modes = 1 }):factor(1), W = path[1].energy,
             f = m:frequencies()[2], v = m:shape(1, "b", 1)[3],
             A = hobe.outline{ file = "corner.csv" }.A }
hobe.picture{ file = "a.png", width = 300, sections = { { section, "a" } } }
LUA

n=1
while :; do
    HOBE_FAIL_ALLOCATION=$n "$hobe" run case.lua --out out >stdout 2>stderr
    status=$?
    [ $status -ne 0 ] || break
    if [ $status -ne 1 ] || [ "$(grep -vc ' warning: ' stderr)" -ne 1 ] || ! grep -q 'out of memory' stderr ||
        [ -s stdout ] || [ -n "$(find out -type f 2>/dev/null)" ]; then
        echo "allocation $n: status $status" >&2
        cat stderr >&2
        exit 1
    fi
    n=$((n + 1))
    [ $n -lt 1000 ] || exit 1
done
echo "$((n - 1)) allocations failed in turn"
[ $n -gt 50 ]
