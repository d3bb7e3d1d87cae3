#!/bin/sh
# SPDX-License-Identifier: MIT
# The instructions of a Cortex-M0+ for one of a Cortex-M4, by part of a picture's cost.
#
#   tests/budgets/processor-prices.sh           the test: src/quality/processor_prices.inc is
#                                               made from processor-prices.csv beside this
#                                               script, and pictures of two scenes drawn anew
#                                               cost by it what they cost
#   tests/budgets/processor-prices.sh --write   measures again, 12 minutes: pictures on the
#                                               emulated board, in 5 views of each shipped
#                                               scene, with code for either processor
#   tests/budgets/processor-prices.sh --judge [SEED]
#                                               counts sets in views drawn anew, and prints
#                                               how far the prices of a Cortex-M0+ are off
#
# Build again after --write.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

table=tests/budgets/processor-prices.csv
made=src/quality/processor_prices.inc
samples=build/host/tests/budgets/rung_samples
group=14                        # pictures of one run of the board

same_made()
{
    awk -f tests/budgets/processor-prices.awk -v to=inc $table | cmp - $made
}

# counted SCENE PROCESSOR: counts the pictures of $scratch/samples.
counted()
{
    sed -n 's/^picture [^ ]* [^ ]* //p' "$scratch/samples" |
        xargs -d '\n' -n $group tests/charts/board.sh "$2" "$1" 320x240 60 \
        >"$scratch/$2"
}
sampled()       # MODE VIEWS SEED: of all shipped scenes, two at a time
{
    for ini in assets/scenes/*.ini; do basename "$ini" .ini; done |
        xargs -P 2 -I{} "$0" --scene {} "$1" "$2" "$3" | sort
}
judged()        # prints the share of sets within 10 and 20 % and the mean, by kind of error
{
    awk -v to=judge -f tests/budgets/processor-prices.awk $table "$1"
}

build_two()     # the pictures of two scenes, for both processors
{
    build $samples build/host/count.so || return 1
    for board in cortex-m cortex-m/m0plus; do
        build BOARD=$board $(printf "build/${board##*/}/charts/%s.elf\n" $drawn) || return 1
    done
}

case ${1:-} in
--scene)        # SCENE MODE VIEWS SEED: MODE SCENE TICK FRAME, TICK FRAME of a Cortex-M0+,
                # FAST, costs
    "$samples" "assets/scenes/$2.ini" "$5" "$4" "$3" >"$scratch/samples" || exit 1
    counted "$2" m4 && counted "$2" m0 || exit 1
    sed -n 's/^costs //p' "$scratch/samples" >"$scratch/costs"
    paste -d ' ' "$scratch/m4" "$scratch/m0" "$scratch/costs" |
        awk -v name="$3 $2" '
            $10 != $20 { print "other bits: " $0 >"/dev/stderr"; exit 1 }
            {
                printf "%s %s %.0f %s %.0f", name, $6, $7 + $8, $16, $17 + $18
                for (i = 21; i <= NF; i++) printf " %s", $i
                print ""
            }' >"$scratch/lines" && cat "$scratch/lines"        # in one write
    exit ;;
--write)
    build $samples processor-tools >/dev/null || exit 1
    { sampled bases 3 31 && sampled mixed 1 39 && sampled sets 1 35
    } >build/host/processor-samples || exit 1
    awk -f tests/budgets/processor-prices.awk -v to=csv build/host/processor-samples \
        >"$scratch/table" &&
        cp "$scratch/table" $table &&
        awk -f tests/budgets/processor-prices.awk -v to=inc $table >$made
    exit ;;
--judge)
    build $samples processor-tools >/dev/null || exit 1
    { sampled sets 1 "$((${2:-1} + 4000))" && sampled bases 1 "$((${2:-1} + 5000))"
    } >build/host/processor-judged || exit 1
    judged build/host/processor-judged
    exit ;;
esac
check "$made is made from $table" same_made
for tool in arm-none-eabi-gcc:gcc-arm-none-eabi qemu-system-arm:qemu-system-arm; do
    lacks "${tool%:*}" "${tool#*:}" "costs on a Cortex-M0+" && { finish; exit; }
done
drawn='count-64 three-swells'
check "what counts the pictures builds" build_two
[ $failed = 0 ] || exit 1
for scene in $drawn; do
    "$0" --scene "$scene" bases 1 ${TP_SEED:-6001} && "$0" --scene "$scene" sets 1 ${TP_SEED:-6002}
done >"$scratch/samples"
within()        # PERCENT: mean error of the factors, of frames counted on a Cortex-M4
{
    judged "$scratch/samples" | awk -v most="$1" '
        { print } $1 == "factors" && $2 >= 12 { mean = $5 }
        END { exit !(mean > 0 && mean < most) }'
}
check "pictures take by the factors what they take, within 8 % in the mean" within 8
sed 's/^/    /' "$scratch/output"
finish
