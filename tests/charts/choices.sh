#!/bin/sh
# SPDX-License-Identifier: MIT
# The table that opens the charts' page: what a reader may want, what to take, and the
# figure behind it, from the tables of the charts and of the budgets.
#
#   tests/charts/choices.sh             compares page.md and the page with the tables
#   tests/charts/choices.sh --write     writes the table into both
. "$(dirname "$0")/../lib/script.sh"

template=tests/charts/page.md page=assets/charts/README.md
charts=assets/charts

awk -v frames="$(cat tests/golden/*/*.crc | grep -c crc32)" \
    -v machines="$(sed -n '/^machines=/,/^"/p' tests/cross/run.sh | grep -c '|')" \
    -f tests/charts/choices.awk $charts/ladder.csv $charts/boards.csv $charts/ticks.csv \
    $charts/regret.csv $charts/predicted.csv $charts/stability-rest.csv \
    tests/budgets/scenes.csv tests/budgets/minimal.csv ports/BOARDS.md >"$scratch/table" ||
    exit 1

if [ "${1:-}" = --write ]; then
    for file in $template $page; do
        awk -v table="$scratch/table" '
            /<!-- choices/ {
                print
                while ((getline line <table) > 0) print line
                skip = 1
            }
            /<!-- \/choices/ { skip = 0 }
            !skip' $file >"$scratch/page" && cp "$scratch/page" $file
    done
    exit
fi
table_of()      # PAGE: its table, without the markers
{
    sed -n '/<!-- choices/,/<!-- \/choices/p' "$1" | sed '1d;$d'
}
held()          # PAGE
{
    table_of "$1" >"$scratch/shown" && [ -s "$scratch/shown" ] &&
        diff "$scratch/table" "$scratch/shown"
}
check "the charts' page opens with the measured figures" held $page
check "so does its template" held $template
sed '/stm32f405/s/[0-9]/&1/' $page >"$scratch/stale"
refuse "another figure is found" held "$scratch/stale"
finish
