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

sizes=tests/budgets/code-sizes.csv table=ports/tools/bake/code_sizes.inc
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
    echo bytes,pieces
    awk '{
            section = $1 " " $2
            if ($3 > size[section]) size[section] = $3
            by[section] = by[section] (section in by && by[section] != "" ? " " : "") $4
        }
        END {
            for (section in by)
                bytes[by[section] ~ /^base/ ? "base" : by[section]] += size[section]
            for (pieces in bytes) print bytes[pieces] "," pieces
        }' "$1" | LC_ALL=C sort -t, -k2
}
as_c()          # CSV
{
    echo "/* SPDX-License-Identifier: MIT */"
    echo "/* Made of $sizes by tests/budgets/code-sizes.sh --write. */"
    awk -F, 'NR > 1 {
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
    flash_ready || exit 77
    reached >"$scratch/reached" && grouped "$scratch/reached" >"$scratch/csv" &&
        cp "$scratch/csv" $sizes && as_c $sizes >"$scratch/inc" && cp "$scratch/inc" $table
    exit
fi

# -- programs -------------------------------------------------------------------------

estimated()     # BAKED.c: bytes of code and constants by the table
{
    grep -o 'tp_[a-z0-9_]*' "$1" | sort -u | awk -F, '
        FILENAME == "-" { has[$1]; next }
        FNR > 1 {
            n = split($2, piece, " ")
            for (i = 1; i <= n && !(piece[i] in has || piece[i] == "base"); i++);
            if (i <= n) sum += $1
        }
        END { print sum }' - $sizes
}
linked()        # BAKED.o: those of the linked program
{
    flash_link "$scratch/program" "$1" && awk -v files="$flash_files" \
        -f tests/budgets/map.awk "$scratch/program.map" | awk '{ print $1 + $2 }'
}
