#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# hobe advise, and scenes that choose their model, from outside.
# shellcheck source=tests/cases/check.sh
. "$(dirname "$0")/check.sh"

cat >beam.lua <<'END'
local hobe = require "hobe"
local P = hobe.param("P", 1)
local scene = hobe.scene{
  hobe.beam{ name = "bar", element = "MGD30w", elements = 2,
             section = hobe.rectangle{ width = 0.01, height = 0.02 },
             material = { E = 210e9, nu = 0.3 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "bar", at = 0 },
  hobe.force{ "bar", at = 1, value = {0, 0, -P} },
  accuracy = hobe.param("choose", false) and 1e-2 or nil,
}
local r = hobe.static(scene)
hobe.report{ sag = { r:displacement("bar", 1)[3], "m" }, elements = scene.elements }
hobe.chart{ quantities = { "sag" } }
END

# A slender beam under a small load: neither warping nor large displacements are needed.  The error
# of a beam without shear is (h/L)^2 times less than one.
run 0 advise beam.lua --accuracy 1e-2
has stdout '^accuracy 0\.01 is held by [^ ]+, 1 element, linear: error about .* in sag$'
has stdout '^  hobe run beam\.lua --model=[^ ]+:1:linear$'
has stdout '^warping in torsion +left out'
has stdout '^large displacements +left out'
has stdout '^shear +kept'
command=$(sed -n 's/^  hobe //p' stdout)
told=$(sed -n 's/^sag *\([^ ]*\).*/\1/p' stdout)
# shellcheck disable=SC2086 # arguments are words
run 0 $command
has stdout "^sag +$told "
has stdout '^elements +1'

# As JSON: the same choice, all trials with what they cost, and a command that gives its values.
run 0 advise beam.lua --accuracy 1e-2 --format json
cp stdout advice.json
# shellcheck disable=SC2086 # arguments are words
"$hobe" $command --format json >again.json 2>stderr
python3 - "$command" <<'END' || complain "the JSON is not what it should be"
import json, sys
advice, again = json.load(open("advice.json")), json.load(open("again.json"))["report"]
choice, = advice["choice"]
assert choice["command"] == "hobe " + sys.argv[1], choice
assert choice["holds"] == "yes" and choice["error"] <= choice["accuracy"] == 1e-2, choice
total = sum(trial["operations"] for trial in advice["trials"])
assert abs(total - choice["all operations"]) <= 1e-12 * total, choice
taken, = [trial for trial in advice["trials"] if trial["model"] == choice["model"]]
assert taken["operations"] == choice["operations"], taken
value, = advice["values"]
assert value["value"] == "sag" and value["unit"] == "m", value
assert value["this model"] == again["sag"]["value"], value
verdict = {e["effect"]: e["verdict"] for e in advice["evidence"]}
assert verdict["large displacements"] == "left out" and verdict["shear"] == "kept", verdict
END

# Under a load that bends it far the response is not linear; parameters are passed on.
run 0 advise beam.lua P=3000 --accuracy 1e-2
has stdout '^large displacements +needed'
has stdout '^  hobe run beam\.lua P=3000 --model=[^ :]+:[0-9]+$'

# In place: the scene that is solved is the one chosen.
run 0 run beam.lua choose=true
has stdout '^accuracy 0\.01 is held by [^ ]+, 1 element: error about'
has stdout '^elements +1'

# A motion, a cantilever's tip under a force that is there at once, after one and a half of its
# periods of 0.062 s: steps that the script has too long are cut, those too short are made longer,
# and against a much finer model and step neither claim is missed by more than two times.
cat >motion.lua <<'END'
local hobe = require "hobe"
local scene = hobe.scene{
  hobe.beam{ name = "bar", element = "MGD30w", elements = 2,
             section = hobe.rectangle{ width = 0.01, height = 0.02 },
             material = { E = 210e9, nu = 0.3, rho = 7850 }, from = {0, 0, 0}, to = {1, 0, 0} },
  hobe.clamp{ "bar", at = 0 },
  hobe.force{ "bar", at = 1, value = {0, 0, -1} },
}
local d = hobe.dynamic(scene, { to = 0.09, step = hobe.param("step", 0.003), store = 0.045 })
hobe.report{ half = { d:state(2):displacement("bar", 1)[3], "m" },
             last = { d:state(3):displacement("bar", 1)[3], "m" } }
END
run 0 run motion.lua --model=MGD30w3:16:step=0.02 --format json
cp stdout truth.json
for step in 0.003 0.0003; do
    run 0 advise motion.lua step=$step --accuracy 2e-2 --format json
    python3 - $step stdout <<'END' || complain "the step chosen in place of $step is not right"
import json, sys
step, advice = float(sys.argv[1]), json.load(open(sys.argv[2]))
truth = {name: v["value"] for name, v in json.load(open("truth.json"))["report"].items()}
choice, = advice["choice"]
assert (float(choice["model"].split("step=")[1]) < 1) == (step > 0.001), choice
assert choice["holds"] == "yes" and choice["error"] <= 2e-2, choice
for row in advice["values"]:
    error = abs(row["this model"] / truth[row["value"]] - 1)
    assert error <= 2 * 2e-2, (row, error)
effects = {e["effect"]: e for e in advice["evidence"]}
assert effects["a shorter step"]["loss without it"] <= 2e-2, effects
assert effects["dynamics"]["verdict"] == "needed", effects
assert effects["dynamics"]["loss without it"] > 0.1, effects
END
done

# Where the force comes slowly, a hundred periods long, equilibria do; of nothing that holds it there
# are none.
sed 's/value = {0, 0, -1}/&, history = function(t) return t\/6 end/
     s/to = 0.09, .*store = 0.045/to = 6, step = 0.01, store = 3/' motion.lua >slow.lua
run 0 advise slow.lua --accuracy 2e-2
has stdout '^accuracy 0\.02 is held by .*, quasi-static: error about '
has stdout '^  hobe run slow\.lua --model=.*:quasi-static$'
has stdout '^dynamics +left out'
sed "/hobe.clamp/d" motion.lua >free.lua
run 0 advise free.lua --accuracy 2e-2
has stdout '^dynamics +needed *$'
run 1 run motion.lua --model=MGD30w:2:step=0
has stderr 'a model is ELEMENT:ELEMENTS.*got "MGD30w:2:step=0"'
sed 's/, store = 0.045//' motion.lua >every.lua
run 1 run every.lua --model=MGD30w:2:step=0.5
has stderr 'every\.lua:9: dynamic: a model with another step needs store'
run 0 advise every.lua --accuracy 2e-2
has stdout 'error about .*, that of the step in time, which cannot be changed, left out$'

# What cannot be asked for.
run 2 advise
run 2 advise beam.lua --accuracy 2
has stderr '--accuracy must be a number between 0 and 1, got "2"'
run 2 advise beam.lua --format csv
has stderr 'advice is printed as table or json, not as csv'
run 1 advise nowhere.lua
has stderr 'nowhere\.lua'
run 1 run beam.lua --model=MGD30w
has stderr 'a model is ELEMENT:ELEMENTS.*got "MGD30w"'
run 1 run beam.lua --model=MGD30v:2
has stderr 'MGD30v'

[ "$failed" -eq 0 ] || exit 1
echo "run_advise: no complaints"
