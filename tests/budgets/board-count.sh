#!/bin/sh
# SPDX-License-Identifier: MIT
# three-swells on an emulated Cortex-M4: its frames must be the host's, and what they cost
# in instructions, stack and RAM.
. tests/gates/lib.sh
. tests/budgets/board.sh

program=${TP_PROGRAM:-build/host/tidepool}
elf=build/cortex-m/scenes/three-swells.elf

lacks arm-none-eabi-gcc gcc-arm-none-eabi "frames on a Cortex-M4" && exit 77
lacks qemu-system-arm qemu-system-arm "frames on a Cortex-M4" && exit 77

check "the program for the board builds" build BOARD=cortex-m elf
check "it runs to its end" emulate $elf "$scratch/board" "$scratch/counts"

# The board's frames against those of the program, which reads the scene from its files.
equal()
{
    size=$1
    awk -v size="$size" '/^size/ { now = $2 } /^frame/ && now == size' "$scratch/board" \
        >"$scratch/seen"
    "$program" render assets/scenes/three-swells.ini --size "$size" --frames 0:1 \
        --format rgb565 --hash >"$scratch/host" && test -s "$scratch/seen" &&
        diff "$scratch/host" "$scratch/seen"
}
for size in 320x240 640x480; do
    check "its frames at $size are the host's" equal $size
done

echo
arm-none-eabi-size -A build/cortex-m/libtidepool.a | awk '
    /^\.text/   { text += $2 }
    /^\.rodata/ { constants += $2 }
    END { printf "core on Cortex-M4: text %d bytes, constants %d\n", text, constants }'
awk -f tests/budgets/board.awk "$scratch/board" "$scratch/counts"
exit $((failures > 0))
