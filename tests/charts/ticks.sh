#!/bin/sh
# SPDX-License-Identifier: MIT
# Costs of a tick as rows of the sweep:
#
#   tests/charts/ticks.sh                   counted: the parts of each scene's tick in a
#                                           fixed order, and the rest; `all` is their sum
#   tests/charts/ticks.sh predicted SCENE   the plan's estimates: as shipped, at the
#                                           cheapest rungs, and at all world rungs
. "$(dirname "$0")/../lib/script.sh"

program=${TP_PROGRAM:-build/host/tidepool}
budgets=tests/budgets

# A world without pools and foam has no line `tick`: its estimate is 0.
planned()       # NAME COLUMN OPTION...: the plan's estimate of a tick, of the whole or, for
{               # COLUMN `world`, at all world rungs
    name=$1 column=$2
    shift 2
    "$program" plan "$@" --csv >"$scratch/plan" || exit 1
    awk -F, -v name="$name" -v column="$column" '
        $1 == "tick" && ($2 != "") == (column == "world") { tick = $4 }
        END {
            if (column != "world" || tick)
                print "ticks," name ";all,predicted," tick + 0
        }
        ' "$scratch/plan"
}
if [ "${1:-}" = predicted ]; then
    planned "$2" all "$2"
    planned "$2+world" world "$2"
    # shellcheck disable=SC2046
    planned "$2+cheap" all "$2" $(sed -n "s/^$2 //p" "$budgets/cheapest.txt")
    exit
fi
awk -F, '
    $1 ~ /[+]/ && $1 !~ /[+]cheap$/ { next }     # a rung of a scene: the same world
    $2 == "tick" { scene[++scenes] = $1; all[$1] = $3 }
    $2 ~ /^tick\./ { part[$1, substr($2, 6)] = $3 }
    END {
        parts = split("foam pool waves boat spray world helpers", name, " ")
        for (i = 1; i <= scenes; i++) {
            s = scene[i]
            at = 0
            for (k = 1; k <= parts; k++)
                if ((s, name[k]) in part)
                    at = row(s, name[k], at, part[s, name[k]])
            print "ticks," s ";all,m4," all[s]
            row(s, "rest", at, all[s] - at)
        }
    }
    function row(s, what, at, cost) {
        print "ticks," s ";" what ",m4," cost
        print "ticks," s ";" what ",from," at
        print "ticks," s ";" what ",to," at + cost
        return at + cost
    }' "$budgets/scenes.csv"
