#!/bin/sh
# SPDX-License-Identifier: MIT
# Whole frames of a shipped scene at 320x240, tick 60, by each rung (frames.c), as rows of
# the sweep: instructions a pixel of the picture, sky included; or errors.
#
#   tests/charts/frames.sh m4|x86|error SCENE
. "$(dirname "$0")/../lib/script.sh"

[ $# = 2 ] || { echo "usage: frames.sh m4|x86|error SCENE" >&2; exit 2; }
column=$1 scene=$2 frames=build/host/tests/charts/frames
if [ "$column" = error ]; then
    $frames errors "$scene" 320 240 60
    exit
fi
$frames rungs "$scene" 320 240 >"$scratch/rungs" || exit 1
set --
while IFS=';' read -r name words; do
    set -- "$@" "$words"
done <"$scratch/rungs"
tests/charts/board.sh "$column" "$scene" 320x240 60 "$@" >"$scratch/counts" || exit 1
awk -F '[; ]' -v column="$column" -v scene="$scene" '
    NR == FNR { rung[NR] = $1; next }
    { printf "frames,%s;%s,%s,%.1f\n", scene, rung[$1], column, ($7 + $8) / ($2 * $3) }
    ' "$scratch/rungs" "$scratch/counts"
