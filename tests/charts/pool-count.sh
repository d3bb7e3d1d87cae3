#!/bin/sh
# SPDX-License-Identifier: MIT
# Exact instructions a cell of the pools' steps, as rows of the sweep.
#
#   tests/charts/pool-count.sh m4|x86
#
# m4: an emulated Cortex-M4, the board's compiler at -O2; x86: this machine's, -O2.
. tests/gates/lib.sh
. tests/budgets/board.sh

column=$1
case $column in
m4)
    emulate build/charts-m4/pool_count.elf "$scratch/said" "$scratch/counts" ;;
x86)
    valgrind --tool=callgrind --callgrind-out-file="$scratch/dump" \
        --dump-before=count_section --collect-atstart=no --toggle-collect='run_*' \
        --compress-strings=no --compress-pos=no \
        build/host/tests/charts/pool_count >"$scratch/said" 2>"$scratch/words" &&
        awk -f tests/budgets/callgrind.awk "$scratch"/dump.* >"$scratch/counts" ;;
*)
    echo "usage: pool-count.sh m4|x86" >&2; exit 2 ;;
esac || { cat "$scratch"/words "$scratch"/said >&2; exit 1; }

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
