#!/bin/sh
# SPDX-License-Identifier: MIT
# Scenes that fit in the RAM of a Raspberry Pi Pico, as the table of ports/pico/README.md
# says with which options: an emulated Pico starts each of them and takes its memory, and in
# the soak draws frame 60 with the host's bits.  count-64 is drawn with the step that the plan
# chooses for the board.
#
#   tests/boards/pico_scenes.sh [PROGRAM]
. "$(dirname "$0")/../lib/script.sh"

program=${TP_PROGRAM:-${1:-build/host/tidepool}}
here=tests/boards/pico client=build/tests/pico folder=build/pico_scenes/scenes
pictures=${TP_SOAK:+1}
for tool in arm-none-eabi-gcc=gcc-arm-none-eabi node=nodejs npm=npm; do
    lacks "${tool%=*}" "${tool#*=}" "scenes on a Raspberry Pi Pico" && exit 77
done
check "the emulator is installed" $here/install.sh $client

emulated()      # SCENE: the words of its serial port, and a CRC
{
    arm-none-eabi-nm "$folder/$1.elf" |
        timeout 600 node $here/run.js $client "$folder/$1.bin" ${pictures:-0} >"$scratch/said"
}
starts()        # SCENE
{
    emulated "$1" && grep -q '^ram .* left [0-9]' "$scratch/said" &&
        grep -q '^ok ' "$scratch/said"
}
options_of()    # SCENE: the options of its rungs
{
    case $1 in *+cheap) sed -n "s/^${1%+cheap} //p" tests/budgets/cheapest.txt ;; esac
}
draws()         # SCENE@TEXELS: frame 60 is the host's
{
    of=${1%@*}
    # shellcheck disable=SC2046
    want=$("$program" render "${of%+cheap}" --texels "${1#*@}" --size 320x240 --hash \
        --format rgb565be --frames 60:60 $(options_of "$of") | sed 's/^frame [0-9]* //')
    is "$(sed -n 's/^frame 0060 //p' "$scratch/said")" "$want"
}

# "OPTIONS|SCENE SCENE": rows of the table.
sed -n '/^| options of/,/^$/s/^| *\([A-Z`][^|]*\)*| \(`.*`\) |$/\1|\2/p' ports/pico/README.md |
    tr -d '`' >"$scratch/rows"
check "the page has a table of scenes" test -s "$scratch/rows"
while IFS='|' read -r options scenes; do
    goals=
    for scene in $scenes; do
        goals="$goals $folder/$scene.elf $folder/$scene.bin"
    done
    # shellcheck disable=SC2086
    check "programs build ${options:+with $options}" \
        alone build -s BOARD=pico TARGET=pico_scenes $options $goals
    for scene in $scenes; do
        check "$scene fits ${options:+with $options}" starts "$scene"
        [ -z "$pictures" ] || check "$scene: frame 60 is the host's" draws "$scene"
    done
done <"$scratch/rows"
# -- the step that the plan chooses ----------------------------------------------------

# Frame 61 by two cores: begin and the busier core's tiles, in cycles.
step=$("$program" plan count-64 --board rp2040 --fps 8 --csv </dev/null |
    awk -F, 'NR == 2 { n = split($4, row, " ")
        for (i = 1; i <= n; i++) printf "--set %s ", row[i] }')
fast_enough()   # MILLIONS
{
    awk -v most="$1" '$1 == "cycles" { n++; cycles = $3 + ($6 > $7 ? $6 : $7) }
        END { print cycles / 1e6 " M"; exit !(n == 2 && cycles <= 1e6 * most) }' \
        "$scratch/said"
}
check "count-64 builds with the step of an RP2040" alone build -s BOARD=pico \
    TARGET=pico_scenes STRIP=128 SETTINGS="$step" $folder/count-64@64.elf \
    $folder/count-64@64.bin
step_draws()
{
    pictures=2 emulated count-64@64
    # shellcheck disable=SC2086
    is "$(sed -n 's/^frame 006[01] //p' "$scratch/said")" "$("$program" render count-64 \
        --texels 64 --size 320x240 --hash --format rgb565be --frames 60:61 $step |
        sed 's/^frame [0-9]* //')"
}
check "its frames 60 and 61 are the host's" step_draws
check "frame 61 takes at most 16 M cycles" fast_enough 16
refuse "but not 12" fast_enough 12

check "a program for another scene builds" alone build -s BOARD=pico TARGET=pico_scenes \
    $folder/calm-bay@64.elf $folder/calm-bay@64.bin
refuse "calm-bay@64 does not fit" starts calm-bay@64
finish
