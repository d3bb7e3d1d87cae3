# SPDX-License-Identifier: MIT
# Fits the prices of rungs.
#     awk -v to=csv: from samples (rung-prices.sh), lines
#         bases|rungs|mixed SCENE - - TICK FRAME FAST -[,KIND;RUNG;MASK]... PART... ; PREDICTED
#         mesh RUNG SAVED PART
#         error SCENE KIND RUNG SEA SHARE SQUARE
#       to rows kind,rung,figure,value.
#     awk -v to=inc: from those rows to the table of src/quality/rung_prices.inc
#
# 1. A factor for each part: the least squares of the relative errors of whole frames, drawn
#    to 1 where samples say little.  Parts of the water's pixels have OWN factors for fast
#    shading, the others keep theirs.
# 2. A factor for each rung: the share of its parts that stays, by least squares; 1 and 2 in
#    turn, since each needs the other.
# 3. An error for each rung and class of sea: the SHOWN part of all views have a smaller
#    mean square.
BEGIN {
    SHOWN = 0.92; SEAS = 12; sorted = "sort -t, -k1,1 -k2,2n -k3,3"
    WEIGHT = 0.05; PRIOR_FAST = 0.4; LEAST = 0.2; LEAST_FAST = 0.05; MOST = 1.6
    # in the order of TP_COST_PARTS: sky, plain to reflection, objects to caustics
    split("1 4 5 6 7 8 9 10 13 14 15 16", own_parts, " ")
    for (i in own_parts) OWN[own_parts[i]]
}

# -- samples ----------------------------------------------------------------------------

to == "csv" && $1 ~ /^(bases|rungs|mixed)$/ {
    at = ++samples
    frame[at] = $6
    fast[at] = $7
    kinds[at] = split($8, list, ",") - 1
    for (i = 1; i <= kinds[at]; i++) {
        split(list[i + 1], name, ";")
        own = name[1] ";" name[2]
        rung_of[at, i] = own
        mask[own] = name[3]
    }
    parts = NF - 10
    for (i = 0; i < parts; i++) value[at, i] = $(9 + i)
}
to == "csv" && $1 == "mesh" {
    mesh[$2] = $3 < $4 ? int(256 - 256 * $3 / $4 + 0.5) : 1
}
to == "csv" && $1 == "error" {
    at = $3 ";" $4
    errors[at]
    if ($6 <= 0.002) next
    square[at, $5, ++n[at, $5]] = $7 > 0 ? $7 / $6 : 0
    square[at, "all", ++n[at, "all"]] = $7 > 0 ? $7 / $6 : 0
}

# -- fits -------------------------------------------------------------------------------

function in_mask(own, i) { return int(mask[own] / 2 ^ i) % 2 }

# Sets x[at, i]: the parts of each sample by its rungs, as shares of the counted frame.
# Fewer vertices are cheaper by their number.
function share_parts(    at, i, k, own, rung) {
    for (own in mask)
        for (i = 0; i < parts; i++) changes[own, i] = in_mask(own, i)
    for (at = 1; at <= samples; at++)
        for (i = 0; i < parts; i++) {
            x[at, i] = value[at, i] / frame[at]
            for (k = 1; k <= kinds[at]; k++) {
                own = rung_of[at, k]
                if (changes[own, i]) x[at, i] *= factor[own]
                if (i == 3 && own ~ /^grid.vertices/) {
                    rung = own; sub(/.*;/, "", rung)
                    x[at, i] *= 0.5 ^ rung
                }
            }
        }
}
# Sets m[fast, part] by coordinate descent, all parts of both shadings together.
function fit_parts(    f, i, k, at, c, upper, lower, prior, least, new, left) {
    for (at = 1; at <= samples; at++) {
        left[at] = 1
        for (i = 0; i < parts; i++) left[at] -= x[at, i] * m[fast[at], i]
    }
    for (k = 0; k < 30; k++)
        for (c = 0; c < 2 * parts; c++) {
            i = c % parts
            f = c >= parts
            if (f && !(i in OWN)) continue
            prior = f ? PRIOR_FAST : 1
            least = i >= parts - 3 ? 0 : f ? LEAST_FAST : LEAST
            upper = WEIGHT * prior; lower = WEIGHT
            for (at = 1; at <= samples; at++)
                if (x[at, i] && (!(i in OWN) || fast[at] == f)) {
                    upper += x[at, i] * (left[at] + x[at, i] * m[fast[at], i])
                    lower += x[at, i] * x[at, i]
                }
            new = upper / lower
            if (new > MOST) new = MOST
            if (new < least) new = least
            for (at = 1; at <= samples; at++)
                if (x[at, i] && (!(i in OWN) || fast[at] == f))
                    left[at] -= x[at, i] * (new - m[fast[at], i])
            m[f, i] = new
            if (!(i in OWN)) m[1, i] = new
        }
}
# Sets each rung's factor by least squares of the same shares, one rung after another.
function fit_rungs(    at, i, k, own, inside, rest, upper, lower, was) {
    for (own in mask) {
        upper = lower = 0.02
        was = factor[own]
        for (at = 1; at <= samples; at++)
            for (k = 1; k <= kinds[at]; k++)
                if (rung_of[at, k] == own) {
                    inside = rest = 0
                    for (i = 0; i < parts; i++)
                        if (changes[own, i]) inside += x[at, i] * m[fast[at], i] / was
                        else rest += x[at, i] * m[fast[at], i]
                    upper += (1 - rest) * inside
                    lower += inside * inside
                }
        factor[own] = upper / lower
        if (factor[own] < 0.02) factor[own] = 0.02
        if (factor[own] > 1.2) factor[own] = 1.2
        for (at = 1; at <= samples; at++)
            for (k = 1; k <= kinds[at]; k++)
                if (rung_of[at, k] == own)
                    for (i = 0; i < parts; i++)
                        if (changes[own, i]) x[at, i] *= factor[own] / was
    }
}
function quantile(at, sea,    i, j, k, most, list) {
    k = n[at, sea]
    for (i = 1; i <= k; i++) list[i] = square[at, sea, i]
    for (i = 2; i <= k; i++)
        for (j = i; j > 1 && list[j] < list[j - 1]; j--) {
            most = list[j]; list[j] = list[j - 1]; list[j - 1] = most
        }
    i = int(SHOWN * k + 0.999)
    return list[i < 1 ? 1 : i > k ? k : i]
}

