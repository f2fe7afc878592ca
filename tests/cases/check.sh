# SPDX-License-Identifier: GPL-3.0-or-later
# What the scripts run_*.sh begin with: the program, a folder to work in that goes when they end,
# and complaints, which are counted in $failed.
#
# From ctest: HOBE, the program; HOBE_PYTHON.
set -u
test=$(basename "$0" .sh)
hobe=$(realpath "${HOBE:?set HOBE to the program}")
python=${HOBE_PYTHON:-python3}
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
: >stderr
failed=0

complain() {
    echo "$test: $*" >&2
    sed 's/^/    stderr: /' "$scratch/stderr" >&2
    failed=$((failed + 1))
}

# run STATUS ARGUMENTS...: runs the program, keeps stdout and stderr, checks the exit status.
run() {
    want=$1
    shift
    timeout 120 "$hobe" "$@" >stdout 2>stderr
    got=$?
    [ "$got" -eq "$want" ] || complain "hobe $*: exit status $got instead of $want"
}

# has FILE REGEX, lacks FILE REGEX, is FILE TEXT
has() {
    grep -Eq -- "$2" "$1" || complain "$1 should have: $2"
}
lacks() {
    if grep -Eq -- "$2" "$1"; then complain "$1 should not have: $2"; fi
}
is() {
    [ "$(cat "$1")" = "$2" ] || complain "$1 should be: $2, is: $(cat "$1")"
}
