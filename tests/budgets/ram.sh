#!/bin/sh
# SPDX-License-Identifier: MIT
# Working memory of scenes on a Cortex-M4 at 320x240, by use and by tile size, in addition
# to the frame buffer and the data in ROM; and a comparison with the goals.
#
#   tests/budgets/ram.sh
#
# The programs are baked, so that tables of the scene's numbers lie in ROM; those left in RAM
# count. NAME+cheap draws by the rungs of cheapest.txt. Each frame must equal the host's. A
# missed goal is reported but does not fail the test.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${TP_PROGRAM:-build/host/tidepool}
lacks arm-none-eabi-gcc gcc-arm-none-eabi "memory on a Cortex-M4" && exit 77
lacks qemu-system-arm qemu-system-arm "memory on a Cortex-M4" && exit 77

drawn()         # SCENE INI OPTION...: true if all pictures are equal, and equal the host's
{
    scene=$1
    shift
    want=$("$program" render "$@" --size 320x240 --frames 60:60 --format rgb565 --hash)
    got=$(awk '{ print $NF }' "$scratch/$scene.said" | sort -u)
    [ "$got" = "$(printf %d "0x${want##* }")" ] || { echo "$got is not $want"; false; }
}

table()         # SCENE GOAL MOST INI OPTION...
{
    elf=build/cortex-m/ram/$1.elf
    scene=$1 goal=$2 most=$3
    shift 3
    check "$scene: the board's program builds" build BOARD=cortex-m "$elf"
    check "$scene: it draws in the memory that it asks for" emulate "$elf" \
        "$scratch/$scene.said" "$scratch/$scene.counts"
    check "$scene: every tiling, stored or streamed, draws as here" drawn "$scene" "$@"
    [ "$failed" = 0 ] && awk -v scene="$scene" -v goal="$goal" -v most="$most" \
        -f tests/budgets/ram.awk "$scratch/$scene.counts" "$scratch/$scene.said"
}

check "the plugin builds" build $plugin
table count-64 24576 0 assets/scenes/count-64.ini
# shellcheck disable=SC2046
table count-64+cheap 24576 215 assets/scenes/count-64.ini \
    $(sed -n 's/^count-64 //p' tests/budgets/cheapest.txt)
table board-96k 98304 0 tests/budgets/board-96k.ini
finish
