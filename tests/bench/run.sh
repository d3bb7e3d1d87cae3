#!/bin/sh
# SPDX-License-Identifier: MIT
# Scene S in instructions a covered pixel, by callgrind, inside tp_frame_begin and
# tp_frame_tile; unlike the figures of others, the waves' own cost is in it.
#
#   tests/bench/run.sh SCENE_S
. tests/gates/lib.sh

lacks valgrind valgrind "scene S" && exit 77
printf '%-9s %10s %14s %14s %12s %12s\n' size 'water px' 'insns a frame' \
    'begin' 'a water px' 'TinyGL'
for size in 640x480:240 320x240:627; do
    tinygl=${size#*:} size=${size%:*}
    valgrind --tool=callgrind --callgrind-out-file="$scratch/profile" \
        --collect-atstart=no --toggle-collect=tp_frame_begin \
        --toggle-collect=tp_frame_tile "$1" "${size%x*}" "${size#*x}" \
        >"$scratch/held" 2>/dev/null || exit 1
    callgrind_annotate --auto=no --threshold=100 --inclusive=yes "$scratch/profile" \
        2>/dev/null | awk -v size="$size" -v tinygl="$tinygl" '
        $1 == "water_pixels"                 { water = $2 }
        /PROGRAM TOTALS/                     { gsub(/,/, "", $1); total = $1 }
        /:tp_frame_begin/                    { gsub(/,/, "", $1); begin = $1 }
        END {
            printf "%-9s %10d %14d %14d %12.1f %12s\n", size, water, total, begin,
                total / water, tinygl
            exit !(total && water)
        }' "$scratch/held" - || exit 1
done
