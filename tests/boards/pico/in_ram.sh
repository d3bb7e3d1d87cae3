#!/bin/sh
# SPDX-License-Identifier: MIT
# Measures which functions of the core ports/pico runs in RAM: those that take a thousandth
# or more of the instructions of a scene's picture and tick, with code for a Cortex-M0+ or a
# Cortex-M4: of the shipped scenes, exact or at their cheapest rungs, and of those of
# ports/cortex-m/scenes.
#
#   tests/boards/pico/in_ram.sh [SCENE...]      prints a table of scenes and functions
#   tests/boards/pico/in_ram.sh --write         writes it: ports/pico/in_ram.txt
. "$(dirname "$0")/../../lib/script.sh"
. "$(dirname "$0")/../../lib/board.sh"

table=ports/pico/in_ram.txt
write=
[ "${1:-}" != --write ] || { write=1; shift; }
[ $# -gt 0 ] || set -- $(for scene in $(build -s list-scenes); do
    echo "$scene" "$(sed -n "s/^$scene .*/$scene+cheap/p" tests/budgets/cheapest.txt)"
done) $(basename -s .ini ports/cortex-m/scenes/*.ini)
bake=$(build -s BOARD=pico list-bake)

baked=
measure()       # BOARD SCENE...
{
    board=$1 target=in_ram_${1##*/}
    shift
    if [ "$baked" ]; then               # baked for the other processor already
        alone build -s BOARD="$board" TARGET="$target" BAKE="$bake" "build/$target/bake" &&
            mkdir -p "build/$target/baked" && cp "$baked"/*.c "build/$target/baked" ||
            return 1
    fi
    alone build -s BOARD="$board" TARGET="$target" BAKE="$bake" SCENES="$*" elves >&2 ||
        return 1
    baked=build/$target/baked
    for scene; do
        elf=build/$target/scenes/$scene.elf
        emulate "$elf" "$scratch/said" "$scratch/counts" || return 1
        arm-none-eabi-nm -t d -n --defined-only "$elf" >"$scratch/symbols"
        awk -v scene="$scene" -f tests/lib/symbol_at.awk -f tests/boards/pico/in_ram.awk \
            "$scratch/symbols" "$scratch/counts" >>"$scratch/functions" || return 1
    done
}
build -s $plugin && measure cortex-m/m0plus "$@" && measure cortex-m "$@" || exit 1
awk -v scenes="$*" '
    BEGIN {
        print "# Functions that run in RAM: measured by tests/boards/pico/in_ram.sh --write"
        print "# x: the function takes a thousandth of this scene\047s instructions."
        n = split(scenes, scene, " ")
        for (i = 1; i <= n; i++)
            printf "%s%s%s", i % 4 == 1 ? "scenes " : " ", scene[i],
                i % 4 == 0 || i == n ? "\n" : ""
    }
    { takes[$2, $1] = 1; all[$2] = 1 }
    END {
        for (name in all) {
            row = ""
            for (i = 1; i <= n; i++)
                row = row (takes[name, scene[i]] ? "x" : ".")
            print row, name | "sort -k 2"
        }
    }' "$scratch/functions" >"$scratch/table"
if [ "$write" ]; then cp "$scratch/table" $table; else cat "$scratch/table"; fi
