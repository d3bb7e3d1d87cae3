#!/bin/sh
# SPDX-License-Identifier: MIT
# Compares the plan's estimate of a frame's cost with the counted cost: within 10 % for
# each shipped scene; and its estimate of a tick's cost: within 15 % for scenes whose ticks
# are pools and foam. The counts are those of scenes.csv, which scenes-count.sh checks;
# nothing is drawn here.
#
#   tests/budgets/plan-count.sh             the test
#   tests/budgets/plan-count.sh --rows      rows of the chart `plan`
. "$(dirname "$0")/../lib/script.sh"

rows=
case ${1:-} in --rows) rows=1 ;; esac
program=${TP_PROGRAM:-build/host/tidepool}

# Prints the plan's row of costs and the counted cost of each scene:
# scene predicted counted error
compare()       # ROW FIGURE SCENE...: a row without stage of `plan`, a figure of scenes.csv
{
    row=$1 figure=$2
    shift 2
    for name; do
        counted=$(awk -F, -v s="$name" -v figure="$figure" \
            '$1 == s && $2 == figure { print $3 }' tests/budgets/scenes.csv)
        "$program" plan "$name" --size 320x240 --csv |
            awk -F, -v s="$name" -v row="$row" -v counted="$counted" \
                '$1 == row && $2 == "" { print s, $4, counted, $5 }'
    done
}

both()          # frames of all scenes
{
    for scene in assets/scenes/*.ini; do
        scene=${scene##*/}
        compare total instructions "${scene%.ini}"
    done
}

if [ -n "$rows" ]; then
    both | awk '{ print "plan," $1 ",predicted," $2
                  print "plan," $1 ",counted," $3
                  print "plan," $1 ",error," $4 }'
    exit
fi

near()          # FILE PERCENT SCENES
{
    awk -v room="$2" -v least="$3" '
        { off = 100 * $2 / $3 - 100; scenes++
          printf "    %-14s %8.2f M predicted %8.2f M counted %+6.1f %%\n", $1, $2 / 1e6,
              $3 / 1e6, off
          if (off > room || off < -room) bad = 1 }
        END { exit bad || scenes < least }' "$1"
}

both >"$scratch/both"
check "every scene costs what the plan says, within 10 %" near "$scratch/both" 10 10
awk '{ $2 *= 1.25; print }' "$scratch/both" >"$scratch/dear"
refuse "prices that are a quarter dearer" near "$scratch/dear" 10 10
compare tick tick harbour pond tank deep-sea night-sea three-swells from-above \
    >"$scratch/ticks"
check "a tick costs what the plan says, within 15 %" near "$scratch/ticks" 15 7
awk '{ $2 *= 1.35; print }' "$scratch/ticks" >"$scratch/dear"
refuse "ticks that are a third dearer" near "$scratch/dear" 15 7
finish
