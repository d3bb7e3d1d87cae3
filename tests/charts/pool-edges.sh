#!/bin/sh
# SPDX-License-Identifier: MIT
# Instructions of pools by edge and drive, as rows of the sweep: the updates or splashes that
# `pools` prints, times the exact count of an update.
#
#   tests/charts/pool-edges.sh m4|x86 pool-walls-cells
#   tests/charts/pool-edges.sh m4|x86 pool-sponge-cells DEGREES
#   tests/charts/pool-edges.sh m4|x86 pool-feed M
#
# A field is run once: with its instructions on the Cortex-M4 all its other rows are printed.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

column=$1
counted "$column" pool_edges_count
shift
build/host/tests/charts/pools "$@" >"$scratch/rows" || exit 1
[ "$column$1" != m4pool-feed ] || cat "$scratch/rows"

awk -F '[ ,]' -v column="$column" '
    $1 == "pool"  { kind[++said] = $2 " " $3; cells[said] = $4 }
    $1 == "count" { insns[$2] += $5 }
    function price(of,    i) {
        for (i = 1; i <= said; i++)
            if (kind[i] == of && insns[i] > 0)
                return insns[i] / cells[i]
        print "pool-edges.sh: no count of " of > "/dev/stderr"
        exit failed = 1
    }
    function put(value) {
        printf "%s,%s,%s,%.5g\n", $1, $2, column, value
        rows++
    }
    $1 == "pool-walls" && $3 == "updates" {
        split($2, key, ";")
        put($4 * price(key[1] " " (key[2] == "edge" ? "edge" : "mask")))
    }
    $1 == "pool-sponge" && $3 == "updates" {
        split($2, key, ";")
        put($4 * price("16 " (key[1] == 0 ? "edge" : "sponge")))
    }
    $1 == "pool-feed" && $3 == "share" {
        put(price("16 drive") + $4 / 100 * (price("16 splash") - price("16 drive")))
    }
    END { exit failed || !rows }' "$scratch/said" "$scratch/counts" "$scratch/rows"
