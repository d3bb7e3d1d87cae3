#!/bin/sh
# SPDX-License-Identifier: MIT
# The tables by which `tidepool plan` and `bake` state the memory of a program for a
# Cortex-M4, in ports/tools/bake:
#  - code_sizes.inc, made of code-sizes.csv: code and constants of each piece of a program
#    list. Each piece is linked alone: a section belongs to all pieces that reach it, and a
#    program links it if it has one of them.
#  - stack_sizes.inc: the deepest chains of calls, with the pieces that each needs
#  - layout_sizes.inc: bytes by which the parts of a frame are smaller than on this machine
#
#   tests/budgets/code-sizes.sh             compares two baked programs with the estimate;
#                                           with TP_SOAK set every program of scenes-count.sh
#   tests/budgets/code-sizes.sh --write     links all pieces and writes all files
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"
. "$(dirname "$0")/../lib/flash.sh"

sizes=$flash_sizes tables=ports/tools/bake
program=${TP_PROGRAM:-build/host/tidepool}

# -- the tables -----------------------------------------------------------------------

# Lines FILE(MEMBER) SECTION BYTES PIECE of all that a piece reaches; "base": what every
# program calls.
reached()
{
    { echo base; pieces; } | while read -r piece; do
        if [ "$piece" = base ]; then
            flash_link "$scratch/piece" || return 1
        else
            flash_link_alone "$piece" "$scratch/piece" --defsym tp_program_linked=0 || return 1
        fi
        awk -v each=1 -v files="$flash_files" -f tests/budgets/map.awk \
            "$scratch/piece.map" | awk -v piece="$piece" '{ print $3, $1, $2, piece }'
    done
}
# One line for all sections of the same pieces.
grouped()
{
    echo "# compiler m4 arm-none-eabi-gcc $(arm-none-eabi-gcc -dumpfullversion)"
    echo code,constants,pieces
    awk '{
            section = $1 " " $2
            if ($3 > size[section]) size[section] = $3
            by[section] = by[section] (section in by && by[section] != "" ? " " : "") $4
        }
        END {
            for (section in by) {
                pieces = by[section] ~ /^base/ ? "base" : by[section]
                all[pieces]
                if (section ~ / [.]text/) code[pieces] += size[section]
                else constants[pieces] += size[section]
            }
            for (pieces in all)
                print code[pieces] + 0 "," constants[pieces] + 0 "," pieces | \
                    "LC_ALL=C sort -t, -k3"
        }' "$1"
}
# The deepest chains of calls, BYTES,GROUP&GROUP...: that of every program first.
stacked()       # REACHED
{
    find build/cortex-m4/src -name '*.ci' -exec awk -v pointers=tests/gates/pointers.txt \
        -f tests/lib/callgraph.awk -f tests/budgets/stack.awk "$1" {} + | LC_ALL=C sort -t, -k2
}
# Bytes by which the parts of a frame are smaller on a board: PART,BYTES, the most of all
# layouts, which differ by 8 at most.
layouts()
{
    build build/host/tests/budgets/layout && build BOARD=cortex-m build/cortex-m/layout.elf &&
        build/host/tests/budgets/layout >"$scratch/here" &&
        emulate build/cortex-m/layout.elf "$scratch/board" /dev/null &&
        [ "$(sed 's/ [0-9]*$//' "$scratch/here")" = "$(sed 's/ [0-9]*$//' "$scratch/board")" ] &&
        paste -d ' ' "$scratch/here" "$scratch/board" | awk '{
            less = $(NF / 2) - $NF
            part = $1
            for (i = 2; i < NF / 2; i++) part = part "_" $i
            if (part !~ /^(frame|lists?|material|(table|tp)_.*)$/) part = "tp_" part "_drawing"
            if (!(part in most) || less > most[part]) most[part] = less
            if (!(part in least) || less < least[part]) least[part] = less
        }
        END {
            for (part in most) {
                if (most[part] - least[part] > 8) { print part ": many sizes"; bad = 1 }
                if (most[part]) print part "," most[part] | "LC_ALL=C sort"
            }
            exit bad
        }'
}
# Lines of a table of C: numbers, then words of a text; or a word, then a number.
as_c()          # CSV
{
    echo "/* SPDX-License-Identifier: MIT */"
    echo "/* Made by tests/budgets/code-sizes.sh --write. */"
    awk -F, '/^[0-9a-z].*[0-9]/ && !/^code/ {
        if ($1 !~ /^[0-9]+$/) { print "{ \"" $1 "\", " $2 " },"; next }
        line = "{ "
        for (i = 1; i < NF; i++) line = line $i (i < NF - 1 ? ", " : ",")
        n = split($NF, piece, " ")
        if (n == 0) { print line " \"\" },"; next }
        for (i = 1; i <= n; i++) {
            word = (i > 1 ? " " : "") piece[i]
            if (i == 1 || length(line word) > 86) {
                print line (i > 1 ? "\"" : "")
                line = "    \"" word
            } else
                line = line word
        }
        print line "\" },"
    }' "$1"
}

