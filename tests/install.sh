#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs into a fresh prefix and uses what is there as strangers would: a C program by pkg-config,
# the Lua module by a stock interpreter, the program.  Usage: install.sh CMAKE CC
set -eu

prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
"$1" --install "$HOBE_BUILD" --prefix "$prefix" >/dev/null

cd "$prefix"
pc=$(find . -name hobe.pc)
PKG_CONFIG_PATH=$prefix/$(dirname "$pc")
export PKG_CONFIG_PATH
libdir=$(dirname "$PKG_CONFIG_PATH")

cat >tiny.c <<'END'
#include <hobe.h>
#include <stdio.h>

int main(void)
{
    printf("%s %s\n", hobe_kernels()[0]->name, hobe_status_words(HOBE_OK));
    return 0;
}
END
# shellcheck disable=SC2046 # the flags are several words
"$2" tiny.c -o tiny $(pkg-config --cflags --libs hobe)
LD_LIBRARY_PATH=$libdir ./tiny

# From here on libhobe must be found by the run path alone.
LUA_CPATH="$libdir/lua/5.4/?.so" lua5.4 -e 'assert(type(require "hobe") == "table")'
bin/hobe elements >/dev/null

test -s include/hobe/kernel.h
test -s share/doc/hobe/LICENSE
test -d share/hobe/cases
