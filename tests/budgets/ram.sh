#!/bin/sh
# SPDX-License-Identifier: MIT
# Working memory of scenes on a Cortex-M4 at 320x240, by use and by tile size, in addition
# to the frame buffer and the data in ROM; and a comparison with the goals.
#
#   tests/budgets/ram.sh
#
# Tables that depend only on the scene's numbers are counted separately: they could lie in
# ROM. Each frame must equal the host's. A missed goal is reported but does not fail the
# test.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${TP_PROGRAM:-build/host/tidepool}
lacks arm-none-eabi-gcc gcc-arm-none-eabi "memory on a Cortex-M4" && exit 77
lacks qemu-system-arm qemu-system-arm "memory on a Cortex-M4" && exit 77

drawn()         # SCENE: true if all pictures are equal, and equal the host's
{
    want=$("$program" render "$2" --rung named --size 320x240 --frames 60:60 --format rgb565 --hash)
    got=$(awk '{ print $NF }' "$scratch/$1.said" | sort -u)
    [ "$got" = "$(printf %d "0x${want##* }")" ] || { echo "$got is not $want"; false; }
}

table()         # SCENE GOAL INI
{
    elf=build/cortex-m/ram/$1.elf
    check "$1: the board's program builds" build BOARD=cortex-m "$elf"
    check "$1: it draws in the memory that it asks for" emulate "$elf" \
        "$scratch/$1.said" "$scratch/$1.counts"
    check "$1: every tiling, streamed or kept, draws as here" drawn "$1" "$3"
    [ "$failed" = 0 ] && awk -v scene="$1" -v goal="$2" -f tests/budgets/ram.awk \
        "$scratch/$1.counts" "$scratch/$1.said"
}

check "the plugin builds" build $plugin
table count-64 24576 assets/scenes/count-64.ini
table board-96k 98304 tests/budgets/board-96k.ini
finish
