#!/bin/sh
# SPDX-License-Identifier: MIT
# three-swells on an emulated Cortex-M4: its frames must be the host's, and what they cost
# in instructions, stack and RAM.
. tests/gates/lib.sh

program=${TP_PROGRAM:-build/host/tidepool}
elf=build/cortex-m/tidepool.elf
plugin=build/host/count.so

lacks arm-none-eabi-gcc gcc-arm-none-eabi "frames on a Cortex-M4" && exit 77
lacks qemu-system-arm qemu-system-arm "frames on a Cortex-M4" && exit 77

check "the program for the board builds" build BOARD=cortex-m elf
address()       # of a symbol
{
    echo 0x"$(arm-none-eabi-nm $elf | awk -v name="$1" '$3 == name { print $1 }')"
}

run_board()
{
    timeout 300 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial null \
        -chardev file,id=said,path="$scratch/board" \
        -semihosting-config enable=on,target=native,chardev=said -kernel $elf \
        -plugin $plugin,low="$(address stack_low)",high="$(address stack_top)" \
        2>"$scratch/counts" </dev/null
}
check "it runs to its end" run_board

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
