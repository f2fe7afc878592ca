#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs every script of bad/ and checks that it ends as an error should: exit status 1, exactly one
# line on standard error that matches the script's first line ("-- expect: REGEX"), nothing on
# standard output, no file in the output folder.  A second line "-- args: ..." holds arguments.
#
#   HOBE=path/to/hobe tests/cases/run_bad.sh [NAME ...]
set -u
hobe=$(realpath "${HOBE:?set HOBE to the program}")
cd "$(dirname "$0")" || exit 1
scratch=$(mktemp -d) || exit 1
trap 'rm -rf "$scratch"' EXIT
failed=0
count=0

complain() {
    echo "$name: $1" >&2
    sed 's/^/    /' "$scratch/stderr" >&2
    failed=$((failed + 1))
}

check() {
    expect=$(sed -n '1s/^-- expect: //p' "bad/$name.lua")
    args=$(sed -n '2s/^-- args: //p' "bad/$name.lua")
    rm -rf "$scratch/out"
    # shellcheck disable=SC2086 # arguments are words
    timeout 120 "$hobe" run "bad/$name.lua" $args --out "$scratch/out" \
        >"$scratch/stdout" 2>"$scratch/stderr"
    status=$?
    [ -n "$expect" ] || complain "its first line holds no expectation"
    [ "$status" -eq 1 ] || complain "exit status $status instead of 1"
    [ "$(wc -l <"$scratch/stderr")" -eq 1 ] || complain "not exactly one line of error"
    grep -Eq -- "$expect" "$scratch/stderr" || complain "expected: $expect"
    [ ! -s "$scratch/stdout" ] || complain "something on standard output"
    left=$(find "$scratch/out" -type f 2>/dev/null)
    [ -z "$left" ] || complain "left behind: $left"
}

[ $# -gt 0 ] || set -- $(ls bad | sed -n 's/\.lua$//p')
for name; do
    check
    count=$((count + 1))
done
echo "$count bad scripts, $failed complaints"
[ "$count" -gt 0 ] && [ "$failed" -eq 0 ]
