# SPDX-License-Identifier: MIT
# Fits the prices of rungs.
#     awk -v to=csv: from samples (rung-prices.sh), lines
#         bases|rungs|mixed|sets SCENE - - TICK FRAME SHADED RENDERER WATER
#             -[,KIND;RUNG;MASK]... PART... ; PREDICTED
#         mesh RUNG SAVED PART
#         error SCENE KIND RUNG SEA SHARE SQUARE
#       to rows kind,rung,figure,value.
#     awk -v to=inc: from those rows to the table of src/quality/rung_prices.inc
#     awk -v to=off: from samples to the deviations of the prices before, by scene
#
# 1. A factor for each part: the least squares of the relative errors of whole frames, drawn
#    to 1 where samples say little.  Samples more than NEAR off weigh less.  Parts of finding
#    the water have factors for each renderer, those of its pixels for each shading.
# 2. A factor for each rung: the share of its parts that stays, by least squares; 1 and 2 in
#    turn, since each needs the other.  Rows in between (quality.lines) also cost something
#    for each pixel of water.
#    A rung that no sample of an error shows has factor 0: not measured, never chosen.
# 3. An error for each rung and class of sea: the SHOWN part of all views have a smaller
#    mean square.  Scenes without the effect say nothing; a class without other scenes has
#    the error of all classes.  Zero only if no view shows a difference.
BEGIN {
    SHOWN = 0.92; SEAS = 12; sorted = "sort -t, -k1,1 -k2,2n -k3,3"
    NEAR = 0.08; WEIGHT = 0.004; SHADED_WEIGHT = 0.03; MOST = 4; ROUNDS = 20
    SEEN = 10; PIXELS = 30      # TP_PARTS_SEEN, TP_PARTS_OF_PIXELS of rung_sets.h
    CELLS = 2; EDGES = 3        # TP_PART_cells, TP_PART_edges
}

# -- samples ----------------------------------------------------------------------------

$1 ~ /^(bases|rungs|mixed|sets)$/ && to == "off" {
    for (i = NF; $i != ";"; i--) { }
    off = $(i + 1) / $6 - 1
    off = off < 0 ? -off : off
    for (i = 0; i < 2; i++) {
        who = i ? "all" : $2
        all[$1, who]++; sum[$1, who] += off; near[$1, who] += off <= 0.1
    }
}
to == "csv" && $1 ~ /^(bases|rungs|mixed|sets)$/ {
    at = ++samples
    frame[at] = $6
    kinds[at] = split($10, list, ",") - 1
    halvings = 0
    for (i = 1; i <= kinds[at]; i++) {
        split(list[i + 1], name, ";")
        own = name[1] ";" name[2]
        rung_of[at, i] = own
        mask[own] = name[3]
        if (name[1] == "grid.vertices" && $8 < 2) halvings = name[2]
        if (name[1] == "quality.lines") lines[at] = $9 / frame[at]
    }
    parts = NF - 12
    for (i = 0; i < parts; i++) {
        if (!$(11 + i)) continue
        n_of[at]++
        part_of[at, n_of[at]] = i
        key_of[at, n_of[at]] = (i < SEEN ? $8 : i < PIXELS ? $7 : 0) SUBSEP i
        keys[key_of[at, n_of[at]]]
        fewer = i == EDGES ? halvings / 2 : i >= CELLS && i < SEEN ? halvings : 0
        value[at, n_of[at]] = $(11 + i) / frame[at] * 0.5 ^ fewer
    }
}
to == "csv" && $1 == "mesh" {
    mesh[$2] = $3 < $4 ? int(256 - 256 * $3 / $4 + 0.5) : 1
}
to == "csv" && $1 == "error" {
    at = $3 ";" $4
    errors[at]
    if ($6 <= 0.002) next
    error_line[++error_lines] = at " " $5 " " ($7 > 0 ? $7 / $6 : 0) " " $2
    if ($7 > 0) shows[at, $2]
}

# -- fits -------------------------------------------------------------------------------

function in_mask(own, i) { return int(mask[own] / 2 ^ i) % 2 }

