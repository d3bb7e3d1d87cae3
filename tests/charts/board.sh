#!/bin/sh
# SPDX-License-Identifier: MIT
# Exact instructions of a shipped scene's pictures, drawn by board.c in one run.
#
#   tests/charts/board.sh m4|m0|x86 SCENE SIZE TICK GROUP...
#
# Each GROUP is an argument of settings, separated by blanks, with size and tick if these
# differ; '' is the unchanged scene.  Prints a line of words for each GROUP:
#     N WIDTH HEIGHT WATER_PIXELS VERTICES TICK FRAME TILES SEEN CRC32
# TICK, FRAME, TILES: instructions of the last tick, of the beginning of the frame, of all
# tiles.  SEEN: the share of FRAME and TILES that finds the water: in tiles the code of
# src/view, raster, frame and waves; before the tiles all code except src/shade and src/pixel.
#
# m4: an emulated Cortex-M4, the board's compiler at -O2; m0: the same board with code for a
# Cortex-M0+; x86: baseline x86-64, -O2, by the user mode of QEMU.  `make charts-tools` builds
# the programs of m4 and x86, `make processor-tools` those of m4 and m0.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

[ $# -ge 5 ] || { echo "usage: board.sh m4|m0|x86 SCENE SIZE TICK GROUP..." >&2; exit 2; }
column=$1 scene=$2 words="$3 $4"
shift 4
words="$words $1"
pictures=$#
shift
for group; do
    words="$words / $group"
done

case $column in
m4|m0)
    case $column in m4) elf=cortex-m ;; m0) elf=m0plus ;; esac
    elf=build/$elf/charts/$scene.elf nm=arm-none-eabi-nm
    timeout 300 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial null \
        -chardev file,id=said,path="$scratch/said" -kernel "$elf" -plugin $plugin \
        -semihosting-config "enable=on,target=native,chardev=said,arg=$words" \
        2>"$scratch/counts" </dev/null ;;
x86)
    elf=build/host/tests/charts/board-$scene nm=nm
    # All words form one argument, as with semihosting.
    timeout 300 qemu-x86_64 -cpu Nehalem -plugin $plugin "$elf" "$words" \
        >"$scratch/said" 2>"$scratch/counts" </dev/null ;;
*)
    echo "board.sh: m4, m0 or x86, not $column" >&2; exit 2 ;;
esac || { cat "$scratch/said" >&2; grep -v ^count "$scratch/counts" >&2; exit 1; }

$nm -t d -n -l --defined-only "$elf" >"$scratch/symbols" &&
    awk -v pictures="$pictures" -f tests/lib/symbol_at.awk -f tests/charts/board.awk \
        "$scratch/symbols" "$scratch/said" "$scratch/counts"
