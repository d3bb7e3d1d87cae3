#!/bin/sh
# SPDX-License-Identifier: MIT
# The shipped scenes in 128 KB and 264 KB of RAM, and count-64 in 28 KB: a baked program for
# each line of shipped-ram.txt draws two pictures on an emulated Cortex-M4, with exactly the
# bytes that it asks for. RAM, stack and instructions are those of the program; dB is the PSNR
# of its settings against the scene's exact picture (mean of ticks 60 and 300, textures of full
# size).
#
#   tests/budgets/shipped-ram.sh            compares the table of ports/BOARDS.md with every
#                                           fourth line; with TP_SOAK set all
#   tests/budgets/shipped-ram.sh --write    writes the table
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

page=ports/BOARDS.md settings=tests/budgets/shipped-ram.txt
psnr=build/host/tests/accuracy/scene_rungs
write=
[ "${1:-}" != --write ] || write=1

lacks arm-none-eabi-gcc gcc-arm-none-eabi "memory of shipped scenes" && exit 77
lacks qemu-system-arm qemu-system-arm "memory of shipped scenes" && exit 77
check "bake and the measuring programs build" build build/host/tidepool $plugin $psnr
[ "$failed" = 0 ] || exit 1

options()       # NAME
{
    sed -n "s/^$1 *| *//p" $settings
}

# Writes the line of the table to $scratch/NAME.line.
measure()       # NAME
{
    scene=${1%-*}
    # shellcheck disable=SC2046
    build -s BOARD=cortex-m "build/cortex-m/shipped/$1.elf" &&
        emulate "build/cortex-m/shipped/$1.elf" "$scratch/$1.said" "$scratch/$1.counts" &&
        $psnr "assets/scenes/$scene.ini" --only "$1" $(options "$1" |
            grep -o -e '--\(set\|rung\) [^ ]*') \
            >"$scratch/$1.psnr" &&
        awk -v name="$1" -v options="$(options "$1")" -f tests/budgets/shipped-ram.awk \
            "$scratch/$1.psnr" "$scratch/$1.counts" "$scratch/$1.said" >"$scratch/$1.line"
}

set -- $(sed -n '/^#/!s/ *|.*//p' $settings)
[ -n "$write$TP_SOAK" ] || set -- $(printf '%s\n' "$@" | sed -n 'p;n;n;n')
for name; do
    check "$name draws both pictures in its memory, beside the stack" measure "$name"
done
[ "$failed" = 0 ] || exit 1
for name; do
    cat "$scratch/$name.line"
done >"$scratch/table"
cat "$scratch/table"

by="gcc $(arm-none-eabi-gcc -dumpfullversion)"
if [ -n "$write" ]; then
    awk -v table="$scratch/table" -v by="$by" '
        /<!-- shipped RAM/ {
            print "<!-- shipped RAM: tests/budgets/shipped-ram.sh --write, " by " -->"
            print "| scene | KB | options | frame | water | tables | mirror | tile | world " \
                "| in all | stack | M | dB |"
            print "|---|---|---|---|---|---|---|---|---|---|---|---|---|"
            while ((getline line <table) > 0) print line
            skip = 1; next
        }
        /<!-- \/shipped RAM/ { skip = 0 }
        !skip' $page >"$scratch/page" && cp "$scratch/page" $page
fi
if ! grep -q "<!-- shipped RAM.*, $by -->" $page; then
    skip "the table of another compiler, here $by" gcc-arm-none-eabi
    finish
    exit
fi
listed()        # LINES: every line stands in the page
{
    grep -q . "$1" && ! grep -vxF -f $page "$1"
}
check "the page has the memory of each scene" listed "$scratch/table"
sed 's/\([0-9]\) | \([0-9.-]* |\)$/\19 | \2/' "$scratch/table" >"$scratch/other"
refuse "a line with another figure is found" listed "$scratch/other"
finish
