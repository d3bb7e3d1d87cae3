#!/bin/sh
# SPDX-License-Identifier: MIT
# The code and constants that each piece of a program list adds to a program for a
# Cortex-M4, by which `tidepool plan` estimates flash: code-sizes.csv, and the same as C in
# ports/tools/bake/code_sizes.inc. Each piece is linked alone: a section belongs to all
# pieces that reach it, and a program links it if it has one of them.
#
#   tests/budgets/code-sizes.sh             compares two baked programs with the estimate;
#                                           with TP_SOAK set every program of scenes-count.sh
#   tests/budgets/code-sizes.sh --write     links all pieces and writes both files
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/flash.sh"

sizes=$flash_sizes table=ports/tools/bake/code_sizes.inc
program=${TP_PROGRAM:-build/host/tidepool}

# -- the files ------------------------------------------------------------------------

# Lines FILE(MEMBER) SECTION BYTES PIECE of all that a piece reaches; "base": what every
# program calls.
reached()
{
    { echo base; pieces; } | while read -r piece; do
        if [ "$piece" = base ]; then
            flash_link "$scratch/piece" || return 1
        else
            flash_link_alone "$piece" "$scratch/piece" || return 1
        fi
        awk -v each=1 -v files="$flash_files" -f tests/budgets/map.awk \
            "$scratch/piece.map" | awk -v piece="$piece" '{ print $3, $1, $2, piece }'
    done
}
# One line for all sections of the same pieces.
grouped()
{
    echo "# compiler m4 arm-none-eabi-gcc $(arm-none-eabi-gcc -dumpfullversion)"
    echo bytes,pieces
    awk '{
            section = $1 " " $2
            if ($3 > size[section]) size[section] = $3
            by[section] = by[section] (section in by && by[section] != "" ? " " : "") $4
        }
        END {
            for (section in by)
                bytes[by[section] ~ /^base/ ? "base" : by[section]] += size[section]
            for (pieces in bytes) print bytes[pieces] "," pieces | "LC_ALL=C sort -t, -k2"
        }' "$1"
}
as_c()          # CSV
{
    echo "/* SPDX-License-Identifier: MIT */"
    echo "/* Made of $sizes by tests/budgets/code-sizes.sh --write. */"
    awk -F, '/^[0-9]/ {
        line = "{ " $1 ","
        n = split($2, piece, " ")
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
    flash_build || exit 77
    reached >"$scratch/reached" && grouped "$scratch/reached" >"$scratch/csv" &&
        cp "$scratch/csv" $sizes && as_c $sizes >"$scratch/inc" && cp "$scratch/inc" $table
    exit
fi

# -- programs -------------------------------------------------------------------------

flash_ready || { finish; exit; }

made()          # CSV: the shipped table of C is made of it
{
    as_c "$1" >"$scratch/inc" && cmp "$scratch/inc" $table
}
check "the table of C is that of $sizes" made $sizes
sed '3s/^[0-9]*/&0/' $sizes >"$scratch/other"
refuse "a table of other sizes is found" made "$scratch/other"

sized()         # CSV: all pieces that a list can name stand in it
{
    sed -n 's/^[0-9]*,//p' "$1" | tr ' ' '\n' | sort -u >"$scratch/sized"
    pieces >"$scratch/pieces"
    [ -s "$scratch/pieces" ] && ! comm -13 "$scratch/sized" "$scratch/pieces" | grep .
}
check "all pieces have sizes" sized $sizes
grep -v tp_stage_sky $sizes >"$scratch/other"
refuse "a table that lacks one is found" sized "$scratch/other"

# estimated BAKED.c CSV: bytes of code and constants by the table
estimated()
{
    grep -o 'tp_[a-z0-9_]*' "$1" | sort -u | awk -F, '
        FILENAME == "-" { has[$1]; next }
        /^[0-9]/ {
            n = split($2, piece, " ")
            for (i = 1; i <= n && !(piece[i] in has || piece[i] == "base"); i++);
            if (i <= n) sum += $1
        }
        END { print sum }' - "$2"
}
# Code and constants of the program that was linked last, without its scene.
code_linked()
{
    awk -v files="$flash_files" -f tests/budgets/map.awk "$scratch/program.map" |
        awk '{ print $1 + $2 }'
}
near()          # CSV: its sum is the code of the program linked last
{
    flash_near "$(estimated "$scratch/baked.c" "$1")" "$(code_linked)"
}

awk -F, -v OFS=, '/^[0-9]/ { $1 = int($1 * 1.01) } { print }' $sizes >"$scratch/other"
one()           # SCENE [OPTION]...: its code is estimated
{
    check "a program links: $*" flash_of_baked "$@" >/dev/null
    check "its code is that of the table: $*" near $sizes
    refuse "a table of 1 % more code is found" near "$scratch/other"
    [ -z "$TP_SOAK" ] || echo "  $* $(estimated "$scratch/baked.c" $sizes) $(code_linked)"
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
