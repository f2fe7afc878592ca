#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Motions that are killed at any moment go on with --resume, to the same bits as one that was not:
# by steps of one length, of lengths that change, and of a reduced model.
# shellcheck source=tests/cases/check.sh
. "$(dirname "$0")/check.sh"

cat >case.lua <<'END'
local hobe = require "hobe"
local function swing(options)
  local d = hobe.dynamic(hobe.scene{
    hobe.beam{ name = "rod", element = "3333", elements = 4, from = {0, 0, 0}, to = {1, 0, 0},
               section = hobe.rectangle{ width = 0.02, height = 0.02 },
               material = { E = 2e9, nu = 0.3, rho = 7800 } },
    hobe.support{ "rod", at = 0, kind = "revolute", axis = {0, 1, 0} },
    hobe.gravity{0, 0, -9.81},
  }, options)
  local state = d:state(d.count)
  return state:displacement("rod", 1), state.energy, d
end
local function bar(...)
  return hobe.scene{
    hobe.beam{ name = "bar", element = "BE24", elements = 3, from = {0, 0, 0}, to = {1, 0, 0},
               section = hobe.rectangle{ width = 0.02, height = 0.02 },
               material = { E = 2e9, nu = 0.3, rho = 7800 } },
    hobe.clamp{ "bar", at = 0 }, ... }
end
local function spin(options)
  local across = hobe.gravity{0, -9.81, 0}
  local basis = hobe.reduce(bar(hobe.spin{ axis = {0, 0, 1}, speed = 3 }),
                            { modes = 5, loads = { bar(across) } })
  local function history(t) return t end
  return hobe.dynamic(basis:on(bar(across, hobe.spin{ axis = {0, 0, 1}, speed = 3,
                                                      history = history })), options)
end
local to = hobe.param("to", 1)
local u, energy, d = swing{ to = to, step = 1e-3, store = 0.01 }
local v, _, e = swing{ to = to, accuracy = 1e-6 }
local r = spin{ to = to, step = 1e-3, store = 0.01 }
local w, q = r:state(r.count):displacement("bar", 1), r:state(r.count).energy
hobe.report{ u1 = u[1], u3 = u[3], v1 = v[1], v3 = v[3], strain = energy, states = d.count,
             w1 = w[1], w2 = w[2], reduced = q, steps = e.steps, iterations = e.iterations,
             balance = d:energies(d.count).balance }
END

"$hobe" run case.lua --out whole --format csv >whole.csv || complain "the motion"
[ -e whole/motion-1.journal ] && complain "a journal is left when all results are there"

# Kills after random times; the last attempt is left alone.
kills=0
for round in 1 2 3 4 5; do
    rm -rf part
    resume=
    for attempt in 1 2 3 4 5 6; do
        # shellcheck disable=SC2086 # an option or none
        "$hobe" run case.lua --out part $resume --format csv >part.csv 2>stderr &
        pid=$!
        if [ $attempt -lt 6 ]; then
            sleep "0.$(od -An -N2 -tu2 /dev/urandom | awk '{ printf "%03d", $1 % 150 }')"
            kill -KILL $pid 2>/dev/null && kills=$((kills + 1))
        fi
        wait $pid 2>/dev/null && break
        [ -s stderr ] && complain "round $round"
        resume=--resume
    done
    cmp whole.csv part.csv || complain "round $round: another result after $attempt attempts"
    cmp whole/motion.csv part/motion.csv || complain "round $round: another history"
done
echo "$kills killed"

# A journal of other parameters, and one of another case.
rm -rf part
"$hobe" run case.lua to=50 --out part >/dev/null 2>&1 &
pid=$!
while [ ! -s part/motion-1.journal ]; do sleep 0.02; done
kill -KILL $pid
wait $pid 2>/dev/null
"$hobe" run case.lua to=40 --out part --resume >/dev/null 2>stderr && complain "resumed another end"
grep -q "case.lua:3: part/motion-1.journal belongs to another run" stderr || complain "the sentence"
echo >>case.lua
"$hobe" run case.lua to=50 --out part --resume >/dev/null 2>stderr && complain "resumed another case"
grep -q "belongs to another run" stderr || complain "the sentence"
"$hobe" run case.lua --resume >/dev/null 2>stderr && complain "resumed from nowhere"
grep -q -e "--resume needs the folder" stderr || complain "the sentence"

[ $failed -eq 0 ]
