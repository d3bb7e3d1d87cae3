#!/bin/sh
# SPDX-License-Identifier: MIT
# The steps that `tidepool plan --board rp2040` finds, counted on the emulated board with code
# for a Cortex-M0+: pictures at ticks 60 and 61, with the host's bits, and a tick.
#
#   tests/budgets/board-steps.sh            count-64 and three-swells against the plan's
#                                           estimates and the page's table
#   tests/budgets/board-steps.sh --write    writes the table of ports/BOARDS.md
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

page=ports/BOARDS.md board=rp2040 steps=build/steps
program=${TP_PROGRAM:-build/host/tidepool}
for tool in arm-none-eabi-gcc:gcc-arm-none-eabi qemu-system-arm:qemu-system-arm; do
    lacks "${tool%:*}" "${tool#*:}" "steps of a $board" && exit 77
done

# Writes the step of a scene as options, if it has changed, and its estimates.
planned()       # SCENE
{
    "$program" plan "$1" --board $board --fps 10 --csv </dev/null >"$scratch/$1.csv" &&
        awk -F, 'NR == 2 { n = split($4, row, " ")
            for (i = 1; i <= n; i++) printf "--set %s ", row[i] }' "$scratch/$1.csv" \
            >"$scratch/$1.txt" && mkdir -p $steps || return 1
    cmp -s "$scratch/$1.txt" "$steps/$board-$1.txt" ||
        cp "$scratch/$1.txt" "$steps/$board-$1.txt"
}
made()          # SCENE...
{
    set -- $(printf "build/m0plus/charts/$board-%s.elf\n" "$@")
    build build/host/count.so build/host/cycles.so && build BOARD=cortex-m/m0plus "$@"
}
same_bits()     # SCENE
{
    awk '{ printf "%08x\n", $10 }' "$scratch/$1.counts" >"$scratch/board"
    "$program" render "$1" $(cat "$steps/$board-$1.txt") --size 320x240 --frames 60:61 \
        --format rgb565 --hash >"$scratch/hash" &&
        paste -d ' ' "$scratch/board" "$scratch/hash" >"$scratch/both" &&
        cat "$scratch/both" && awk '$1 != $NF { off = 1 } END { exit off || NR != 2 }' \
            "$scratch/both"
}
# Cycles of the picture at tick 60: the program draws 60 and no other.
cycles_of()     # SCENE
{
    timeout 300 qemu-system-arm -M mps2-an386 -nographic -monitor none -serial null \
        -chardev file,id=said,path="$scratch/said" \
        -kernel "build/m0plus/charts/$board-$1.elf" -plugin build/host/cycles.so \
        -semihosting-config "enable=on,target=native,chardev=said,arg=320x240 60" \
        2>"$scratch/$1.cycles" </dev/null
}
counted()       # SCENE: prints SCENE, M of a picture and a tick: planned, counted; cycles; dB
{
    tests/charts/board.sh m0 "$board-$1" 320x240 60 '' 61 >"$scratch/$1.counts" &&
        cycles_of "$1" &&
        awk -F'[, ]' -v scene="$1" '
            FILENAME ~ /csv$/ {
                n = split($0, cell, ",")
                for (i = 1; i <= n; i++) if (FNR == 1) column[cell[i]] = i
                frame = cell[column["frame_m"]]; tick = cell[column["tick_m"]]
                db = cell[column["db"]]
            }
            FILENAME ~ /counts$/ { pictures++; ticks += $6; frames += $7 + $8 }
            FILENAME ~ /cycles$/ && $2 != "tick" { instructions += $3; cycles += $4 }
            END { printf "%s %.2f %.2f %.2f %.2f %.3f %s\n", scene, frame,
                      frames / pictures / 1e6, tick, ticks / pictures / 1e6,
                      cycles / instructions, db }' \
            "$scratch/$1.csv" "$scratch/$1.counts" "$scratch/$1.cycles" >>"$scratch/steps"
}
# Table lines: pictures a second without ticks, and with 60 of them, of the counted cycles.
table()
{
    awk -v mhz=133 '{
        speed = mhz / $6
        with = (speed - 60 * $5) / $3
        printf "| `%s` | %s | %s | %s | %s | %.2f | %s | %.1f | %.1f |\n", $1, $2, $3, $4,
            $5, $6, $7, speed / $3, (with > 0 ? with : 0) }' "$scratch/steps"
}
write_table()
{
    table >"$scratch/table"
    awk -v table="$scratch/table" '
        /<!-- board steps/ {
            print
            print "| scene | picture, M: planned | counted | tick, M: planned | counted |" \
                " cycles an instruction | dB | pictures a second | with 60 ticks |"
            print "|---|---|---|---|---|---|---|---|---|"
            while ((getline line <table) > 0) print line
            skip = 1; next
        }
        /<!-- \/board steps/ { skip = 0 }
        !skip' $page >"$scratch/page" && cp "$scratch/page" $page
}
near()          # PERCENT PLANNED COUNTED [FILE]: fields of the steps
{
    awk -v room="$1" -v planned="$2" -v counted="$3" '
        $counted > 0.05 {
            off = 100 * $planned / $counted - 100; all++
            printf "    %s: %.2f M planned, %.2f M counted, %+.1f %%\n", $1, $planned,
                $counted, off
            if (off > room || off < -room) bad = 1
        }
        END { exit bad || !all }' "${4:-$scratch/steps}"
}
as_fast()       # the board's speed is the clock over the counted cycles, within 4 %
{
    "$program" plan count-64 --board $board </dev/null | awk '
        FNR == NR { sum += $6; n++; next }
        / M instructions a second/ {
            sub(/.*MHz, /, ""); off = $1 * sum / n / 133 - 1; print $1, sum / n; found = 1 }
        END { exit !found || off > 0.04 || off < -0.04 }' "$scratch/steps" -
}

if [ "${1:-}" = --write ]; then
    set -- $(basename -s .ini assets/scenes/*.ini)
else
    set -- count-64 three-swells
fi
for scene; do
    check "$scene: the plan finds a step" planned "$scene"
done
[ $failed = 0 ] || exit 1
check "the board's programs build" made "$@"
[ $failed = 0 ] || exit 1
: >"$scratch/steps"
for scene; do
    check "$scene: the step is counted" counted "$scene"
    check "$scene: the counted pictures have the host's bits" same_bits "$scene"
done
if [ $# -gt 2 ]; then
    [ $failed != 0 ] || write_table
    cat "$scratch/steps"
    finish
    exit
fi
check "pictures cost what the plan says, within 20 %" near 20 2 3
sed 's/^/    /' "$scratch/output"
awk '{ $2 *= 0.7; print }' "$scratch/steps" >"$scratch/cheap"
refuse "prices of 0.7 times as much" near 20 2 3 "$scratch/cheap"
check "ticks cost what the plan says, within 15 %" near 15 4 5
sed 's/^/    /' "$scratch/output"
check "the board is as fast as its cycles allow" as_fast
listed()        # the page has these steps as they are counted here
{
    table >"$scratch/table" && grep -q . "$scratch/table" &&
        ! grep -vxF -f $page "$scratch/table"
}
check "the page has the steps as counted" listed
finish
