#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints the share of the core's lines and branches that the unit tests, the program's
# tests and the golden frames reach: in total, and for the files with the lowest share.
#
#   tests/coverage/run.sh [N]           the N lowest files, 20 by default
#
# For the lines of one file:  gcov -b -t build/coverage/src/fixed/roots.gcda
# Built without asserts, whose failing branch no test takes, and without the program for
# newer processors. Headers are left out: gcov reports them once for each inclusion.
. "$(dirname "$0")/../lib/script.sh"
set -eu

build=build/coverage
in_build()      # GOAL...
{
    build TARGET=coverage V3_C= OPT='-O1 -g1 --coverage' UNIT_LIB=$build/libtidepool.a "$@"
}
tests=$(in_build -s list-tests | sed -n "s,^tests/\(unit\|host\|golden\)/[^=]*$,$build/&,p")
in_build all $tests >$build.log 2>&1 || { tail $build.log; exit 1; }
find $build -name '*.gcda' -delete
tests/run.sh build/log/coverage $tests || :     # failed tests have reached lines too

find $build/src -name '*.gcda' -exec gcov -b -n {} + 2>/dev/null | awk -F"[':% ]+" '
    /^File /  { file = $2 }
    /^Lines / { lines = $3; of_lines = $5 }
    /^Branches |^No branches/ { branches = 100; of_branches = 0 }
    /^Taken / { branches = $5; of_branches = $7 }
    /calls|^Calls / && file ~ /^src\/.*\.c$/ {
        printf "%6.1f %% of %4d branches  %6.1f %% of %4d lines  %s\n", branches,
            of_branches, lines, of_lines, file
    }' >$build/table
sort -n $build/table | head -n "${1:-20}"
awk '{ b += $1 * $4; all_b += $4; l += $6 * $9; all_l += $9; n++ }
    END { printf "%6.1f %% of %d branches, %.1f %% of %d lines, %d files\n", b / all_b,
              all_b, l / all_l, all_l, n }' $build/table
