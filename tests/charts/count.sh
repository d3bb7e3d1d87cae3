#!/bin/sh
# SPDX-License-Identifier: MIT
# Exact instructions of a chart's kernels, a unit each, as rows of the sweep.
#
#   tests/charts/count.sh m4|x86 CHART
#
# m4: an emulated Cortex-M4, the board's compiler at -O2; x86: this machine's, -O2.
. tests/gates/lib.sh
. tests/budgets/board.sh

column=$1 chart=$2
case $column in
m4)
    emulate build/charts-m4/kernels.elf "$scratch/said" "$scratch/counts" ;;
x86)
    valgrind --tool=callgrind --callgrind-out-file="$scratch/dump" \
        --dump-before=count_section --collect-atstart=no --toggle-collect='run_*' \
        --compress-strings=no --compress-pos=no \
        build/host/tests/charts/kernels >"$scratch/said" 2>"$scratch/words" &&
        awk -f tests/budgets/callgrind.awk "$scratch"/dump.* >"$scratch/counts" ;;
*)
    echo "usage: count.sh m4|x86 CHART" >&2; exit 2 ;;
esac || { cat "$scratch"/words "$scratch"/said >&2; exit 1; }

awk -v column="$column" -v chart="$chart" '
    FNR == 1         { file++ }
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
