#!/bin/sh
# SPDX-License-Identifier: MIT
# The instructions of a Cortex-M0+ for one of a Cortex-M4, by part of a picture's cost.
#
#   tests/budgets/processor-prices.sh           the test: src/quality/processor_prices.inc
#                                               is made from processor-prices.csv beside
#                                               this script, and small pictures of two
#                                               scenes cost by it what they cost; with
#                                               TP_SOAK those of all scenes, of any size
#   tests/budgets/processor-prices.sh --write   measures again, 12 minutes: pictures on the
#                                               emulated board, in 4 views of each shipped
#                                               scene, with code for either processor
#   tests/budgets/processor-prices.sh --refit   fits again to the pictures that --write
#                                               counted, 25 seconds: enough after changes
#                                               of src/quality
#   tests/budgets/processor-prices.sh --judge [SEED]
#                                               counts sets in views drawn anew, and prints
#                                               how far the prices of a Cortex-M0+ are off
#
# Build again after --write and --refit.
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

table=tests/budgets/processor-prices.csv
made=src/quality/processor_prices.inc
samples=build/host/tests/budgets/rung_samples
kept=build/host/processor-counts        # lines MODE SCENE TICK FRAME TICK FRAME picture ...
group=14                        # pictures of one run of the board

same_made()
{
    awk -f tests/budgets/processor-prices.awk -v to=inc $table | cmp - $made
}

# -- counts ------------------------------------------------------------------------------

# counted SCENE PROCESSOR: counts the pictures of $scratch/samples.
counted()
{
    sed -n 's/^picture [^ ]* [^ ]* //p' "$scratch/samples" |
        xargs -d '\n' -n $group tests/charts/board.sh "$2" "$1" 320x240 60 \
        >"$scratch/$2"
}
# both_counted SCENE MODE: prints "MODE SCENE TICK FRAME TICK FRAME picture ..." of each
# picture of $scratch/samples: of a Cortex-M4, then of a Cortex-M0+.
both_counted()
{
    counted "$1" m4 && counted "$1" m0 || return 1
    grep '^picture' "$scratch/samples" >"$scratch/pictures"
    paste -d ' ' "$scratch/m4" "$scratch/m0" "$scratch/pictures" |
        awk -v name="$2 $1" '
            $10 != $20 { print "other bits: " $0 >"/dev/stderr"; exit 1 }
            {
                printf "%s %s %.0f %s %.0f", name, $6, $7 + $8, $16, $17 + $18
                for (i = 21; i <= NF; i++) printf " %s", $i
                print ""
            }' >"$scratch/lines" && cat "$scratch/lines"        # in one write
}
sampled()       # MODE VIEWS SEED: of all shipped scenes, two at a time
{
    scenes | xargs -P 2 -I{} "$0" --count {} "$1" "$2" "$3"
}
scenes()
{
    for ini in assets/scenes/*.ini; do basename "$ini" .ini; done
}
# priced FILE: prints "MODE SCENE TICK FRAME TICK FRAME SHADED COST... ; PREDICTED" of each
# counted picture, by the program's prices of a Cortex-M4.
priced()
{
    for scene in $(cut -d ' ' -f 2 "$1" | sort -u); do
        awk -v scene="$scene" '$2 == scene' "$1" >"$scratch/scene"
        cut -d ' ' -f 1-6 "$scratch/scene" >"$scratch/names"
        cut -d ' ' -f 7- "$scratch/scene" |
            "$samples" "assets/scenes/$scene.ini" 0 0 again |
            sed -n 's/^costs //p' | paste -d ' ' "$scratch/names" -
    done
}
fitted()
{
    priced $kept >build/host/processor-samples &&
        awk -f tests/budgets/processor-prices.awk -v to=csv build/host/processor-samples \
            >"$scratch/table" &&
        cp "$scratch/table" $table &&
        awk -f tests/budgets/processor-prices.awk -v to=inc $table >$made
}
judged()        # FILE: prints the share of sets within 10 and 20 % and the mean, by kind
{
    priced "$1" >"$scratch/priced" &&
        awk -v to=judge -f tests/budgets/processor-prices.awk $table "$scratch/priced"
}

case ${1:-} in
--count)        # SCENE MODE VIEWS SEED ["SIZE TICK"]: pictures of their own, or this, size
    "$samples" "assets/scenes/$2.ini" "$5" "$4" "$3" >"$scratch/samples" || exit 1
    [ -z "$6" ] ||
        sed -i "s/^\(picture [^ ]* [^ ]*\) [^ ]* [^ ]*/\1 $6/" "$scratch/samples" || exit 1
    both_counted "$2" "$3"
    exit ;;
--write)
    build $samples processor-tools >/dev/null || exit 1
    { sampled sets 1 35 && sampled mixed 1 39 && sampled bases 1 31 && sampled bases 1 32
    } >$kept || exit 1
    fitted
    exit ;;
--refit)
    build $samples >/dev/null && fitted
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

# -- pictures drawn anew -----------------------------------------------------------------

seed=${TP_SEED:-6001}
drawn='count-64 three-swells' small='160x120 1'   # size and tick of the pictures
if [ -n "$TP_SOAK" ]; then drawn=$(scenes) small=; fi

build_drawn()   # what draws and counts the pictures, for both processors
{
    build $samples build/host/count.so || return 1
    for board in cortex-m cortex-m/m0plus; do
        build BOARD=$board $(printf "build/${board##*/}/charts/%s.elf\n" $drawn) || return 1
    done
}
drawn_anew()
{
    printf '%s\n' $drawn | xargs -P 2 -I{} "$0" --count {} sets 1 "$seed" "$small" \
        >"$scratch/anew" && priced "$scratch/anew" >"$scratch/samples"
}
judged_by()     # TABLE
{
    awk -v to=judge -f tests/budgets/processor-prices.awk "$1" "$scratch/samples"
}
within()        # KIND PERCENT SHARE [TABLE]: mean error, and the share within 10 %
{
    judged_by "${4:-$table}" | awk -v kind="$1" -v most="$2" -v share="$3" '
        { print }
        $1 == kind { held = $2 >= 8 && $5 <= most && $7 >= share * $2 }
        END { exit !held }'
}
check "what counts the pictures builds" build_drawn
[ $failed = 0 ] || exit 1
check "the pictures are counted on both processors" drawn_anew
[ $failed = 0 ] || exit 1
# 8 small pictures are 5.1 % off in the mean at most in 7 draws, 102 of all scenes 3.5 %.
if [ -n "$TP_SOAK" ]; then most=5 share=0.9; else most=7 share=0.75; fi
check "pictures take by the factors what they take, within $most % in the mean" \
    within factors $most $share
sed 's/^/    /' "$scratch/output"
awk -F, -v OFS=, '/^[0-9]/ { $3 *= 0.8 } { print }' $table >"$scratch/less"
refuse "factors of 0.8 times as much" within factors $most $share "$scratch/less"
[ -z "$TP_SOAK" ] || check "the plan's price is within 9 % in the mean" within plan 9 0.65
finish
