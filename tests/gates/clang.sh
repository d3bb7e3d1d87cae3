#!/bin/sh
# SPDX-License-Identifier: MIT
# clang reports no warnings in the core, the program and the tests.
#
# The warnings only need the sources, and clang takes longer to start than to read a file:
# all files that make would compile with the same flags are read by one process. The
# driver has no option for this, but prints the command to call. tests/cross/run.sh
# compiles objects with clang.
. "$(dirname "$0")/../lib/script.sh"

lacks clang clang "clang's warnings" && exit 77

# Files that make would compile for these goals, "FILE FLAGS" a line.
wanted()
{
    build -n V=1 TARGET=clang MACHINE=host CC=clang OPT=-O0 CHECKED=1 \
        V3_OPT=-march=x86-64-v3 everything unit | awk '
        sub(/\\$/, "") { head = head $0; next }
        { $0 = head $0; head = "" }
        $1 == "clang" && / -c / {
            flags = ""
            for (i = 2; i <= NF; i++)
                if ($i == "-c") file = $++i
                else if ($i == "-o") i++
                else if ($i != "-MMD" && $i != "-MP") flags = flags " " $i
            print file flags
        }' | LC_ALL=C sort -u
}

# warned FILE: reads the list of that name; prints clang's output, false if there is any.
warned()
{
    cut -d' ' -f2- "$1" | LC_ALL=C sort -u >"$1.flags"
    while read -r flags; do
        command=$(clang '-###' $flags -fsyntax-only -x c /dev/null 2>&1 | tail -n 1)
        files=$(awk -v flags="$flags" \
            '{ file = $1; sub(/^[^ ]* /, "") } $0 == flags { printf " %s", file }' "$1")
        eval "${command% *}$files" || return 1
    done <"$1.flags"
}

wanted >"$scratch/list"
many()          # all files of the core, and half of them once more
{
    awk -v core="$(find src -name '*.c' | wc -l)" '{ split($1, at, "/"); n[at[1]]++ }
        END { print n["src"], n["ports"], n["tests"]
              exit n["src"] < core * 3 / 2 || n["ports"] < 50 || n["tests"] < 150 }' \
        "$scratch/list"
}
check "the core twice, the program and the tests are looked at" many
check "clang compiles everything without a warning" warned "$scratch/list"

echo 'int twice(int x); int twice(int x) { long y = x; return y * 2; }' >"$scratch/bad.c"
tail -n 2 "$scratch/list" | sed "\$s|^[^ ]*|$scratch/bad.c|" >"$scratch/one_bad"
refuse "a warning in the second of two is found" warned "$scratch/one_bad"

check "clang compiles every public header alone, as C11 to C++20" \
    headers_alone clang clang++
finish
