#!/bin/sh
# SPDX-License-Identifier: MIT
# Water renderers for a shipped scene at 320x240, tick 60 (visibility.c), as rows of the
# sweep: instructions a pixel of water; or errors.
#
#   tests/charts/visibility.sh m4|x86|error SCENE
. "$(dirname "$0")/../lib/script.sh"

[ $# = 2 ] || { echo "usage: visibility.sh m4|x86|error SCENE" >&2; exit 2; }
column=$1 scene=$2 visibility=build/host/tests/charts/visibility
if [ "$column" = error ]; then
    $visibility errors "$scene" 320 240 60
    exit
fi
$visibility points "$scene" 320 240 >"$scratch/points" || exit 1
set --
while read -r name words; do
    set -- "$@" "$words"
done <"$scratch/points"
tests/charts/board.sh "$column" "$scene" 320x240 60 "$@" >"$scratch/counts" || exit 1
awk -v column="$column" -v scene="$scene" '
    NR == FNR { point[NR] = $1; next }
    {
        printf "visibility,%s;%s,%s_seen,%.1f\n", scene, point[$1], column, $9 / $4
        printf "visibility,%s;%s,%s,%.1f\n", scene, point[$1], column, ($7 + $8) / $4
    }' "$scratch/points" "$scratch/counts"
