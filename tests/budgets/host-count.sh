#!/bin/sh
# SPDX-License-Identifier: MIT
# three-swells on this machine: exact instructions of the core by function, by callgrind.
. tests/gates/lib.sh

lacks valgrind valgrind "instructions on this machine" && exit 77
for size in 320x240 640x480; do
    valgrind --tool=callgrind --callgrind-out-file="$scratch/profile" \
        --collect-atstart=no --toggle-collect=tp_frame_begin \
        --toggle-collect=tp_frame_tile \
        build/host/tests/cross/frames-three-swells $size 0:1 rgb565 0x0 \
        2>"$scratch/held" >/dev/null || exit 1
    for inclusive in no yes; do
        callgrind_annotate --auto=no --threshold=100 --inclusive=$inclusive \
            "$scratch/profile" 2>/dev/null | sed "s/^/inclusive $inclusive /"
    done | awk -v size=$size -f tests/budgets/host.awk "$scratch/held" -
done
