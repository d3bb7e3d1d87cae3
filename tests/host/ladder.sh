#!/bin/sh
# SPDX-License-Identifier: MIT
# tidepool plan --ladder and --board: the printed errors are those of the pictures that
# `render --step` draws, the total is that against the reference; costs fall from step to
# step; choices drawn by --set are the step's picture; a board gets the step that it holds.
# The flash printed is that of the step's baked program, linked for a Cortex-M4.
# With TP_SOAK set every step of three scenes is drawn, else the first, the last and one
# between.
#     ladder.sh PROGRAM
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/flash.sh"

program=$(realpath "$1")
rms=build/host/tests/host/picture_rms reference=build/host/reference
size=96x72
check "what measures the pictures builds" alone build -s $rms $reference
[ "$failed" = 0 ] || exit 1

drawn()         # NAME OPTION...: draws ticks 60 and 300 of the scene
{
    name=$1
    shift
    for tick in 60 300; do
        "$program" render "$scene" --size $size --frames $tick:$tick "$@" \
            --out "$scratch/$name-$tick.png" || return 1
    done
}
# listed STEP COLUMN: a cell of the scene's ladder
listed() { awk -F, -v step="$1" -v column="$2" '$1 == step { print $column }' "$scratch/csv"; }

off()           # NAME OF: rms and dB of two pairs of pictures
{
    $rms "$scratch/$2-60.png" "$scratch/$1-60.png" "$scratch/$2-300.png" \
        "$scratch/$1-300.png"
}
falls()         # the first step is exact, each further one is cheaper
{
    head -n 1 "$scratch/csv" |
        grep -qx 'step,choices,frame_m,tick_m,ram,flash,added,total,db' &&
        awk -F, 'NR == 2 && ($1 != 0 || $2 != "" || $7 != 0 || $9 != 99) { exit bad = 1 }
            NR > 2 && ($1 != last + 1 || $3 > cost) { print; exit bad = 1 }
            NR > 1 { last = $1; cost = $3; if (NF != 9) exit bad = 1 }
            END { exit bad || NR < 5 }' "$scratch/csv"
}
is_printed()    # STEP: added and dB
{
    drawn "step" --step "$1" && is "$(off step exact)" "$(listed "$1" 7) $(listed "$1" 9)"
}
is_total()      # STEP: rms against the reference's pictures
{
    drawn "step" --step "$1" && set -- "$1" "$(off step reference)" &&
        is "${2% *}" "$(listed "$1" 8)"
}
is_by_set()     # STEP: its choices, as settings, draw the same pictures
{
    set -- "$1" $(listed "$1" 2 | sed 's/ / --set /g; s/^./--set &/')
    step=$1
    shift
    drawn set --rung exact "$@" && drawn step --step "$step" &&
        is "$(off set step)" "0.00 99.0"
}
is_linked()     # STEP: its flash is that of the linked program
{
    bytes=$(flash_of_baked "$scene" --step "$1") || return 1
    flash_near "$(listed "$1" 6)" "$bytes"
}
referenced()    # the reference's pictures
{
    for tick in 60 300; do
        $reference "$scene" --size $size --frame $tick \
            --out "$scratch/reference-$tick.png" >/dev/null || return 1
    done
}

links=
flash_ready && links=1
for scene in minimal lava tank; do
    check "$scene: its ladder is printed" sh -c \
        "'$program' plan $scene --ladder --csv --size $size >'$scratch/csv'"
    check "$scene: from the exact picture down, each step cheaper" falls
    check "$scene: the exact picture is drawn" drawn exact --rung exact
    last=$(($(wc -l <"$scratch/csv") - 2))
    for step in $( [ -n "$TP_SOAK" ] && seq 0 $last || echo 0 $((last / 2)) $last); do
        check "$scene, step $step: the errors are those printed" is_printed "$step"
        [ -z "$links" ] ||
            check "$scene, step $step: flash is that of the linked program" \
                is_linked "$step"
    done
    check "$scene, step $last: --set with its choices draws it" is_by_set $last
done
check "the reference draws it" referenced
check "the total is the error against the reference" is_total 2

# -- boards ---------------------------------------------------------------------------

planned()       # BOARD FPS: its line
{
    "$program" plan tank --board "$1" --fps "$2" --csv | tail -n 1
}
holds()         # BOARD FPS SPEED (M instructions a second): the line keeps real time
{
    planned "$1" "$2" | awk -F, -v speed="$3" '
        { exit !($3 == "yes" && $2 * $5 + 60 * $6 <= speed) }'
}
gives_up()      # BOARD FPS
{
    planned "$1" "$2" | awk -F, '{ print; exit $3 != "no" }'
}
cheaper()       # more pictures a second leave less for one
{
    is "$({ planned stm32f405 4; planned stm32f405 2; } | cut -d, -f5 | sort -n | head -n 1)" \
        "$(planned stm32f405 4 | cut -d, -f5)"
}
check "a board that is fast enough keeps real time" holds stm32f746 5 216
check "at 60 pictures a second it does not" gives_up stm32f746 60
check "more pictures a second cost less each" cheaper
# An exact picture takes a Cortex-M0+ two to four times the instructions of a Cortex-M4, which
# both boards' speeds count.
own_prices()
{
    for board in stm32f405 rp2040; do
        "$program" plan count-64 --board $board --rung exact --csv | tail -n 1
    done | awk -F, '{ print; cost[NR] = $5 } END { exit !(cost[2] > 2 * cost[1] &&
        cost[2] < 4 * cost[1]) }' &&
        "$program" plan count-64 --board rp2040 | grep -q "M instructions a second" &&
        "$program" plan count-64 --board esp32s3 |
            grep -q "M instructions of a Cortex-M4 a second"
}
check "a Cortex-M0+ has prices of its own" own_prices
refused()
{
    "$program" plan tank --board pdp11 2>"$scratch/said"
    [ $? = 2 ] && grep -q "stm32f405, .* or microbit" "$scratch/said"
}
check "an unknown board is refused, with those that are known" refused
hints()         # what saves RAM, and what free RAM is good for
{
    "$program" plan three-swells --board stm32f405 |
        grep -q "^too much RAM: --stream, --band and --strip save some" &&
        "$program" plan count-64 --board stm32f405 --strip 64 --kept 4k >"$scratch/said" &&
        grep -q "; tiles of 64x16$" "$scratch/said" &&
        grep -q "^[0-9]* KB stay free: with --kept of more bytes" "$scratch/said" &&
        grep -q "^a picture is counted without the lines that are computed again$" \
            "$scratch/said"
}
check "a plan names what saves RAM, and what free RAM is good for" hints
not_counted()   # instructions of lines that are computed again
{
    "$program" plan count-64 --stream >"$scratch/said" &&
        grep -q "^and without the lines that --stream and --kept compute again.$" \
            "$scratch/said" &&
        ! "$program" plan count-64 | grep -q "compute again"
}
check "a plan of streamed water says what it does not count" not_counted
no_step()
{
    "$program" render minimal --step 39 --size $size --out "$scratch/no.png" \
        2>"$scratch/said"
    [ $? = 3 ] && grep -q "minimal.*: its ladder has steps 0 to [0-9]*, --step is 39" \
        "$scratch/said" && [ ! -e "$scratch/no.png" ]
}
check "a step that is not there is refused" no_step
finish
