# SPDX-License-Identifier: MIT
# A live board under the emulator, controlled over its serial port and its monitor; read
# by `.` after tests/gates/lib.sh.
#
#   begin ELF [OPTION]...      starts the board and waits for its "ok NAME"
#   ask LINE                   sends a line; prints its answer, or nothing after 10 s
#   monitor COMMAND            sends a command to the emulator
#   dump FILE                  waits for the picture of the screen
#   finish                     ends the emulator
#
# The board's output is in $scratch/said. No wait exceeds 10 s, no run exceeds 60 s.

board=cortex-m/lm3s6965evb
elf=build/lm3s6965evb/scenes/tarn.elf
scene=ports/cortex-m/scenes/tarn.ini
emulator=
trap 'finish; rm -rf "$scratch"' EXIT

until_true()    # COMMAND...: within 10 s
{
    tries=0
    until "$@"; do
        tries=$((tries + 1))
        [ $tries -lt 1000 ] || return 1
        sleep 0.01
    done
}

begin()
{
    kernel=$1; shift
    rm -f "$scratch/serial" "$scratch/monitor.in" "$scratch/monitor.out"
    mkfifo "$scratch/serial" "$scratch/monitor.in" "$scratch/monitor.out"
    exec 3<>"$scratch/serial" 4<>"$scratch/monitor.in" 5<>"$scratch/monitor.out"
    : >"$scratch/said"
    cat <&5 >/dev/null 3>&- 4>&- &
    drain=$!
    timeout 60 qemu-system-arm -M lm3s6965evb -display none \
        -monitor "pipe:$scratch/monitor" -chardev stdio,id=serial,signal=off \
        -serial chardev:serial -kernel "$kernel" "$@" \
        <&3 >"$scratch/said" 2>"$scratch/emulator" 3>&- 4>&- 5>&- &
    emulator=$!
    until_true said_more 0
}

# Only complete lines are answers.
whole_lines()   { head -n "$(wc -l <"$scratch/said")" "$scratch/said"; }
answers()       { whole_lines | grep -c '^ok\|^error'; }
said_more()     { [ "$(answers)" -gt "$1" ]; }

ask()
{
    before=$(answers)
    printf '%s\n' "$1" >&3
    until_true said_more "$before"
    whole_lines | grep '^ok\|^error' | tail -n 1
}

monitor()       { printf '%s\n' "$1" >&4; }

is_whole()      { [ -f "$1" ] && [ "$(wc -c <"$1")" -eq 393231 ]; }    # 512 x 256
dump()
{
    rm -f "$1"
    monitor "screendump $1"
    until_true is_whole "$1"
}

finish()
{
    [ "$emulator" ] || return 0
    kill "$emulator" "$drain" 2>/dev/null
    wait "$emulator" "$drain" 2>/dev/null
    emulator=
}

# Fields of the answer to `state`.
tick_of()       { echo "$1" | sed 's/ok tick \([0-9]*\).*/\1/'; }
crc_of()        { echo "$1" | sed 's/.* crc32 \([0-9a-f]*\).*/\1/'; }
bytes_of()      { echo "$1" | sed 's/.* bytes sent \([0-9]*\).*/\1/'; }
clocks_of()     { echo "$1" | sed 's/.* clocks \([0-9]*\).*/\1/'; }

# Prints the host's CRC at a tick.
host_crc()      # TICK [OPTION]...
{
    at=$1; shift
    "$program" render $scene --size 128x64 --format l8 --frames "$at:$at" --hash "$@" |
        sed 's/.* //'
}

is()            { [ "$1" = "$2" ] || { echo "$1, not $2"; false; }; }

ready()         # WHAT: exits with 77 if a tool is missing; builds the program
{
    lacks qemu-system-arm qemu-system-arm "$1" && exit 77
    lacks arm-none-eabi-gcc gcc-arm-none-eabi "$1" && exit 77
    check "the board's program builds" alone build BOARD=$board SCENE=tarn elf
    [ $failures = 0 ] || exit 1
    check "the board starts" begin $elf
    [ $failures = 0 ] || exit 1
}
