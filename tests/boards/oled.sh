#!/bin/sh
# SPDX-License-Identifier: MIT
# The OLED of the LM3S6965's evaluation board, live under the emulator: its screen equals
# the host's picture in 16 greys, each pixel, also after each of its buttons.
#
#   tests/boards/oled.sh [PROGRAM]
#
# The board prints the inputs of its buttons as lines of a tape, and the host replays
# them.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

program=${TP_PROGRAM:-${1:-build/host/tidepool}}
tools=${TP_BUILD:-build/host}/tests/boards
check "the tools build" build $tools/oled_greys $tools/same_picture
board_ready "the OLED of a Cortex-M3"

shows()         # TICK [OPTION]...: the screen is the host's picture at that tick
{
    at=$1; shift
    "$program" render $live_scene --size 128x64 --format l8 --frames "$at:$at" \
        --out "$scratch/host.png" "$@" &&
        $tools/oled_greys "$scratch/host.png" >"$scratch/host.ppm" &&
        dump "$scratch/screen.ppm" &&
        $tools/same_picture "$scratch/screen.ppm" "$scratch/host.ppm"
}

paused()        { is "$(ask pause)" "ok pause"; }
check "it pauses" paused
check "it goes on by steps" is "$(ask 'step 40')" "ok step 40"
state=$(ask state)
tick=$(tick_of "$state")
check "tick $tick is the host's picture" is "$(crc_of "$state")" "$(host_crc "$tick")"
check "so is the screen, every pixel" shows "$tick"
refuse "another tick's picture is another" shows $((tick + 1))
bytes=$(bytes_of "$state")
check "a frame is its pixels and one window" is "$bytes" $((128 * 64 / 2 + 6))

# Buttons act on release, which takes the emulator some time.
tape=$scratch/tape
inputs()        { whole_lines | grep '^[0-9]'; }
has_input()     { ask step >/dev/null; [ "$(inputs | wc -l)" -eq "$1" ]; }
pressed=0
press()         # KEY: presses a key, then lets some ticks pass
{
    pressed=$((pressed + 1))
    monitor "sendkey $1"
    until_true has_input $pressed && is "$(ask 'step 45')" "ok step 45"
}
for button in ctrl:poke: up:drops= left:sphere_x=-0.25 right:sphere_x=0.25 \
              down:light_turn=; do
    key=${button%%:*}
    effect=${button#*:} effect=${effect%:}
    check "button $key is input" press "$key"
    { echo "tape 2 tarn"; inputs; } >"$tape"
    check "it is what it stands for" grep -q " $effect" "$tape"
    state=$(ask state)
    tick=$(tick_of "$state")
    check "tick $tick is the host's picture with it" \
        is "$(crc_of "$state")" "$(host_crc "$tick" --tape "$tape")"
    sed '$d' "$tape" >"$tape.without"
    refuse "and not without it" is "$(crc_of "$state")" \
        "$(host_crc "$tick" --tape "$tape.without")"
done
check "so is the screen, every pixel" shows "$tick" --tape "$tape"
refuse "it is not that of untouched water" shows "$tick"

# With 32 ns an instruction, and 20 ns a clock cycle.
board_end
check "it starts by a clock of instructions" board_begin $live_elf -icount shift=5
ask pause >/dev/null; ask restart >/dev/null; ask "step 40" >/dev/null
state=$(ask state)
check "and draws the same" is "$(crc_of "$state")" "$(host_crc 40)"
echo "$bytes bytes a frame to the panel, $(($(clocks_of "$state") * 20 / 32)) instructions"
finish
