#!/bin/sh
# SPDX-License-Identifier: MIT
# Instructions of scene S by callgrind, for a second tp_frame_begin and
# tp_frame_draw_tile: a whole frame, waves and sky included, on 128 x 128 points.
#
#   tests/bench/run.sh SCENE_S [NAME=VALUE]...         (quality.visibility=rows)
. "$(dirname "$0")/../lib/script.sh"

lacks valgrind valgrind "instructions of scene S" && exit 77
scene_s=$1; shift
printf '%-9s %-7s %9s %13s %13s %11s\n' size work 'water px' 'insns a frame' 'its begin' \
    'a water px'
for size in 640x480 320x240; do
    for work in plain full smooth; do
        valgrind --tool=callgrind --callgrind-out-file="$scratch/profile" \
            --collect-atstart=no --toggle-collect=counted \
            "$scene_s" "${size%x*}" "${size#*x}" 128 $work "$@" \
            >"$scratch/held" 2>/dev/null || exit 1
        callgrind_annotate --auto=no --threshold=100 --inclusive=yes "$scratch/profile" \
            2>/dev/null | awk -v size=$size -v work=$work '
            $1 == "water_pixels"                 { water = $2 }
            /PROGRAM TOTALS/                     { gsub(/,/, "", $1); total = $1 }
            /:tp_frame_begin/                    { gsub(/,/, "", $1); begin = $1 }
            END {
                printf "%-9s %-7s %9d %13d %13d %11.1f\n", size, work, water, total,
                    begin, total / water
                exit !(total && water)
            }' "$scratch/held" - || exit 1
    done
done
