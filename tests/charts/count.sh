#!/bin/sh
# SPDX-License-Identifier: MIT
# Exact instructions of a chart's kernels for one unit, as rows of the sweep.
#
#   tests/charts/count.sh m4|x86 CHART
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

column=$1 chart=$2
counted "$column" kernels

awk -v column="$column" -v chart="$chart" '
    $1 == "kernel"   { name[++said] = $2 "," $3; of[said] = $2 }
    $1 == "count"    { insns[$2] += $5 }
    END {
        for (i = 1; i <= said; i++)
            if (of[i] == chart && insns[i] > 0) {
                printf "%s,%s,%.2f\n", name[i], column, insns[i] / 1024
                rows++
            }
        if (!rows)
            print "count.sh: nothing was counted of " chart > "/dev/stderr"
        exit !rows
    }' "$scratch/said" "$scratch/counts"
