#!/bin/sh
# SPDX-License-Identifier: MIT
# Speeds and sizes of boards in the pages come from rows of configurations.csv: the tables
# between a page's comment lines "<!-- rows: TABLE -->" and "<!-- /rows -->" are those of
# pages.awk, and no other line has a figure, unless figures.txt allows it.
#
#   tests/boards/figures.sh                 checks the pages
#   tests/boards/figures.sh --write         writes the tables into the pages
. "$(dirname "$0")/../lib/script.sh"

pages="README.md ports/BOARDS.md ports/pico/README.md"
facts=tests/boards/boards.csv rows=tests/boards/configurations.csv

page()          # PAGE ROWS: the page with its tables made anew
{
    awk -v facts=$facts -v rows="$2" '
        /^<!-- rows: [a-z]* -->$/ {
            print
            command = "awk -v table=" $3 " -f tests/boards/pages.awk " facts " " rows
            while ((command | getline line) > 0) print line
            close(command)
            within = 1
        }
        /^<!-- \/rows -->$/ { within = 0 }
        !within' "$1"
}
if [ "${1:-}" = --write ]; then
    for page in $pages; do
        page "$page" $rows >"$scratch/page" && cp "$scratch/page" "$page" || exit 1
    done
    exit
fi

same_tables()   # ROWS: the pages' tables are those of these rows
{
    for page in $pages; do
        grep -q '^<!-- rows:' "$page" && page "$page" "$1" | diff "$page" - || return 1
    done
}
check "the pages' tables are those of the measured rows" same_tables $rows
sed 's/,\([0-9]*\)$/,\19/' $rows >"$scratch/other"
refuse "tables of other rows are found" same_tables "$scratch/other"

listed="README.md ports/*.md ports/*/README.md ports/*/*/README.md include/tidepool/README.md
    ports/boards.mk ports/*/board.mk ports/*/*/board.mk"
# Lines PAGE:TEXT with a size or speed, not within a generated table.
figures()
{
    # shellcheck disable=SC2086
    awk '
        FNR == 1 || /^<!-- \// { within = 0 }
        /^<!-- [A-Za-z ]*:/ { within = 1 }
        !within && $0 ~ "[0-9] ?(KB|MB|kB|bytes|ms|MHz|fps|frames/s|M instructions|million)" \
            "|[0-9] (cycles|instructions|pictures a second)" {
            print FILENAME ":" $0
        }' "$@"
}
allowed()       # PATTERNS FILE...: all of them are allowed, and every pattern is of use
{
    grep -v '^#' "$1" >"$scratch/patterns"
    shift
    figures "$@" >"$scratch/figures"
    [ -s "$scratch/figures" ] && ! grep -vE -f "$scratch/patterns" "$scratch/figures" || return 1
    while read -r pattern; do
        grep -qE -e "$pattern" "$scratch/figures" || { echo "unused: $pattern"; return 1; }
    done <"$scratch/patterns"
}
# shellcheck disable=SC2086
check "no other line of a page has a speed or a size" allowed tests/boards/figures.txt $listed
echo 'count-64 takes 51 KB of code on a Cortex-M4.' >"$scratch/page.md"
# shellcheck disable=SC2086
refuse "a line with a size is found" allowed tests/boards/figures.txt $listed "$scratch/page.md"
finish
