#!/bin/sh
# SPDX-License-Identifier: MIT
# Costs of a tick as rows of the sweep: the parts of each scene's tick in a fixed order, and
# the rest.
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
            row(s, "rest", at, all[s] - at)
        }
    }
    function row(s, what, at, cost) {
        print "ticks," s ";" what ",m4," cost
        print "ticks," s ";" what ",from," at
        print "ticks," s ";" what ",to," at + cost
        return at + cost
    }' "$(dirname "$0")/../budgets/scenes.csv"
