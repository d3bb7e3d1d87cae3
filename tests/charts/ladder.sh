#!/bin/sh
# SPDX-License-Identifier: MIT
# The ladder of a shipped scene as rows of the charts `ladder` and `boards` (ladder.c), and
# of `ladder` the cheapest rungs of tests/budgets/cheapest.txt: their instructions are
# counted (tests/budgets/scenes.csv), their error is that of tests/accuracy/rungs.csv.
#
#   tests/charts/ladder.sh SCENE
[ $# = 1 ] || { echo "usage: ladder.sh SCENE" >&2; exit 2; }
build/host/tests/charts/ladder "$1" || exit 1
awk -F, -v scene="$1" '
    BEGIN { row = "ladder," scene ";cheapest," }
    $1 == scene "+cheap" && $2 == "instructions" { print row "m4," $3 }
    $1 == scene && $2 == "cheap"                 { print row "db," $3 }
    ' tests/budgets/scenes.csv tests/accuracy/rungs.csv
