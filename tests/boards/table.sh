#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures scenes on boards that QEMU emulates, a row of configurations.csv each: flash, RAM,
# stack, instructions of a frame, cycles for a Cortex-M0, and the bytes sent to a display.
#
#   tests/boards/table.sh [FOLDER | --write]
#
# Runs the programs on emulated boards and counts their instructions by the plugin.  FOLDER
# keeps the output of each program (BOARD/SCENE.said), which has the frames.
# --write writes the rows, and the pages' tables of all rows (figures.sh).
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"
. "$(dirname "$0")/../lib/flash.sh"
. "$(dirname "$0")/../lib/rows.sh"

# board | scene, @ largest side of its textures in texels; one of the boards is live
shots='
netduinoplus2     count-64@64
netduinoplus2     lava@64
netduinoplus2     board-96k@64
microbit          bay@64
stm32vldiscovery  bay@64
lm3s6965evb       tarn
'
live=$live_board
sent=build/host/tests/boards/sent cycles=build/host/cycles.so
to=${1:-$scratch}
[ "$to" != --write ] || to=$scratch

# Draws two frames and ends. Of a Cortex-M0 the cycles are counted too.
run()           # BOARD SCENE
{
    timed=
    [ "$1" != microbit ] || timed="-plugin $cycles"
    # shellcheck disable=SC2086
    timeout 60 qemu-system-arm -M "$1" -nographic -monitor none -serial null \
        -chardev file,id=said,path="$to/$1/$2.said" \
        -semihosting-config enable=on,target=native,chardev=said -kernel "$elf" \
        -plugin $plugin $timed 2>"$to/$1/$2.counts" </dev/null ||
        { cat "$to/$1/$2.said" >&2; return 1; }
    # shellcheck disable=SC2046
    $sent $(awk '/^picture/ { print $2, $4, $3 }' "$to/$1/$2.said") >"$scratch/sent" &&
        echo "sent $(cat "$scratch/sent")" >"$to/$1/$2.sent"
}

# Draws the same two frames by commands; the board counts the sent bytes itself. The
# counted picture is drawn by `state`: no other line arrives meanwhile to interrupt it.
talk()          # BOARD SCENE
{
    board_begin "$elf" -plugin $plugin || { board_end; cat "$scratch/emulator" >&2; return 1; }
    for line in pause restart "step 60" state step state; do
        last=$(ask "$line")
    done
    board_end
    cp "$scratch/emulator" "$to/$1/$2.counts"
    echo "sent $(bytes_of "$last")" >"$to/$1/$2.sent"
    whole_lines | awk '
        /^(ram|picture) /
        /^ok tick / {
            gsub(",", "")
            print "frame", $3, $4, $5
            print $(NF - 3), $(NF - 2)
            stack = $NF
        }
        END { print "ram stack", stack }' >"$to/$1/$2.said"
}

shoot()         # BOARD SCENE
{
    elf=build/$1/scenes/$2.elf
    mkdir -p "$to/$1"
    alone build -s BOARD="cortex-m/$1" SCENE="$2" elf >"$scratch/log" 2>&1 ||
        { cat "$scratch/log" >&2; return 1; }
    arm-none-eabi-size -A "$elf" >"$to/$1/$2.size"
    memory_of "build/$1/baked/$2.c" >"$to/$1/$2.head"
    if [ "$1" = "${live#*/}" ]; then talk "$1" "$2"; else run "$1" "$2"; fi
}

alone build -s $plugin $cycles $sent >/dev/null || exit 1
echo "$shots" | while read -r board scene; do
    [ -z "$board" ] || shoot "$board" "$scene" || exit 1
    [ -z "$board" ] || echo "$board/$scene"
done >"$scratch/shots" || exit 1
awk -v from="$to" -f tests/boards/table.awk "$scratch/shots" >"$scratch/rows" ||
    { cat "$scratch/rows"; exit 1; }
if [ "${1:-}" = --write ]; then
    rows_put "$scratch/rows"
else
    cat "$scratch/rows"
fi
