#!/bin/sh
# SPDX-License-Identifier: MIT
# The table of ports/RUNGS.md: what each rung of effects.txt saves, takes and changes.
# Instructions and RAM are those of scenes.csv; PSNR is measured against the scene's exact
# picture, 320x240, mean of ticks 60 and 300.
#
#   tests/budgets/effects.sh            compares the page with scenes.csv; with TP_SOAK
#                                       PSNR too
#   tests/budgets/effects.sh --write    measures, and writes the table into the page
. "$(dirname "$0")/../lib/script.sh"

page=ports/RUNGS.md
write=
[ "${1:-}" = --write ] && write=1
tool=build/host/tests/accuracy/scene_rungs

# PROGRAM,DB for each program of effects.txt.
measure()
{
    sed -n 's/^\([a-z0-9-]*+[a-z0-9-]*\) .*| \(.*\)/\1 \2/p' tests/budgets/effects.txt |
    while read -r name options; do
        # shellcheck disable=SC2086
        line=$("$tool" "assets/scenes/${name%%+*}.ini" --only "$name" $options </dev/null) ||
            return 1
        echo "$line" | cut -d, -f2,3
    done
}
shown()         # the page's figures of PSNR, as measure prints them
{
    awk -F' *[|] *' 'FNR == NR { if (NF > 5 && $2 ~ /^`/) { gsub(/`/, "", $2); db[$2] = $8 }; next }
        $1 ~ /[+]/ && $2 in db { n = split(db[$2], part, " "); print $1 "," part[n]
            if (n > 1 && $3 ~ /[+]/) print $3 "," part[1] }' $page tests/budgets/effects.txt
}
table()         # DB: the table's lines
{
    awk -F' *[|] *' -v db="$1" '
        function figure(program, name) { return value[program, name] }
        function psnr(program) { return program in shows ? shows[program] : "" }
        FILENAME == "tests/budgets/scenes.csv" {
            split($0, cell, ","); value[cell[1], cell[2]] = cell[3]; next
        }
        FILENAME == db { split($0, cell, ","); shows[cell[1]] = cell[2]; next }
        $1 ~ /[+]/ && $2 != "" {
            scene = $1; sub(/[+].*/, "", scene)
            ram = figure($1, "working-bytes") - figure($3, "working-bytes")
            printf "| `%s` | %s | %.2f | %.2f | %+.1f %% | %s | %s | `%s` |\n", $2, scene,
                figure($3, "instructions") / 1e6, figure($1, "instructions") / 1e6,
                100 * figure($1, "instructions") / figure($3, "instructions") - 100,
                ram == 0 ? "0" : sprintf("%+.1f", ram / 1024),
                psnr($3) == "" ? psnr($1) : psnr($3) " " psnr($1), $4
        }' tests/budgets/scenes.csv "$1" tests/budgets/effects.txt
}

if [ -n "$write$TP_SOAK" ]; then
    check "the measuring program builds" alone build "$tool"
    check "the rungs are drawn" eval 'measure >"$scratch/db"'
else
    shown >"$scratch/db"
fi
[ "$failed" = 0 ] || exit 1
{
    sed '/^<!-- rungs/q' $page
    echo '| rung | scene | M before | M after | change | RAM, KB | dB | code |'
    echo '|---|---|---|---|---|---|---|---|'
    table "$scratch/db"
    sed -n '/^<!-- .rungs/,$p' $page
} >"$scratch/page"
[ -z "$write" ] || cp "$scratch/page" $page
check "ports/RUNGS.md has the figures of scenes.csv" diff $page "$scratch/page"
finish