# -- the table --------------------------------------------------------------------------

to == "inc" && /^[a-z]/ && !/^kind,/ {
    split($0, cell, ",")
    key = cell[1] SUBSEP cell[2]
    if (!(key in seen)) { seen[key]; order[++rows] = key }
    figure[key, cell[3]] = cell[4]
    if (cell[1] == "part" && cell[3] + 1 > parts) parts = cell[3] + 1
}
function print_rows(    at, name, sea, of, i, f) {
    print "# SPDX-License-Identifier: MIT"
    print "# Measured by tests/budgets/rung-prices.sh --write; factors are 256ths."
    print "kind,rung,figure,value"
    for (f = 0; f < 2; f++)
        for (i = 0; i < parts; i++)
            print "part," f "," i "," int(256 * m[f, i] + 0.5) | \
                "sort -t, -k1,1 -k2,2n -k3,3n"
    close("sort -t, -k1,1 -k2,2n -k3,3n")
    for (at in errors) {
        split(at, name, ";")
        f = at in factor ? int(256 * factor[at] + 0.5) : 256
        if (name[1] == "quality.mesh") f = mesh[name[2]]
        print name[1] "," name[2] ",factor," f | sorted
        for (sea = 0; sea < SEAS; sea++) {
            of = "all"
            if (n[at, sea] > 5) of = sea
            print name[1] "," name[2] ",sea" sea "," int(256 * quantile(at, of) + 0.999) | \
                sorted
        }
    }
}
function print_table(    i, j, name, kind, sea) {
    print "/* SPDX-License-Identifier: MIT */"
    print "/* Made by tests/budgets/rung-prices.awk from rung-prices.csv; not to be edited. */"
    for (i = 0; i < 2; i++) {
        printf "PARTS([%d] = {", i
        for (j = 0; j < parts; j++)
            printf "%s%d", j % 12 ? ", " : j ? ",\n    " : "\n    ", figure["part" SUBSEP i, j]
        print "\n},)"
    }
    for (i = 1; i <= rows; i++) {
        split(order[i], name, SUBSEP)
        kind = name[1]
        if (kind == "part") continue
        sub(/^quality\./, "", kind); sub(/^grid\./, "", kind); sub(/\./, "_", kind)
        if (kind ~ /^(visibility|shading|rate)$/) kind = toupper(kind)
        printf "RUNGS([TP_KIND_%s][%d] = {\n    %d, {", kind, name[2],
            figure[order[i], "factor"]
        for (sea = 0; sea < SEAS; sea++)
            printf "%s%d", sea ? ", " : " ", figure[order[i], "sea" sea]
        print " }\n},)"
    }
}
END {
    if (to == "inc") {
        print_table()
        exit
    }
    for (i = 0; i < parts; i++) {
        m[0, i] = 1
        m[1, i] = i in OWN ? PRIOR_FAST : 1
    }
    for (own in mask) factor[own] = 0.7
    for (round = 0; round < 8; round++) {
        share_parts()
        fit_parts()
        fit_rungs()
    }
    print_rows()
}
