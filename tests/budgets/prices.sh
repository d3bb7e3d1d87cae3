#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures the plan's cost table: instructions on an emulated Cortex-M4, and what slopes do
# to colours, on this machine over the shipped scenes.
#
#   tests/budgets/prices.sh             test: the table is made from the chart `prices`; with
#                                       TP_SOAK set the chart equals the measurement
#   tests/budgets/prices.sh --rows      rows of that chart
#   tests/budgets/prices.sh --write     writes a new chart and a new src/quality/prices.inc
#
# Build again after --write: the plan of a scene may change, and with it the pictures.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

table=assets/charts/prices.csv
made=src/quality/prices.inc
elf=build/cortex-m/prices.elf

if [ "${1:-}" = --write ]; then
    build all build/host/tests/budgets/slope_colour &&
        build/host/tidepool charts assets/charts --only prices || exit
    awk -f tests/budgets/prices.awk $table >"$scratch/made" && cp "$scratch/made" $made
    exit
fi

lacks arm-none-eabi-gcc gcc-arm-none-eabi "prices on a Cortex-M4" && exit 77
lacks qemu-system-arm qemu-system-arm "prices on a Cortex-M4" && exit 77

shade_functions()
{
    arm-none-eabi-nm --defined-only build/cortex-m4/src/shade/*.o \
        build/cortex-m4/src/features/*/*_stage.o |
        awk 'NF == 3 && $2 ~ /[tT]/ { print $3 }' | sort -u
}

measure()
{
    shade_functions >"$scratch/shade"
    awk -f tests/budgets/prices-count.awk "$scratch/shade" "$scratch/said" \
        "$scratch/counts" >"$scratch/costs" 2>"$scratch/fit" &&
        { echo "what,rung,item,figure"
          cat "$scratch/costs"
          sort -rn -k2 "$scratch/slopes" | awk '
              { printf "whole,-,slope_colour,%.3f\n", $2; exit }'; } >"$scratch/table"
}

same_made()
{
    awk -f tests/budgets/prices.awk $table | cmp - $made
}
if [ "${1:-}" = --rows ]; then
    exec 3>&1 1>&2
else
    check "$made is made from $table" same_made
    [ -n "${TP_SOAK:-}" ] || { finish; exit; }
fi
check "the board's program builds" build BOARD=cortex-m $elf
check "the plugin and the comparing program build" build $plugin \
    build/host/tests/budgets/slope_colour
check "the board draws every rung" emulate $elf "$scratch/said" "$scratch/counts"
check "slopes are compared" sh -c \
    "build/host/tests/budgets/slope_colour assets/scenes/*.ini >'$scratch/slopes'"
check "prices come of it" measure
if [ -f "$scratch/fit" ]; then sort "$scratch/fit"; fi
[ "$failed" = 0 ] || exit 1
if [ "${1:-}" = --rows ]; then
    awk -F, 'NR > 1 { print "prices," $1 ";" $2 ";" $3 ",figure," $4 }' \
        "$scratch/table" >&3
    exit
fi

# Within 5 %: other compilers count slightly differently.
near()
{
    awk -F, 'FNR == 1 { file++ }
        /^what,/ { next }
        { key = $1 "," $2 "," $3 }
        file == 1 { want[key] = $4; next }
        { got[key] = $4 }
        END {
            for (key in want)
                if (!(key in got))
                    print key ": no longer measured, of " want[key]
            for (key in got) {
                room = want[key] < 0 ? -want[key] : want[key]
                room = 0.05 * room + 1
                off = got[key] - want[key]
                if (!(key in want))
                    print key ": not in the table, " got[key]
                else if (off > room || -off > room)
                    print key ": " got[key] ", the table has " want[key]
            }
        }' $table "$scratch/table" | sort >"$scratch/off"
    cat "$scratch/off"
    ! [ -s "$scratch/off" ]
}
check "$table is what is measured here" near
finish
