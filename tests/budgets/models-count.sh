#!/bin/sh
# SPDX-License-Identifier: MIT
# What every model of the water costs: instructions a vertex, cell, drop or ring on this
# machine and on an emulated Cortex-M4, exact and repeatable; held against models.txt.
#
#   tests/budgets/models-count.sh [--write]     writes models.txt anew
. tests/gates/lib.sh
. tests/budgets/board.sh

budgets=tests/budgets/models.txt
runs=                           # build=NAME SAID COUNTS ...
held=                           # builds whose compiler is that of the budgets

# The first of "compiler BUILD NAME VERSION" against what NAME is here.
hold()          # BUILD COMPILER NAME...
{
    want=$(awk -v of="$1" '$1 == "compiler" && $2 == of { print $3, $4 }' $budgets)
    here="${want% *} $($2 -dumpversion | sed 's/\..*//')"
    shift 2
    if [ "$here" = "$want" ]; then
        held="$held $*"
    else
        echo "skipped: budgets of $want, here $here (package ${want% *}-${want#* })"
    fi
}

# By callgrind, a dump at each section's end.
profile()       # BUILD PROGRAM
{
    valgrind --tool=callgrind --callgrind-out-file="$scratch/$1/dump" \
        --dump-before=count_section --collect-atstart=no \
        --toggle-collect='counted_*' --compress-strings=no --compress-pos=no \
        "$2" >"$scratch/$1/said" || { tail -n 1 "$scratch/$1/said"; false; }
}

host()          # BUILD TARGET OPT ARCH
{
    program=build/$2/tests/budgets/models
    mkdir "$scratch/$1"
    check "$1: the counting program builds" build TARGET="$2" OPT="$3" ARCH="$4" $program
    check "$1: it runs to its end" profile $1 $program
    awk -f tests/budgets/callgrind.awk "$scratch/$1"/dump.* >"$scratch/$1/counts"
    runs="$runs build=$1 $scratch/$1/said $scratch/$1/counts"
}

board()         # BUILD ELF
{
    mkdir "$scratch/$1"
    check "$1: the counting program builds" build BOARD=cortex-m TARGET="count-$1" "$2"
    check "$1: the plugin builds" build $plugin
    check "$1: it runs to its end" emulate "$2" "$scratch/$1/said" "$scratch/$1/counts"
    runs="$runs build=$1 $scratch/$1/said $scratch/$1/counts"
}

if [ "$(uname -m)" != x86_64 ]; then
    echo "skipped: models on x86-64 (package valgrind)"
elif ! lacks valgrind valgrind "models on x86-64"; then
    host o2 host "-O2 -g"
    host o3 count-o3 -O3
    if grep -qw avx2 /proc/cpuinfo; then
        host v3 count-v3 -O3 -march=x86-64-v3
    else
        echo "skipped: models on x86-64-v3 (package none: the processor lacks AVX2)"
    fi
    hold x86 "${CC:-cc}" o2 o3 v3
fi

if ! lacks arm-none-eabi-gcc gcc-arm-none-eabi "models on a Cortex-M4" &&
    ! lacks qemu-system-arm qemu-system-arm "models on a Cortex-M4"; then
    board m4 build/count-m4/models.elf      # apart from what board-count.sh builds
    hold m4 arm-none-eabi-gcc m4
fi

[ "$failures" = 0 ] || exit 1
[ -n "$runs" ] || exit 77
if [ "${1:-}" = --write ]; then
    awk -v write=1 -f tests/budgets/models.awk $budgets $runs >"$scratch/budgets" &&
        cp "$scratch/budgets" $budgets
    exit
fi

# And the budgets can be missed: with ceilings at half of what they are all figures are.
awk 'NF == 6 && !/^#/ { $2 /= 2; $3 /= 2; $4 /= 2; $5 /= 2 } { print }' $budgets \
    >"$scratch/halved"
[ -z "$held" ] || refuse "budgets of half as much" \
    awk -v held="$held" -f tests/budgets/models.awk "$scratch/halved" $runs
awk -v held="$held" -f tests/budgets/models.awk $budgets $runs && exit $((failures > 0))
