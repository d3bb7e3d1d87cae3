#!/bin/sh
# SPDX-License-Identifier: MIT
# Plain water as rows of the chart `boards`: pictures a second of each board by Tidepool,
# whose instructions are counted (tests/budgets/scenes.csv), and by the peers of peers.csv,
# whose instructions a pixel are multiplied by the same pixels of water.  A board's
# instructions a second are those of `tidepool plan --board`.  The counts are those of a
# Cortex-M4: boards with a Cortex-M0 have no such rows.
. "$(dirname "$0")/../lib/script.sh"

build/host/tests/charts/ladder boards >"$scratch/boards" || exit 1
grep -v '^#' "$(dirname "$0")/peers.csv" | tail -n +2 >"$scratch/peers"
awk -F '[ ,]' '
    function row(who, board, cost) {
        printf "boards,%s;%s,pictures,%.2f\n", who, board, speed[board] / cost
        printf "boards,%s;%s,cost,%.0f\n", who, board, cost
        print "boards," who ";" board ",fits,-"
    }
    FILENAME ~ /boards$/ {
        if ($3 !~ /M0/) { name[++boards] = $1; speed[$1] = $2 }
        next
    }
    FILENAME ~ /scenes.csv$/ {
        if ($1 ~ /^plain-64/ && $2 == "instructions") cost[$1] = $3
        if ($1 == "plain-64" && $2 == "pixel") pixel = $3
        next
    }
    FNR == 1 {
        water = cost["plain-64"] / pixel
        for (b = 1; b <= boards; b++)
            for (who in cost) row(who, name[b], cost[who])
    }
    {
        for (b = 1; b <= boards; b++)
            row($1, name[b], water * $3)
    }' "$scratch/boards" tests/budgets/scenes.csv "$scratch/peers"
