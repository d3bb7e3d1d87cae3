#!/bin/sh
# SPDX-License-Identifier: MIT
# Every rung of every shipped scene against the scene's exact picture, 320x240: PSNR in dB
# (mean of ticks 60 and 300) and the largest difference of a channel, held to rungs.csv
# beside this script. Each rung is drawn in small tiles too and must not change a pixel.
# The line `fast` of a scene has every effect fast, `cheap` the rungs of
# tests/budgets/cheapest.txt; those must keep 28 dB. Every second scene is measured; with
# TP_SOAK set or --write, all.
#
#   tests/accuracy/rungs.sh             compares
#   tests/accuracy/rungs.sh --write     writes rungs.csv
here=$(dirname "$0")
. "$here/../lib/script.sh"

tool=build/host/tests/accuracy/scene_rungs table=$here/rungs.csv
write=
[ "${1:-}" != --write ] || write=1
check "the measuring program builds" alone build "$tool"
[ "$failed" = 0 ] || exit 1

rungs()         # SCENE
{
    # shellcheck disable=SC2046
    "$tool" "assets/scenes/$1.ini" $(sed -n "s/^$1 //p" tests/budgets/cheapest.txt) \
        >"$scratch/$1.csv"
}
set -- $(basename -s .ini assets/scenes/*.ini)
[ -n "$write$TP_SOAK" ] || set -- $(printf '%s\n' "$@" | sed -n 'p;n')
for scene; do
    check "$scene: every rung has the same bits in small tiles" rungs "$scene"
done
[ "$failed" = 0 ] || exit 1
{
    echo scene,rung,db,largest
    for scene; do cat "$scratch/$scene.csv"; done
} >"$scratch/table"
[ -z "$write" ] || cp "$scratch/table" "$table"
measured()      # the table's lines of the scenes that were measured
{
    awk -F, -v scenes="$*" 'NR == 1 || index(" " scenes " ", " " $1 " ")' "$table"
}
measured "$@" >"$scratch/expected"
check "rungs are as far from the exact pictures as rungs.csv says" \
    diff "$scratch/expected" "$scratch/table"
check "the cheapest rungs of each scene keep 28 dB" awk -F, '
    $2 == "cheap" && $3 < 28 { print; bad = 1 } END { exit bad }' "$scratch/table"
finish
