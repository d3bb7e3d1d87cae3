#!/bin/sh
# SPDX-License-Identifier: MIT
# The charts count the pictures that the program draws: the pictures of board.c have the
# same CRCs on the emulated Cortex-M4, with code for a Cortex-M0+ and on this machine, by all
# rungs, grids and sizes; the picture of the unchanged scene equals the program's; successive
# pictures differ.
#
#   tests/charts/same.sh [PROGRAM [SCENE...]]
. "$(dirname "$0")/../lib/script.sh"

program=${1:-build/host/tidepool}
[ $# -gt 0 ] && shift
[ $# -gt 0 ] || set -- count-64 harbour
lacks arm-none-eabi-gcc gcc-arm-none-eabi "charts' pictures" && exit 77
lacks qemu-system-arm qemu-system-arm "charts' pictures" && exit 77
lacks qemu-x86_64 qemu-user "charts' pictures" && exit 77

check "what draws for the charts builds" build charts-tools
for scene; do
    check "$scene builds for a Cortex-M0+" build BOARD=cortex-m/m0plus \
        "build/m0plus/charts/$scene.elf"
done
[ "$failed" = 0 ] || exit 1

crcs()          # m4|m0|x86 SCENE
{
    tests/charts/board.sh "$1" "$2" 160x120 20 '' \
        'quality.visibility=triangles water.specular=0.5' grid/2 \
        '96x64 3 grid=400' 'bare water.specular=0.25' >"$scratch/pictures" &&
        awk '{ printf "%08x\n", $NF }' "$scratch/pictures"
}

same()          # SCENE
{
    crcs m4 "$1" >"$scratch/m4" || return 1
    crcs m0 "$1" >"$scratch/m0" || return 1
    crcs x86 "$1" >"$scratch/x86" || return 1
    "$program" render "assets/scenes/$1.ini" --size 160x120 --frames 20:20 \
        --format rgb565 --hash >"$scratch/hash" || return 1
    paste -d ' ' "$scratch/m4" "$scratch/m0" "$scratch/x86" "$scratch/hash" >"$scratch/all"
    cat "$scratch/all"
    awk '$1 != $2 || $1 != $3 || $1 == last || (NR == 1 && $1 != $7) { off = 1 }
         { last = $1 }
         END { exit off || NR != 5 }' "$scratch/all"
}

for scene; do
    check "$scene: what is counted is what is drawn" same "$scene"
done
finish
