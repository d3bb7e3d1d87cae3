#!/bin/sh
# SPDX-License-Identifier: MIT
# Exact instructions per cell of the pools' steps, as rows of the sweep.
#
#   tests/charts/pool-count.sh m4|x86
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

column=$1
counted "$column" pool_count

awk -v column="$column" '
    $1 == "pool"   { keys[++said] = $2; edges[said] = $3; cells[said] = $4 }
    $1 == "count"  { insns[$2] += $5 }
    END {
        for (i = 1; i <= said; i++)
            if (insns[i] > 0) {
                printf "pool,%s,%s%s,%.2f\n", keys[i], column, \
                    edges[i] == "sponge" ? "_sponge" : "", insns[i] / cells[i]
                rows++
            }
        if (rows != said || !said)
            print "pool-count.sh: a pool was not counted" > "/dev/stderr"
        exit rows != said || !said
    }' "$scratch/said" "$scratch/counts"
