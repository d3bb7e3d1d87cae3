#!/bin/sh
# SPDX-License-Identifier: MIT
# Growth of the cost with the size of a scene, as rows of the sweep: instructions, and the
# line base + slope n with the smallest sum of squared relative errors.
#
#   tests/charts/scale.sh m4|x86 pixels|vertices|waves|cells
#   tests/charts/scale.sh x86 threads
#
# pixels, vertices, waves: a frame of count-64; cells: a tick of the tank's 16-bit cells,
# after waves have crossed the tank: cells at rest cost less; threads: the busiest of n
# threads that draw three-swells at 640x480, a frame.
. "$(dirname "$0")/../lib/script.sh"

usage() { echo "usage: scale.sh m4|x86 pixels|vertices|waves|cells|threads" >&2; exit 2; }
[ $# = 2 ] || usage
column=$1 kind=$2 scene=count-64 of=frame

# Ever shorter waves, too low to change the amount of visible water; no wave is left out.
waves()         # N
{
    awk -v n="$1" 'BEGIN {
        printf "quality.error_px=0 quality.error_colour=0"
        for (i = 0; i < 16; i++)
            printf " wave%d.amplitude=%.3f wave%d.length=%.1f wave%d.heading=%d" \
                " wave%d.steepness=0.01", i, i < n ? 0.002 * (22 - 1.2 * i) : 0, \
                i, 22 - 1.2 * i, i, i * 23, i
    }'
}

# busiest THREADS FRAMES: instructions of the busiest of the threads
busiest()
{
    rm -f "$scratch"/calls*
    valgrind --quiet --tool=callgrind --separate-threads=yes --fair-sched=yes \
        --callgrind-out-file="$scratch/calls" build/host/tidepool render three-swells \
        --size 640x480 --frames "$2" --threads "$1" --out "$scratch/film.y4m" \
        >"$scratch/said" 2>&1 || return 1
    sed -n 's/^totals: //p' "$scratch"/calls* | sort -n | tail -1
}

# The main thread also loads the scene: the difference of two films is that of frames.
threads()
{
    for n in 1 2 3 4 6 8; do
        few=$(busiest "$n" 60:61) && many=$(busiest "$n" 60:69) || return 1
        awk -v n="$n" -v all=$((many - few)) \
            'BEGIN { printf "scale,threads;%d,x86,%.4g\n", n, all / 8 }'
    done
}

set --
case $column.$kind in
x86.threads)
    threads; exit ;;
*.pixels)
    for n in 80x60 160x120 240x180 320x240 480x360 640x480; do set -- "$@" "$n"; done ;;
*.vertices)
    for n in 350 800 1350 3000 5400 12000 22000; do set -- "$@" "320x240 grid=$n"; done ;;
*.waves)
    for n in 1 2 3 4 6 8 12 16; do set -- "$@" "320x240 $(waves "$n")"; done ;;
*.cells)
    scene=tank of=tick
    for n in 16 32 48 64 96 128 192 256; do
        set -- "$@" "64x48 300 pool.cols=$n pool.rows=$n"
    done ;;
*)
    usage ;;
esac

tests/charts/board.sh "$column" $scene 320x240 60 "$@" >"$scratch/counts" || exit 1
awk -v column="$column" -v kind="$kind" -v of=$of -v points="$*" '
    {
        cost[NR] = of == "tick" ? $6 : $7 + $8
        n[NR] = kind == "pixels" ? $2 * $3 : kind == "vertices" ? $5 : 0
    }
    END {
        split("1 2 3 4 6 8 12 16", waves, " ")
        split("16 32 48 64 96 128 192 256", side, " ")
        for (i = 1; i <= NR; i++) {
            n[i] = kind == "waves" ? waves[i] : kind == "cells" ? side[i] * side[i] : n[i]
            w = 1 / cost[i] / cost[i]
            s += w; sn += w * n[i]; sc += w * cost[i]
            snn += w * n[i] * n[i]; snc += w * n[i] * cost[i]
        }
        slope = (s * snc - sn * sc) / (s * snn - sn * sn)
        base = (sc - slope * sn) / s
        for (i = 1; i <= NR; i++) {
            row = "scale," kind ";" n[i] "," column
            printf "%s,%.0f\n", row, cost[i]
            printf "%s_base,%.4g\n", row, base
            printf "%s_slope,%.4g\n", row, slope
            printf "%s_off,%.2f\n", row, 100 * (cost[i] / (base + slope * n[i]) - 1)
        }
    }' "$scratch/counts"
