#!/bin/sh
# SPDX-License-Identifier: MIT
# Judges the prices of sets of rungs (rung-prices.sh) in views of shipped scenes drawn anew:
# cameras, sizes, seas and light that nothing was fitted to.  Of each view the sets are those
# of its walk.  Errors keep their aim, 95 of 100 within the budget.  Costs miss theirs, 95 of
# 100 within 10 %: of 544 sets drawn anew 486 are, 4.3 % off in the mean, and the test
# holds 82 of 100 and 6 %.
#
#   tests/budgets/rung-judge.sh             errors of 17 views, costs of 68 sets
#   TP_SOAK=1 tests/budgets/rung-judge.sh   errors of 306 views, costs of 272 sets
#   TP_SEED=n                               other views
. "$(dirname "$0")/../lib/script.sh"
. "$(dirname "$0")/../lib/board.sh"

samples=build/host/tests/budgets/rung_samples
seed=${TP_SEED:-1}
views=${TP_SOAK:+18} views=${views:-1}
check "the program that draws the views builds" alone build -s $samples
[ "$failed" = 0 ] || exit 1

# of each view and budget of 2, 4 and 8 levels: the last step within the budget, by the plan
walks()
{
    scenes | xargs -P 2 -I{} sh -c "$samples assets/scenes/{}.ini $((seed + 1000)) $views \
        walk >'$scratch/walk-{}'" || return 1
    cat "$scratch"/walk-* |
        awk '$1 == "walk" {
                if ($2 == 0) flush()
                for (b = 2; b <= 8; b *= 2)
                    if ($5 <= b) { predicted[b] = $5; measured[b] = $6; step[b] = $2 }
            }
            function flush(    b) {
                for (b = 2; b <= 8; b *= 2)
                    if (b in step) print b, predicted[b], measured[b], step[b]
                split("", step)
            }
            END { flush() }'
}
scenes()
{
    for ini in assets/scenes/*.ini; do basename "$ini" .ini; done
}
bounds()        # SHARE: this share of the pictures keeps the budget
{
    awk -v least="$1" '
        { all++; held += $3 <= $1; if ($3 > $1) over = over sprintf(" %.1f/%d", $3, $1) }
        END { printf "    %d of %d plans keep their budget; over it:%s\n", held, all, over
              exit !(all >= 40 && held >= least * all) }' "$scratch/walks"
}
walks >"$scratch/walks"
check "the error stays within the budget in 95 of 100 plans" bounds 0.95
sed 's/^/    /' "$scratch/output"

for tool in arm-none-eabi-gcc:gcc-arm-none-eabi qemu-system-arm:qemu-system-arm; do
    lacks "${tool%:*}" "${tool#*:}" "costs of sets on a Cortex-M4" && { finish; exit; }
done
[ -z "$TP_SOAK" ] || views=4
check "what counts the pictures builds" build charts-tools
for scene in $(scenes); do
    tests/budgets/rung-prices.sh --scene "$scene" sets "$views" $((seed + 9000)) || exit 1
done >"$scratch/sets"
near()          # SHARE PERCENT: sets within 10 %, mean difference of cost and count
{
    awk -f tests/budgets/rung-prices.awk -v to=off "$scratch/sets" | sed 's/^sets /    /'
    awk -v least="$1" -v most="$2" '
        { off = $NF / $6 - 1; all++; if (off < 0) off = -off; near += off <= 0.1; sum += off }
        END { exit !(all >= 68 && near >= least * all && 100 * sum <= most * all) }' \
        "$scratch/sets"
}
check "costs of 82 of 100 sets are within 10 %, the mean within 6 %" near 0.82 6
sed 's/^/    /' "$scratch/output"
finish
