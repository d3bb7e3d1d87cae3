#!/bin/sh
# SPDX-License-Identifier: MIT
# The core builds at -O1 and reports its reached lines to gcov; with TP_SOAK set the
# program and each unit test build in the same way.
. "$(dirname "$0")/../lib/script.sh"

lacks gcov gcc "coverage" && exit 77
scene=three-swells
target=coverage-gate
frames=build/$target/tests/cross/frames-$scene
built()         # GOAL...
{
    build TARGET=$target OPT='-O1 --coverage' "$@"
}
golden()        # the frames are the golden frames
{
    $frames xrgb8888 | cut -d' ' -f2- >"$scratch/frames" &&
        diff tests/golden/$scene/xrgb8888.crc "$scratch/frames"
}
reached()       # FILE PERCENT: at least this share of its lines
{
    gcov -n "build/$target/${1%.c}.gcda" >"$scratch/gcov" 2>/dev/null &&
        awk -v file="'$1'" -v least="$2" -F'[:% ]' '
            $1 == "File" { here = $2 == file }
            $1 == "Lines" && here { print; if ($3 >= least) found = 1 }
            END { exit !found }' "$scratch/gcov"
}
check "the core builds for coverage" built $frames
find build/$target -name '*.gcda' -delete
check "its frames are the golden ones" golden
check "gcov tells of the lines that they reach" reached src/frame/frame.c 50
refuse "and of those that they do not" reached src/features/tank/tank_drawing.c 50
[ -z "${TP_SOAK:-}" ] || check "the program and the tests build for coverage" built all unit
finish
