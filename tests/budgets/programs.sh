#!/bin/sh
# SPDX-License-Identifier: MIT
# Pay for what you use: the cost of the minimal program on a Cortex-M4, which no feature
# may raise, and the text size that each feature adds to a program.
#
#   tests/budgets/programs.sh [--write]     writes a new minimal.csv
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

golden=tests/budgets/minimal.csv
programs=build/cortex-m/features

lacks arm-none-eabi-gcc gcc-arm-none-eabi "the least program" && exit 77
lacks qemu-system-arm qemu-system-arm "the least program" && exit 77

check "all programs build" build BOARD=cortex-m programs
check "the plugin builds" build $plugin
check "the least one runs to its end" emulate $programs/0.elf "$scratch/said" "$scratch/counts"
[ "$failed" = 0 ] || exit 1
draws()         # the program draws water, and leaves nothing out
{
    awk '/^water/ { frames++; bad += $2 == 0 || $NF != 0 } END { exit bad || frames != 2 }' "$1"
}
check "it draws water, and leaves nothing out" draws "$scratch/said"
sed 's/dropped 0/dropped 1/' "$scratch/said" >"$scratch/dropped"
refuse "one that leaves something out" draws "$scratch/dropped"

# One line each: name, number. Instructions are the sum of both frames.
figures()
{
    echo "compiler,arm-none-eabi-gcc $(arm-none-eabi-gcc -dumpversion | sed 's/\..*//')"
    awk -f tests/budgets/map.awk $programs/0.map |
        awk '{ print "text," $1 "\nconstants," $2 }'
    awk '/^ram/ { for (i = 2; i < NF; i += 2) print $i "," $(i + 1) }' "$scratch/said"
    awk '/^count/ { n[$3] += $5 }
        END { print "begin," n["frame"] "\ntiles," n["tiles"] }' "$scratch/counts"
}
figures >"$scratch/figures"

if [ "${1:-}" = --write ]; then
    cp "$scratch/figures" $golden
    exit
fi

no_more()       # GOLDEN
{
    awk -F, 'NR == FNR { most[$1] = $2; next }
        $1 == "compiler" || !($1 in most) { next }
        { seen++ }
        $2 > most[$1] { print $1 ": " $2 ", it was " most[$1]; bad = 1 }
        $2 < most[$1] { print $1 ": " $2 " is less than " most[$1] \
            "; write it down by tests/budgets/programs.sh --write" }
        END { exit bad || seen < 8 }' "$1" "$scratch/figures"
}

want=$(awk -F, '$1 == "compiler" { print $2 }' $golden)
here=$(awk -F, '$1 == "compiler" { print $2 }' "$scratch/figures")
if [ "$want" = "$here" ]; then
    check "the least program costs no more than it did" no_more $golden
    awk -F, -v OFS=, '$1 != "compiler" { $2-- } { print }' $golden >"$scratch/less"
    refuse "a golden number that is one less" no_more "$scratch/less"
else
    skip "golden numbers of $want, here $here" "${want% *}-${want#* }"
fi

awk -F, '{ printf "  %-10s %s\n", $1, $2 }' "$scratch/figures"
sed -n '/^#/!s/ |.*//p' tests/budgets/features.txt >"$scratch/names"
printf '\n%-58s %8s %8s %9s\n' "linked with" text added constants
before=0
for n in $(seq 0 "$(wc -l <"$scratch/names")"); do
    name=$(head -n "$n" "$scratch/names" | tail -n 1)
    set -- $(awk -f tests/budgets/map.awk $programs/"$n".map)
    printf '%-58s %8d %8d %9d\n' "${name:-level water, one texture, the sky}" "$1" \
        $(($1 - before)) "$2"
    before=$1
done
finish
