#!/bin/sh
# SPDX-License-Identifier: MIT
# Cost of each model of the water: instructions a vertex, cell, drop or ring on this
# machine and on an emulated Cortex-M4, exact and repeatable; compared with models.csv.
#
#   tests/budgets/models-count.sh [--write]     writes a new models.csv
#
# -O3 and x86-64-v3 are counted when it writes, and with TP_SOAK set.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

write=
[ "${1:-}" = --write ] && write=1
budgets=tests/budgets/models.csv
runs=                           # build=NAME SAID COUNTS ...
whole=1
skip=                           # builds without figures, or by another compiler

# Counts with callgrind: one dump at the end of each section.
profile()       # BUILD PROGRAM
{
    valgrind --tool=callgrind --callgrind-out-file="$scratch/$1/dump" \
        --dump-before=count_section --collect-atstart=no \
        --toggle-collect='counted_*' --compress-strings=no --compress-pos=no \
        "$2" >"$scratch/$1/said" || { tail -n 1 "$scratch/$1/said"; false; }
}

host()          # BUILD TARGET OPT ARCH [CC]
{
    program=build/$2/tests/budgets/models
    mkdir "$scratch/$1"
    check "$1: the counting program builds" alone build TARGET="$2" OPT="$3" ARCH="$4" \
        CC="${5:-${CC:-cc}}" $program
    check "$1: it runs to its end" profile $1 $program
    awk -f tests/budgets/callgrind.awk "$scratch/$1"/dump.* >"$scratch/$1/counts"
    runs="$runs build=$1 $scratch/$1/said $scratch/$1/counts"
}

board()         # BUILD ELF
{
    mkdir "$scratch/$1"
    check "$1: the counting program builds" build BOARD=cortex-m "$2"
    check "$1: the plugin builds" build $plugin
    check "$1: it runs to its end" emulate "$2" "$scratch/$1/said" "$scratch/$1/counts"
    runs="$runs build=$1 $scratch/$1/said $scratch/$1/counts"
}

if [ "$(uname -m)" != x86_64 ]; then
    skip "models on x86-64" "valgrind"
    skip="o2 o3 v3"
elif lacks valgrind valgrind "models on x86-64"; then
    skip="o2 o3 v3"
else
    host o2 host "-O2 -g1"
    if [ -z "$write${TP_SOAK:-}" ]; then
        skip="o3 v3"
    elif host o3 cross/host-gcc-O3 -O3 "" gcc && grep -qw avx2 /proc/cpuinfo; then
        host v3 count-v3 -O3 -march=x86-64-v3
    else
        skip "models on x86-64-v3" "none: the processor lacks AVX2"
        skip=v3
    fi
    [ -n "$write" ] || pinned $budgets x86 "${CC:-cc}" || skip="o2 o3 v3"
fi

if lacks arm-none-eabi-gcc gcc-arm-none-eabi "models on a Cortex-M4" ||
    lacks qemu-system-arm qemu-system-arm "models on a Cortex-M4"; then
    skip="$skip m4"
else
    board m4 build/cortex-m/models.elf
    [ -n "$write" ] || pinned $budgets m4 arm-none-eabi-gcc || skip="$skip m4"
fi

[ "$failed" = 0 ] || exit 1
[ -n "$runs" ] || exit 77
awk -f tests/budgets/models.awk $runs >"$scratch/figures"
counted=$?
grep -v '^figure' "$scratch/figures"
[ $counted = 0 ] || exit 1
if [ -n "$write" ]; then
    [ -z "$skip" ] || { echo "FAILED - budgets are written of all builds"; exit 1; }
    rewrite $budgets x86="${CC:-cc}" m4=arm-none-eabi-gcc
    exit
fi
hold $budgets
finish
