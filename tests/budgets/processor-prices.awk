# SPDX-License-Identifier: MIT
# Fits the instructions of a Cortex-M0+ for one of a Cortex-M4, by part of a picture's cost.
#     awk -v to=csv: from samples (processor-prices.sh), lines
#         bases|mixed|sets SCENE TICK FRAME TICK FRAME FAST COST... ; PREDICTED
#       ticks and frames of a Cortex-M4, then of a Cortex-M0+, to rows fast,part,factor
#     awk -v to=inc: from those rows to the table of src/quality/processor_prices.inc
#     awk -v to=judge TABLE SAMPLES: prints how far frames of samples are off; to=list: each
#
# A frame's ratio of both counts is the mean of its parts' factors, weighted by the parts'
# costs on a Cortex-M4: costs as predicted, scaled to the counted frame, so that errors of
# the prediction say nothing about the processor.  Factors are those of the least squares of
# the ratios' relative errors, drawn to the MEAN ratio where samples say little.  Parts of
# the water's pixels have OWN factors for fast shading, drawn to those of exact shading.
BEGIN {
    MEAN = 2.9; WEIGHT = 0.05; LEAST = 1; MOST = 8
    # in the order of TP_COST_PARTS: sky, plain to reflection, foam to caustics
    split("1 4 5 6 7 8 9 10 12 13 14 15 16", own_parts, " ")
    for (i in own_parts) OWN[own_parts[i]]
}

$1 ~ /^(bases|mixed|sets)$/ {
    at = ++samples
    name[at] = $2
    frame[at] = $4
    ratio[at] = $6 / $4
    fast[at] = $7
    predicted[at] = $NF
    parts = NF - 9
    for (i = 0; i < parts; i++) cost[at, i] = $(8 + i)
}
to != "csv" && /^[01],/ {
    split($0, cell, ",")
    factor[cell[1], cell[2]] = cell[3] / 256
    if (cell[2] + 1 > parts) parts = cell[2] + 1
}

# Sets x[at, i]: the share of each part in the frame's predicted cost, over the ratio.
function share_parts(    at, i) {
    for (at = 1; at <= samples; at++)
        for (i = 0; i < parts; i++)
            x[at, i] = cost[at, i] / predicted[at] / ratio[at]
}
# Sets factor[fast, part] by coordinate descent, all parts of both shadings together.
function fit(    f, i, k, at, c, upper, lower, new, left) {
    for (at = 1; at <= samples; at++) {
        left[at] = 1
        for (i = 0; i < parts; i++) left[at] -= x[at, i] * factor[fast[at], i]
    }
    for (k = 0; k < 200; k++)
        for (c = 0; c < 2 * parts; c++) {
            i = c % parts
            f = c >= parts
            if (f && !(i in OWN)) continue
            lower = WEIGHT / MEAN / MEAN
            upper = lower * (f ? factor[0, i] : MEAN)
            for (at = 1; at <= samples; at++)
                if (x[at, i] && (!(i in OWN) || fast[at] == f)) {
                    upper += x[at, i] * (left[at] + x[at, i] * factor[fast[at], i])
                    lower += x[at, i] * x[at, i]
                }
            new = upper / lower
            if (new > MOST) new = MOST
            if (new < LEAST) new = LEAST
            for (at = 1; at <= samples; at++)
                if (x[at, i] && (!(i in OWN) || fast[at] == f))
                    left[at] -= x[at, i] * (new - factor[fast[at], i])
            factor[f, i] = new
            if (!(i in OWN)) factor[1, i] = new
        }
}
function print_rows(    f, i) {
    print "# SPDX-License-Identifier: MIT"
    print "# Measured by tests/budgets/processor-prices.sh --write; factors are 256ths."
    print "fast,part,factor"
    for (f = 0; f < 2; f++)
        for (i = 0; i < parts; i++) printf "%d,%d,%.0f\n", f, i, 256 * factor[f, i]
}
function print_table(    f, i) {
    print "/* SPDX-License-Identifier: MIT */"
    print "/* Made by tests/budgets/processor-prices.awk from processor-prices.csv; not to be"
    print " * edited. */"
    for (f = 0; f < 2; f++) {
        printf "[%d] = {", f
        for (i = 0; i < parts; i++)
            printf "%s%.0f", i % 12 ? ", " : i ? ",\n    " : "\n    ", 256 * factor[f, i]
        print "\n},"
    }
}

function size(off) { return off < 0 ? -off : off }
function judge(kind,    at, i, sum, off, all, near, far) {
    for (at = 1; at <= samples; at++) {
        sum = 0
        for (i = 0; i < parts; i++) sum += cost[at, i] * factor[fast[at], i]
        off = kind == "factors" ? sum / predicted[at] / ratio[at] - 1 \
            : kind == "plan" ? sum / frame[at] / ratio[at] - 1 \
            : predicted[at] / frame[at] - 1
        all += size(off)
        bias += off
        near += size(off) <= 0.1
        far += size(off) <= 0.2
        if (to == "list")
            printf "%s %s %d %.2f %.1f %%\n", kind, name[at], fast[at], ratio[at], 100 * off
    }
    printf "    %-8s %d pictures: mean %.1f %%, %d within 10 %%, %d within 20 %%\n", kind,
        samples, 100 * all / samples, near, far
}

END {
    if (to == "inc") {
        print_table()
        exit
    }
    if (to == "judge" || to == "list") {
        judge("factors")        # of a frame counted on a Cortex-M4
        judge("plan")           # of a frame that the plan prices
        judge("m4")             # the plan's prices of a Cortex-M4, to compare
        exit
    }
    for (i = 0; i < parts; i++) factor[0, i] = factor[1, i] = MEAN
    share_parts()
    fit()
    print_rows()
}
