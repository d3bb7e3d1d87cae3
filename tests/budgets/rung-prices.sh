#!/bin/sh
# SPDX-License-Identifier: MIT
# The factors and the errors of the rungs that sets of rungs are priced by.
#
#   tests/budgets/rung-prices.sh            the test: src/quality/rung_prices.inc is made
#                                           from rung-prices.csv beside this script
#   tests/budgets/rung-prices.sh --write    measures both again, 15 minutes: costs on the
#                                           emulated Cortex-M4 in 45 views of each shipped
#                                           scene, errors in 24
#   tests/budgets/rung-prices.sh --refit    fits again to the pictures counted by --write, 4
#                                           minutes: enough after changes of src/quality
#   tests/budgets/rung-prices.sh --errors   measures the errors alone, 8 minutes, and leaves
#                                           the factors
#   tests/budgets/rung-prices.sh --scene SCENE MODE VIEWS SEED
#                                           counts pictures of a scene, and prints them with
#                                           the parts of their cost and the prediction
#
# Build again after --write and --refit.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

table=tests/budgets/rung-prices.csv
made=src/quality/rung_prices.inc
samples=build/host/tests/budgets/rung_samples
kept=build/host/rung-counts     # lines MODE SCENE COUNT picture ..., and lines of errors
group=14                        # pictures of one run of the board

same_made()
{
    awk -f tests/budgets/rung-prices.awk -v to=inc $table | cmp - $made
}

# counted SCENE MODE: prints "MODE SCENE COUNT picture ..." of each picture in the samples.
counted()
{
    sed -n 's/^picture [^ ]* [^ ]* //p' "$scratch/samples" |
        xargs -d '\n' -n $group tests/charts/board.sh m4 "$1" 320x240 60 \
        >"$scratch/counts" || return 1
    awk -v of="$2 $1" 'FNR == NR { count[++n] = $7 + $8; next }
        $1 == "picture" { print of, count[++at], $0 }' "$scratch/counts" "$scratch/samples"
}
# priced FILE SCENE: prints "MODE SCENE KIND RUNG - COUNT SHADED ... ; PREDICTED" of each
# counted picture of a scene, by the program's prices.
priced()
{
    awk -v scene="$2" '$2 == scene && $4 == "picture"' "$1" >"$scratch/scene"
    awk '{ print $1, $2, $5, $6, "-", $3 }' "$scratch/scene" >"$scratch/names"
    sed 's/^[^ ]* [^ ]* [^ ]* //' "$scratch/scene" |
        $samples "assets/scenes/$2.ini" 0 0 again | sed -n 's/^parts //p' |
        paste -d' ' "$scratch/names" -
}
scenes()
{
    for ini in assets/scenes/*.ini; do basename "$ini" .ini; done
}
sampled()       # MODE VIEWS SEED: of all shipped scenes, two at a time
{
    scenes | xargs -P 2 -I{} "$0" --count {} "$1" "$2" "$3"
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
fitted()
{
    for scene in $(scenes); do priced $kept "$scene"; done >build/host/rung-samples
    grep '^error' $kept >>build/host/rung-samples
    meshes >>build/host/rung-samples
    awk -f tests/budgets/rung-prices.awk -v to=csv build/host/rung-samples \
        >"$scratch/table" &&
        cp "$scratch/table" $table &&
        awk -f tests/budgets/rung-prices.awk -v to=inc $table >$made
}

case ${1:-} in
--count)                # SCENE MODE VIEWS SEED
    "$samples" "assets/scenes/$2.ini" "$5" "$4" "$3" >"$scratch/samples" || exit 1
    case $3 in
    errors) sed "s/^error/error $2/" "$scratch/samples" ;;
    *)      counted "$2" "$3" ;;
    esac
    exit ;;
--scene)                # SCENE MODE VIEWS SEED
    "$0" --count "$2" "$3" "$4" "$5" >"$scratch/counted" || exit 1
    priced "$scratch/counted" "$2"
    exit ;;
--write)
    build $samples charts-tools >/dev/null || exit 1
    { sampled bases 9 5 && sampled rungs 1 1 && sampled mixed 8 9 && sampled errors 24 1
    } >$kept || exit 1
    # A walk looks for sets that the prices make too cheap: each fit is counted on the walks
    # of the prices before.
    for seed in 77 177 277; do
        sampled sets 9 $seed >>$kept && fitted && build $samples >/dev/null || exit 1
    done
    exit ;;
--errors)
    build $samples >/dev/null && sampled errors 24 1 >build/host/rung-errors || exit 1
    awk -f tests/budgets/rung-prices.awk -v to=csv build/host/rung-errors |
        grep ',sea[0-9]*,' >"$scratch/errors" || exit 1
    { grep '^[#k]\|^seen,\|^part,' $table
      { grep -v '^[#k]\|^seen,\|^part,\|,sea[0-9]*,' $table; cat "$scratch/errors"; } |
          sort -t, -k1,1 -k2,2n -k3,3; } >"$scratch/table" &&
        cp "$scratch/table" $table &&
        awk -f tests/budgets/rung-prices.awk -v to=inc $table >$made
    exit ;;
--refit)
    build $samples >/dev/null && fitted
    exit ;;
esac
check "$made is made from $table" same_made
finish
