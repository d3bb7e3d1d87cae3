# SPDX-License-Identifier: MIT
# Writes the table of tests/charts/choices.sh from its files, in its order.  `frames`: number
# of golden pictures; `machines`: of the processors that draw them.
BEGIN { FS = "," }
FNR == 1 { file = FILENAME; sub(/.*\//, "", file) }
/^#/ { next }

# -- tables ------------------------------------------------------------------------------

file == "ladder.csv" && $2 ~ /^[0-9]+$/ {
    if ($2 == 0) { exact[$1] = $3; whole[$1] = $4 == 99 }
    if ($4 >= 40) good[$1] = $3
}
file == "boards.csv" && $2 == "stm32f405" {
    pictures[$1] = $3
    if ($5 != "") { scenes++; real += $3 >= 10 }
    if ($5 == "" && $1 !~ /^plain/ && $3 > peer) peer = $3
}
file == "ticks.csv" && $2 == "all" { tick[$1] = $3 }
file == "regret.csv" && FNR > 1 {
    sets++; off += $9; if ($9 > worst) worst = $9
}
file == "predicted.csv" && $1 == "cost" {
    counted++; miss = $4 / $5 - 1; near += miss <= 0.1 && miss >= -0.1
}
file == "predicted.csv" && $1 == "error" { errors++; kept += $6 <= $4 }
file == "stability-rest.csv" && FNR > 1 && $3 <= $10 { pools++; rests += $7 == "rests" }
file == "scenes.csv" && $1 ~ /[+]cheap$/ && $1 !~ /^plain/ && $2 == "instructions" {
    name = $1; sub(/[+].*/, "", name)
    if (exact[name] && whole[name]) cheap[++cheaps] = exact[name] / $3
}
file == "scenes.csv" && $1 == "plain-64+cheap" && $2 == "instructions" { plain = $3 }
file == "minimal.csv" { least[$1] = $2 }
file == "BOARDS.md" && /^[|] `count-64` [|] 28 [|]/ {
    split($0, cell, / *[|] */); ram = cell[11] + cell[12]; level = cell[14]
}

# -- the table ---------------------------------------------------------------------------

function median(of, n,    i, j, x) {
    for (i = 2; i <= n; i++)
        for (j = i; j > 1 && of[j] < of[j - 1]; j--) {
            x = of[j]; of[j] = of[j - 1]; of[j - 1] = x
        }
    return of[int((n + 1) / 2)]
}
function row(want, take, figure, chart) {
    if (figure ~ /(^| )0*( |$)/ || figure ~ /nan/) missing = missing "\n" want ": " figure
    printf "| %s | %s | %s | %s |\n", want, take, figure, chart
}
END {
    for (name in good)
        if (whole[name]) share[++shares] = good[name] / exact[name]
    print "| if you want | take | measured | see |"
    print "|---|---|---|---|"
    row("a picture within 40 dB of the exact one",
        "the last such step of `tidepool plan SCENE --ladder`",
        sprintf("%.0f %% of the exact instructions, median of %d scenes",
                100 * median(share, shares), shares), "[ladder](ladder.png)")
    row("the cheapest picture that is still the scene",
        "the rungs of `tests/budgets/cheapest.txt`, 28 dB",
        sprintf("%.1f times cheaper than exact, median of %d scenes",
                median(cheap, cheaps), cheaps), "[ladder](ladder.png)")
    row("10 pictures a second on an stm32f405",
        "`tidepool plan SCENE --board stm32f405 --fps 10`",
        sprintf("%d of %d scenes reach them", real, scenes),
        "[boards](boards.png), [pictures](../gallery/boards/README.md)")
    row("plain waves, as fast as possible",
        "`--rung fast --set quality.visibility=rows --set quality.rows=pairs`",
        sprintf("%.1f M instructions, %.0f pictures a second on an stm32f405; the " \
                "fastest peer %.0f", plain / 1e6, pictures["plain-64+cheap"], peer),
        "[boards](boards.png)")
    row("many ticks a second with foam", "`--set foam.slices=4`",
        sprintf("deep-sea: %.2f M instructions a tick, %.2f M without",
                tick["deep-sea+cheap"] / 1e6, tick["deep-sea"] / 1e6), "[ticks](ticks.png)")
    row("the fewest instructions for an error",
        "the plan within `quality.error_colour`",
        sprintf("%.2f %% above the cheapest set in the mean, %.1f %% at most", off / sets,
                worst), "[regret](regret.png)")
    row("a prediction for a camera that moves", "`tidepool plan SCENE --set camera...`",
        sprintf("%d of %d errors within the prediction, %d of %d costs within 10 %%", kept,
                errors, near, counted), "[predicted](predicted.png)")
    row("the least RAM", "walked water, tiles of 32x8",
        sprintf("count-64: %.1f KB with its stack, %.0f dB", ram / 1024, level),
        "[memory](../../ports/BOARDS.md#ram-of-shipped-scenes)")
    row("the smallest program", "`tidepool bake` of a scene without features",
        sprintf("%.1f KB of code and constants",
                (least["text"] + least["constants"]) / 1024),
        "[its scene](../../tests/budgets/least.ini)")
    row("water that comes to rest", "any pool below the bound of its damping",
        sprintf("%d of %d pools rest exactly", rests, pools),
        "[rest](stability-rest.png)")
    row("the same picture on every machine", "any rung: all draw equal bits",
        sprintf("%d golden pictures on %d kinds of processor", frames, machines),
        "[the test](../../tests/cross/run.sh)")
    if (missing) {
        print "no figure for" missing >"/dev/stderr"
        exit 1
    }
}