if [ "${1:-}" = --write ]; then
    flash_build && ! lacks qemu-system-arm qemu-system-arm "layouts on a board" || exit 77
    reached >"$scratch/reached" && grouped "$scratch/reached" >"$scratch/code" &&
        stacked "$scratch/reached" >"$scratch/stack" && layouts >"$scratch/layout" ||
        { cat "$scratch/layout"; exit 1; }
    cp "$scratch/code" $sizes
    for table in code stack layout; do
        as_c "$scratch/$table" >$tables/${table}_sizes.inc
    done
    exit
fi

# -- programs -------------------------------------------------------------------------

flash_ready || { finish; exit; }

made()          # CSV: the shipped table of C is made of it
{
    as_c "$1" >"$scratch/inc" && cmp "$scratch/inc" $tables/code_sizes.inc
}
check "the table of C is that of $sizes" made $sizes
sed '3s/^[0-9]*/&0/' $sizes >"$scratch/other"
refuse "a table of other sizes is found" made "$scratch/other"

sized()         # CSV: all pieces that a list can name stand in it
{
    sed -n 's/^[0-9]*,[0-9]*,//p' "$1" | tr ' ' '\n' | sort -u >"$scratch/sized"
    pieces >"$scratch/pieces"
    [ -s "$scratch/pieces" ] && ! comm -13 "$scratch/sized" "$scratch/pieces" | grep .
}
check "all pieces have sizes" sized $sizes
grep -v tp_stage_sky $sizes >"$scratch/other"
refuse "a table that lacks one is found" sized "$scratch/other"

laid_out()      # TABLE: its parts are smaller on a board by these bytes
{
    layouts >"$scratch/layout" && as_c "$scratch/layout" | diff - "$1"
}
if ! lacks qemu-system-arm qemu-system-arm "layouts on a board"; then
    check "frames are smaller on a board by the table's bytes" \
        laid_out $tables/layout_sizes.inc
    sed '3s/[0-9] }/0 }/;4s/[0-9] }/1 }/' $tables/layout_sizes.inc >"$scratch/other"
    refuse "a table with other bytes is found" laid_out "$scratch/other"
fi

# What the program linked last takes: code and constants without its scene, and the deepest
# chain of calls in it.
linked()
{
    flash_linked "$scratch/program.map" "$scratch/baked.o"
    awk -v each=1 -v files="$flash_files" -f tests/budgets/map.awk "$scratch/program.map" |
        awk '{ print $3, $1, $2, "base" }' >"$scratch/linked"
    stacked "$scratch/linked" | sed 's/\(.*\),/stack \1/'
}
as_linked()     # [FACTOR]: code, constants and stack of the head are those of the program
{
    memory_of "$scratch/baked.c" | awk -v by="${1:-1}" '
        $1 ~ /^(code|constants|stack)$/ { print $1, int($2 * by) }' | sort >"$scratch/head"
    linked | sort | diff "$scratch/head" -
}

one()           # SCENE [OPTION]...: its code is estimated
{
    check "a program links: $*" flash_of_baked "$@" >/dev/null
    check "its head has its code, constants and stack: $*" as_linked
    refuse "1 % more is found" as_linked 1.01
}
if [ -n "$TP_SOAK" ]; then
    grep -v '^#\|^plain' tests/budgets/cheapest.txt >"$scratch/all"
    sed -n 's/^\([a-z0-9-]*\)+.*| /\1 /p' tests/budgets/effects.txt >>"$scratch/all"
    while read -r line; do
        # shellcheck disable=SC2086
        one $line
    done <"$scratch/all"
else
    one pond --rung fast --set quality.dispersion=off
    one calm-bay --step 4
fi
finish
