#!/bin/sh
# SPDX-License-Identifier: MIT
# The steps of the shipped scenes that an stm32f405 draws at 10 pictures a second, or their
# cheapest within 16 levels: the table of ports/BOARDS.md, and the page of pictures in
# assets/gallery/boards. Instructions are the plan's estimates; PSNR is measured by
# `tidepool plan --board`.
#
#   tests/budgets/board-rungs.sh            compares both with the program, every third
#                                           scene; with TP_SOAK set all
#   tests/budgets/board-rungs.sh --write    draws the pictures and writes both
. "$(dirname "$0")/../lib/script.sh"

page=ports/BOARDS.md shipped=assets/gallery/boards
program=${TP_PROGRAM:-build/host/tidepool}
write= drawn=$scratch/boards
[ "${1:-}" != --write ] || write=1 drawn=$shipped

set -- $(basename -s .ini assets/scenes/*.ini)
[ -n "$write$TP_SOAK" ] || set -- $(printf '%s\n' "$@" | sed -n 'p;n;n')
check "the pictures are drawn" ports/board_steps.sh "$program" "$drawn" "$@"
[ "$failed" = 0 ] || exit 1
# Lines of the table.
awk -F, 'NR > 1 { printf "| `%s` | %s | %s | %d | %d | %s | %s |\n", $1, $9, $10,
                      $11 / 1024, $12 / 1024, $14, $7 }' "$drawn/steps.csv" >"$scratch/table"
if [ -n "$write" ]; then
    awk -v table="$scratch/table" '
        /<!-- board rungs/ {
            print
            print "| scene | picture, M | tick, M | RAM, KB | flash, KB | dB | real time |"
            print "|---|---|---|---|---|---|---|"
            while ((getline line <table) > 0) print line
            skip = 1; next
        }
        /<!-- \/board rungs/ { skip = 0 }
        !skip' $page >"$scratch/page" && cp "$scratch/page" $page
fi
listed()        # LINES FILE: every line of the first stands in the second
{
    grep -q . "$1" && ! grep -vxF -f "$2" "$1"
}
check "the page has the board's steps as the plan finds them" listed "$scratch/table" $page
check "so has the table of the pictures" listed "$drawn/steps.csv" $shipped/steps.csv

# -- pictures ---------------------------------------------------------------------------

shown()         # SCENE: its pictures are those that the program draws
{
    cmp "$drawn/$1-exact.png" "$shipped/$1-exact.png" &&
        cmp "$drawn/$1-board.png" "$shipped/$1-board.png"
}
for scene; do
    check "$scene is shown as it is drawn" shown "$scene"
done
paged()         # TABLE: the shipped page is that of the table
{
    mkdir -p "$scratch/paged"
    cp "$1" "$scratch/paged/steps.csv"
    ports/board_steps.sh --page "$scratch/paged" &&
        cmp "$scratch/paged/README.md" $shipped/README.md
}
check "the page of pictures is made of its table" paged $shipped/steps.csv
sed 's/,[1-9]/&1/' $shipped/steps.csv >"$scratch/other"
refuse "a page of another table is found" paged "$scratch/other"
finish