# Sets x[at, j]: the parts of each sample by its rungs, as shares of the counted frame, and
# of[key]: the samples with the factor.
function share_parts(    at, i, j, k, own) {
    for (own in mask)
        for (i = 0; i < parts; i++) changes[own, i] = in_mask(own, i)
    for (at = 1; at <= samples; at++)
        for (j = 1; j <= n_of[at]; j++) {
            x[at, j] = value[at, j]
            for (k = 1; k <= kinds[at]; k++)
                if (changes[rung_of[at, k], part_of[at, j]])
                    x[at, j] *= factor[rung_of[at, k]]
        }
}
# Sets left[at], the part of the frame that is not explained, and the weight of a sample.
function set_left(    at, j, off) {
    for (at = 1; at <= samples; at++) {
        left[at] = 1 - more * lines[at]
        for (j = 1; j <= n_of[at]; j++) left[at] -= x[at, j] * m[key_of[at, j]]
        off = left[at] < 0 ? -left[at] : left[at]
        weight[at] = off > NEAR ? NEAR / off : 1
    }
}
# Sets m[column, part] by coordinate descent.
function fit_parts(    key, name, n, j, at, upper, lower, prior, new, k) {
    for (k = 0; k < 6; k++)
        for (key in keys) {
            split(key, name, SUBSEP)
            prior = first(key) * first(key)
            prior = (name[2] >= SEEN && name[2] < PIXELS ? SHADED_WEIGHT : WEIGHT) / prior
            upper = prior * first(key); lower = prior
            for (n = 1; n <= uses[key]; n++) {
                at = use_at[key, n]; j = use_part[key, n]
                upper += weight[at] * x[at, j] * (left[at] + x[at, j] * m[key])
                lower += weight[at] * x[at, j] * x[at, j]
            }
            new = upper / lower
            if (new > MOST) new = MOST
            if (new < 0) new = 0
            for (n = 1; n <= uses[key]; n++)
                left[use_at[key, n]] -= x[use_at[key, n], use_part[key, n]] * (new - m[key])
            m[key] = new
        }
}
# Sets each rung's factor by least squares of the same shares, one rung after another, and
# what quality.lines costs more.
function fit_rungs(    own, n, j, at, inside, upper, lower, was, new) {
    for (own in mask) {
        upper = lower = 0.004
        was = factor[own]
        for (n = 1; n <= wears[own]; n++) {
            at = wear_at[own, n]
            inside = 0
            for (j = 1; j <= n_of[at]; j++)
                if (changes[own, part_of[at, j]]) inside += x[at, j] * m[key_of[at, j]] / was
            insides[n] = inside
            upper += weight[at] * (left[at] + inside * was) * inside
            lower += weight[at] * inside * inside
        }
        new = upper / lower
        if (new < 0.02) new = 0.02
        if (new > 1.2) new = 1.2
        factor[own] = new
        for (n = 1; n <= wears[own]; n++) {
            at = wear_at[own, n]
            left[at] -= insides[n] * (new - was)
            for (j = 1; j <= n_of[at]; j++)
                if (changes[own, part_of[at, j]]) x[at, j] *= new / was
        }
    }
    upper = lower = 1e-9
    for (at in lines) {
        upper += weight[at] * lines[at] * (left[at] + more * lines[at])
        lower += weight[at] * lines[at] * lines[at]
    }
    more = upper > 0 ? upper / lower : 0
}
# A factor before the samples: pixels of fast shading cost about a third.
function first(key,    name) {
    split(key, name, SUBSEP)
    return name[2] > SEEN && name[2] < PIXELS && name[1] ? 0.35 : 1
}
function fit(    key, own, at, j, k) {
    for (key in keys) m[key] = first(key)
    for (own in mask) factor[own] = 0.7
    for (at = 1; at <= samples; at++) {
        for (j = 1; j <= n_of[at]; j++) {
            key = key_of[at, j]
            use_at[key, ++uses[key]] = at
            use_part[key, uses[key]] = j
        }
        for (k = 1; k <= kinds[at]; k++) wear_at[rung_of[at, k], ++wears[rung_of[at, k]]] = at
    }
    for (round = 0; round < ROUNDS; round++) {
        share_parts()
        set_left()
        fit_parts()
        fit_rungs()
    }
}
function gather_errors(    i, field) {
    for (i = 1; i <= error_lines; i++) {
        split(error_line[i], field, " ")
        if (!((field[1], field[4]) in shows)) continue
        square[field[1], field[2], ++n[field[1], field[2]]] = field[3]
        square[field[1], "all", ++n[field[1], "all"]] = field[3]
    }
}
# Returns the mean square that the SHOWN part of the views keep, Q8, rounded up.
function quantile(at, sea,    i, j, k, most, list) {
    k = n[at, sea]
    for (i = 1; i <= k; i++) list[i] = square[at, sea, i]
    for (i = 2; i <= k; i++)
        for (j = i; j > 1 && list[j] < list[j - 1]; j--) {
            most = list[j]; list[j] = list[j - 1]; list[j - 1] = most
        }
    i = int(SHOWN * k + 0.999)
    most = 256 * list[i < 1 ? 1 : i > k ? k : i]
    return most > int(most) ? int(most) + 1 : most > 0 || list[k] <= 0 ? most : 1
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
    for (f = 0; f < 4; f++)
        for (i = 0; i < SEEN; i++)
            print "seen," f "," i "," q8((f, i) in m ? m[f, i] : 1) | \
                "sort -t, -k1,1r -k2,2n -k3,3n"
    for (f = 0; f < 3; f++)
        for (i = SEEN; i < parts; i++)
            print "part," f "," i "," \
                q8(m[i < PIXELS && (f, i) in m ? f : 0, i]) | "sort -t, -k1,1r -k2,2n -k3,3n"
    close("sort -t, -k1,1r -k2,2n -k3,3n")
    for (at in errors) {
        split(at, name, ";")
        f = !(at in factor) ? 256 : n[at, "all"] ? q8(factor[at]) : 0
        if (name[1] == "quality.mesh") f = mesh[name[2]]
        print name[1] "," name[2] ",factor," f | sorted
        print name[1] "," name[2] ",more," \
            (name[1] == "quality.lines" ? int(more + 0.5) : 0) | sorted
        for (sea = 0; sea < SEAS; sea++) {
            of = "all"
            if (n[at, sea] > 5) of = sea
            print name[1] "," name[2] ",sea" sea "," quantile(at, of) | sorted
        }
    }
}
function q8(x) { return int(256 * x + 0.5) }
function print_factors(word, kind, count, low, high,    i, j) {
    for (i = 0; i < count; i++) {
        printf "%s([%d] = {", word, i
        for (j = low; j < high; j++)
            printf "%s%d", j == low ? (low ? "\n    [" low "] = " : "\n    ") : \
                (j - low) % 12 ? ", " : ",\n    ", figure[kind SUBSEP i, j]
        print "\n},)"
    }
}
function print_table(    i, name, kind, sea) {
    print "/* SPDX-License-Identifier: MIT */"
    print "/* Made by tests/budgets/rung-prices.awk from rung-prices.csv; not to be edited. */"
    print_factors("SEEN", "seen", 4, 0, SEEN)
    print_factors("PARTS", "part", 3, SEEN, parts)
    for (i = 1; i <= rows; i++) {
        split(order[i], name, SUBSEP)
        kind = name[1]
        if (kind == "part" || kind == "seen") continue
        sub(/^quality\./, "", kind); sub(/^grid\./, "", kind); sub(/\./, "_", kind)
        if (kind ~ /^(visibility|shading|rate)$/) kind = toupper(kind)
        printf "RUNGS([TP_KIND_%s][%d] = {\n    %d, %d, {", kind, name[2],
            figure[order[i], "factor"], figure[order[i], "more"]
        for (sea = 0; sea < SEAS; sea++)
            printf "%s%d", sea ? ", " : " ", figure[order[i], "sea" sea]
        print " }\n},)"
    }
}
function print_deviations(    of, name) {
    for (of in all) {
        split(of, name, SUBSEP)
        printf "%s %s: %d of %d within 10 %%, mean %.1f %%\n", name[1], name[2], near[of],
            all[of], 100 * sum[of] / all[of] | "sort"
    }
}
END {
    if (to == "off") {
        print_deviations()
        exit
    }
    if (to == "inc") {
        print_table()
        exit
    }
    gather_errors()
    fit()
    print_rows()
}
