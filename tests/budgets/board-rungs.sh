#!/bin/sh
# SPDX-License-Identifier: MIT
# The table of ports/BOARDS.md: the step of each shipped scene that an stm32f405 draws at 10
# pictures a second, or its cheapest that keeps 28 dB. Instructions are the plan's estimates;
# PSNR is measured by `tidepool plan --board`.
#
#   tests/budgets/board-rungs.sh            compares the page with the program, every third
#                                           scene; with TP_SOAK set all
#   tests/budgets/board-rungs.sh --write    writes the table into the page
. "$(dirname "$0")/../lib/script.sh"

page=ports/BOARDS.md board=stm32f405 fps=10
program=${TP_PROGRAM:-build/host/tidepool}
write=
[ "${1:-}" != --write ] || write=1

set -- $(basename -s .ini assets/scenes/*.ini)
[ -n "$write$TP_SOAK" ] || set -- $(printf '%s\n' "$@" | sed -n 'p;n;n')
table()         # SCENE...: lines of the table
{
    for scene; do
        "$program" plan "$scene" --board $board --fps $fps --csv </dev/null \
            >"$scratch/csv" || return 1
        awk -F, -v scene="$scene" '
            NR == 2 { printf "| `%s` | %s | %s | %d | %s | %s |\n", scene, $5, $6,
                          $7 / 1024, $9, $3 }' "$scratch/csv"
    done
}
table "$@" >"$scratch/table"
if [ -n "$write" ]; then
    awk -v table="$scratch/table" '
        /<!-- board rungs/ {
            print
            print "| scene | picture, M | tick, M | RAM, KB | dB | real time |"
            print "|---|---|---|---|---|---|"
            while ((getline line <table) > 0) print line
            skip = 1; next
        }
        /<!-- \/board rungs/ { skip = 0 }
        !skip' $page >"$scratch/page" && cp "$scratch/page" $page
fi
listed()        # every line of the table stands on the page
{
    grep -q . "$scratch/table" && ! grep -vxF -f $page "$scratch/table"
}
check "the page has the board's steps as the plan finds them" listed
finish
