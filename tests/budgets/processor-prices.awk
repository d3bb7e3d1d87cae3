# SPDX-License-Identifier: MIT
# Fits the instructions of a Cortex-M0+ for one of a Cortex-M4, by part of a picture's cost.
#     awk -v to=csv: from samples (processor-prices.sh), lines
#         MODE SCENE TICK FRAME TICK FRAME SHADED COST... ; PREDICTED
#       ticks and frames of a Cortex-M4, then of a Cortex-M0+, to rows shaded,part,factor
#     awk -v to=inc: from those rows to the table of src/quality/processor_prices.inc
#     awk -v to=judge TABLE SAMPLES: prints how far frames of samples are off; to=list: each
#
# A frame's ratio of both counts is the mean of its parts' factors, weighted by the parts'
# costs on a Cortex-M4: costs as predicted, scaled to the counted frame, so that errors of
# the prediction say nothing about the processor.  Factors are those of the least squares of
# the ratios' relative errors, first one for each kind of parts (finding the water, pixels
# of each shading, all else), drawn to the MEAN ratio; then one for each part, drawn to its
# kind's where samples say little.  A part that fewer than FEW samples show keeps its
# kind's.
BEGIN {
    MEAN = 2.9; WEIGHT = 0.004; LEAST = 1; MOST = 8
    FEW = 4; SHOWN = 0.01       # a sample shows a part of this share of its frame
    SEEN = 10; PIXELS = 30      # TP_PARTS_SEEN, TP_PARTS_OF_PIXELS of rung_sets.h
    SHADED = 3                  # TP_SHADED_COUNT
}

$1 ~ /^(bases|mixed|sets)$/ {
    at = ++samples
    name[at] = $1 " " $2
    frame[at] = $4
    ratio[at] = $6 / $4
    shaded[at] = $7
    predicted[at] = $NF
    parts = NF - 9
    for (i = 0; i < parts; i++) cost[at, i] = $(8 + i)
}
to != "csv" && /^[0-9],/ {
    split($0, cell, ",")
    factor[cell[1], cell[2]] = cell[3] / 256
    if (cell[2] + 1 > parts) parts = cell[2] + 1
}

# -- the fit ----------------------------------------------------------------------------

function own_key(at, i) { return (is_pixel(i) ? shaded[at] : 0) SUBSEP i }
function kind_key(at, i) {
    return i < SEEN ? "seen" : is_pixel(i) ? "pixels" shaded[at] : "other"
}
function is_pixel(i) { return i >= SEEN && i < PIXELS }

# Sets x[key, at], the share of a factor's parts in the sample's predicted cost over the
# ratio, and use[key, n], the samples with the factor, of the parts or of their kinds.
function share_parts(of_kinds,    at, i, key, share) {
    split("", x); split("", uses); split("", shows)
    for (at = 1; at <= samples; at++)
        for (i = 0; i < parts; i++) {
            if (!cost[at, i]) continue
            key = of_kinds ? kind_key(at, i) : own_key(at, i)
            share = cost[at, i] / predicted[at]
            shows[key] += share >= SHOWN
            if (!((key, at) in x)) use[key, ++uses[key]] = at
            x[key, at] += share / ratio[at]
        }
}
# Sets m[key] by coordinate descent, drawn to mean[key]; keys of few samples keep that.
function descend(    k, key, n, at, upper, lower, new) {
    for (at = 1; at <= samples; at++) left[at] = 1
    for (key in uses) {
        m[key] = mean[key]
        for (n = 1; n <= uses[key]; n++) left[use[key, n]] -= x[key, use[key, n]] * m[key]
    }
    for (k = 0; k < 300; k++)
        for (key in uses) {
            if (shows[key] < FEW) continue
            lower = WEIGHT / mean[key] / mean[key]
            upper = lower * mean[key]
            for (n = 1; n <= uses[key]; n++) {
                at = use[key, n]
                upper += x[key, at] * (left[at] + x[key, at] * m[key])
                lower += x[key, at] * x[key, at]
            }
            new = upper / lower
            if (new > MOST) new = MOST
            if (new < LEAST) new = LEAST
            for (n = 1; n <= uses[key]; n++)
                left[use[key, n]] -= x[key, use[key, n]] * (new - m[key])
            m[key] = new
        }
}
function fit(    f, i, key) {
    share_parts(1)
    for (key in uses) mean[key] = MEAN
    descend()
    for (f = 0; f < SHADED; f++)
        for (i = 0; i < parts; i++) {
            key = i < SEEN ? "seen" : is_pixel(i) ? "pixels" f : "other"
            mean[f, i] = key in m ? m[key] : MEAN
        }
    share_parts(0)
    descend()
    for (f = 0; f < SHADED; f++)
        for (i = 0; i < parts; i++) {
            key = (is_pixel(i) ? f : 0) SUBSEP i
            factor[f, i] = key in uses ? m[key] : mean[f, i]
        }
}

# -- the table --------------------------------------------------------------------------

function print_rows(    f, i) {
    print "# SPDX-License-Identifier: MIT"
    print "# Measured by tests/budgets/processor-prices.sh --write; factors are 256ths."
    print "shaded,part,factor"
    for (f = 0; f < SHADED; f++)
        for (i = 0; i < parts; i++) printf "%d,%d,%.0f\n", f, i, 256 * factor[f, i]
}
function print_table(    f, i) {
    print "/* SPDX-License-Identifier: MIT */"
    print "/* Made by tests/budgets/processor-prices.awk from processor-prices.csv; not to"
    print " * be edited. */"
    for (f = 0; f < SHADED; f++) {
        printf "[%d] = {", f
        for (i = 0; i < parts; i++)
            printf "%s%.0f", i % 12 ? ", " : i ? ",\n    " : "\n    ", 256 * factor[f, i]
        print "\n},"
    }
}

# -- judgement --------------------------------------------------------------------------

function size(off) { return off < 0 ? -off : off }
function judge(kind,    at, i, sum, off, all, near, far) {
    for (at = 1; at <= samples; at++) {
        sum = 0
        for (i = 0; i < parts; i++) sum += cost[at, i] * factor[shaded[at], i]
        off = kind == "factors" ? sum / predicted[at] / ratio[at] - 1 \
            : kind == "plan" ? sum / frame[at] / ratio[at] - 1 \
            : predicted[at] / frame[at] - 1
        all += size(off)
        near += size(off) <= 0.1
        far += size(off) <= 0.2
        if (to == "list")
            printf "%s %s %d %.2f %.1f %%\n", kind, name[at], shaded[at], ratio[at],
                100 * off
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
    fit()
    print_rows()
}
