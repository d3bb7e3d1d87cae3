#!/bin/sh
# SPDX-License-Identifier: MIT
# Whole frames of a shipped scene by each of its rungs (frames.c), as rows of the sweep:
# instructions a pixel of the picture, sky and all.
#
#   tests/charts/frames.sh m4|x86 SCENE WIDTH HEIGHT TICK
. tests/gates/lib.sh

[ $# = 5 ] || { echo "usage: frames.sh m4|x86 SCENE WIDTH HEIGHT TICK" >&2; exit 2; }
column=$1 scene=$2 size=$3x$4 tick=$5
build/host/tests/charts/frames rungs "$scene" "$3" "$4" >"$scratch/rungs" || exit 1
set --
while IFS=';' read -r name words; do
    set -- "$@" "$words"
done <"$scratch/rungs"
tests/charts/board.sh "$column" "$scene" "$size" "$tick" "$@" >"$scratch/counts" || exit 1
awk -F '[; ]' -v column="$column" -v scene="$scene" '
    NR == FNR { rung[NR] = $1; next }
    { printf "frames,%s;%s,%s,%.1f\n", scene, rung[$1], column, ($7 + $8) / ($2 * $3) }
    ' "$scratch/rungs" "$scratch/counts"
