#!/bin/sh
# SPDX-License-Identifier: MIT
# Exact instructions of the core by function for a scene on this machine, by callgrind.
#
#   tests/budgets/host-count.sh SCENE
. "$(dirname "$0")/../lib/script.sh"

program=build/host/tests/cross/frames-$1
lacks valgrind valgrind "instructions on this machine" && exit 77
build "$program" >"$scratch/log" 2>&1 || { cat "$scratch/log"; exit 1; }
valgrind --tool=callgrind --callgrind-out-file="$scratch/profile" \
    --collect-atstart=no --toggle-collect=tp_frame_begin --toggle-collect=tp_frame_draw_tile \
    "$program" 320x240 60:61 rgb565 0x0 2>"$scratch/held" >/dev/null || exit 1
for inclusive in no yes; do
    callgrind_annotate --auto=no --threshold=100 --inclusive=$inclusive \
        "$scratch/profile" 2>/dev/null | sed "s/^/inclusive $inclusive /"
done | awk -v size="$1 at 320x240" -f tests/budgets/host.awk "$scratch/held" -
