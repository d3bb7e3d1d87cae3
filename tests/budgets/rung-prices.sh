#!/bin/sh
# SPDX-License-Identifier: MIT
# The factors and the errors of the rungs that sets of rungs are priced by.
#
#   tests/budgets/rung-prices.sh            the test: src/quality/rung_prices.inc is made
#                                           from rung-prices.csv beside this script
#   tests/budgets/rung-prices.sh --write    measures both again, 10 minutes: costs on the
#                                           emulated Cortex-M4 in 11 views of each shipped
#                                           scene, errors in 24
#
# Build again after --write.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

table=tests/budgets/rung-prices.csv
made=src/quality/rung_prices.inc
samples=build/host/tests/budgets/rung_samples
group=14                        # pictures of one run of the board

same_made()
{
    awk -f tests/budgets/rung-prices.awk -v to=inc $table | cmp - $made
}

# counted FILE SCENE: prints "KIND RUNG TICK FRAME FAST SET PARTS... ; PREDICTED" of each
# picture in the file of rung_samples.
counted()
{
    sed -n 's/^picture [^ ]* [^ ]* //p' "$1" |
        xargs -d '\n' -n $group tests/charts/board.sh m4 "$2" 320x240 60 \
        >"$scratch/counts" || return 1
    awk 'FNR == NR { count[++n] = $6 " " $7 + $8; next }
        $1 == "picture" { name = $2 " " $3 }
        $1 == "parts"   { sub(/^parts /, ""); print name, count[++at], $0 }' \
        "$scratch/counts" "$1"
}
sampled()       # MODE VIEWS SEED: of all shipped scenes, two at a time
{
    for ini in assets/scenes/*.ini; do basename "$ini" .ini; done |
        xargs -P 2 -I{} "$0" --scene {} "$1" "$2" "$3"
}

# The board's program has one mesh: what other meshes save is counted in storm.
meshes()
{
    faces=$("$samples" assets/scenes/storm.ini 1 0 faces)
    awk -F, -v faces="$faces" '$2 == "instructions" { count[$1] = $3 }
        END { print "mesh", 1, count["storm+exact"] - count["storm+mesh"], faces
              print "mesh", 2, count["storm+exact"] - count["storm+mesh-low"], faces }' \
        tests/budgets/scenes.csv
}

case ${1:-} in
--scene)                # SCENE MODE VIEWS SEED
    "$samples" "assets/scenes/$2.ini" "$5" "$4" "$3" >"$scratch/samples" || exit 1
    case $3 in
    errors) sed "s/^error/error $2/" "$scratch/samples" ;;
    *)      counted "$scratch/samples" "$2" | sed "s/^/$3 $2 /" ;;
    esac
    exit ;;
--write)
    build $samples charts-tools >/dev/null || exit 1
    { sampled bases 6 5 && sampled rungs 1 1 && sampled mixed 4 9 && sampled errors 24 1 && meshes
    } >build/host/rung-samples || exit 1
    awk -f tests/budgets/rung-prices.awk -v to=csv build/host/rung-samples \
        >"$scratch/table" &&
        cp "$scratch/table" $table &&
        awk -f tests/budgets/rung-prices.awk -v to=inc $table >$made
    exit ;;
esac
check "$made is made from $table" same_made
finish
