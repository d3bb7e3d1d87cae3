#!/bin/sh
# SPDX-License-Identifier: MIT
# Prints which share of the core's lines and branches the unit tests, the program's own
# and the golden frames reach: of all, and of the files that have the least.
#
#   tests/coverage/run.sh [N]           the N lowest files, 20 unless told
#
# For the lines of one of them:  gcov -b -t build/coverage/src/fx/fx.gcda
# Built without asserts, whose failing branch no test takes, and without the program for newer
# processors.  Headers are left out: gcov tells of each as often as it is included.
set -eu

build=build/coverage
in_build()      # GOAL...
{
    env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS make -j2 --no-print-directory TARGET=coverage \
        V3_C= OPT='-O1 -g1 --coverage' UNIT_LIB=$build/libtidepool.a "$@"
}
tests=$(in_build -s list-tests | sed -n "s,^tests/\(unit\|host\|golden\)/[^=]*$,$build/&,p")
in_build all $tests >$build.log 2>&1 || { tail $build.log; exit 1; }
find $build -name '*.gcda' -delete
tests/run.sh build/log/coverage $tests || :     # what failed has reached lines as well

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
