#!/bin/sh
# SPDX-License-Identifier: MIT
# Errors of the kept scenes (tests/accuracy/scenes) against the reference at 16 samples a
# pixel, 320x240, every feature on: tables errors.csv and twinkle.csv beside this script.
#
#   tests/accuracy/errors.sh            measures the cheapest scenes and compares their rows
#                                       with the tables
#   tests/accuracy/errors.sh --write [SCENE]...
#                                       measures all scenes, or those named, and writes
#                                       their rows; an hour on two processors
here=$(dirname "$0")
. "$here/../lib/script.sh"

tool=build/host/tests/accuracy/scene_errors size=320x240
ticks='0 60 200 600'            # of errors.csv; twinkle.csv has the last
moving='lava three-swells storm count-64'       # scenes of twinkle.csv
seas='three-swells deep-sea count-64 night-sea' # scenes seen from other cameras too
cameras='14-m 50-m'             # at the last tick
cheap='minimal tank'

check "the measuring program builds" alone build "$tool"
[ "$failed" = 0 ] || exit 1

errors()        # SCENE
{
    # shellcheck disable=SC2086
    "$tool" "$here/scenes/$1.ini" $size $ticks || return 1
    case " $seas " in
    *" $1 "*)
        for camera in $cameras; do
            "$tool" --camera "$camera" "$here/scenes/$1.ini" $size "${ticks##* }" || return 1
        done ;;
    esac
}
# replace TABLE SCENE ROWS: puts the rows in the place of the scene's
replace()
{
    head -n 1 "$1" >"$scratch/table"
    { tail -n +2 "$1" | grep -v "^$2,"; cat "$3"; } |
        sort -t, -k1,1 -k3,4 -k2,2n >>"$scratch/table"
    cp "$scratch/table" "$1"
}

if [ "${1:-}" = --write ]; then
    shift
    [ $# -gt 0 ] || set -- $(basename -s .ini "$here"/scenes/*.ini)
    number=0
    for scene; do
        number=$((number + 1))
        [ ! -t 2 ] || printf '%s, %d of %d\n' "$scene" $number $# >&2
        errors "$scene" >"$scratch/rows" || exit 1
        replace "$here/errors.csv" "$scene" "$scratch/rows"
        case " $moving " in
        *" $scene "*)
            "$tool" --twinkle "$here/scenes/$scene.ini" $size "${ticks##* }" \
                >"$scratch/rows" || exit 1
            replace "$here/twinkle.csv" "$scene" "$scratch/rows" ;;
        esac
    done
    exit 0
fi

same_rows()     # SCENE: its rows of errors.csv are as measured now
{
    errors "$1" | sort >"$scratch/measured"
    grep "^$1," "$here/errors.csv" | sort | diff - "$scratch/measured"
}
for scene in $cheap; do
    check "$scene: errors.csv has what is measured" same_rows "$scene"
done
finish
