# SPDX-License-Identifier: MIT
# Converts the output of prices.c and the plugin's counts to rows of prices.csv.
#
#   awk -f tests/budgets/prices-count.awk SHADE SAID COUNTS
#
# SHADE lists the functions of src/shade. A figure is a difference of two pictures over
# the number of units in which they differ; figures of visibility are fitted to all views
# (predictions and counts go to the standard error). A rung that executes the same
# instructions as its substitute is not implemented yet, and has no rows.
FNR == 1 { file++ }
file == 1 { shades[$1]; next }
file == 2 && $1 == "run" {
    name = $2 " " $3 " " $4
    run[++runs] = name
    pixels[name] = $5
    water[name] = $6
    vertices[name] = $7
    waves[name] = $8
    next
}
file == 2 && $1 == "beside" {
    beside[name] = $2 == "-" ? "" : "work - " substr($2, 2)
    next
}
file == 2 && $1 == "work" {
    if (!($2 in item_at)) {
        item[++items] = $2
        item_at[$2] = items
    }
    work[name, item_at[$2]] = $3
    next
}
file == 3 && $1 == "count" && $2 <= runs {
    name = run[$2]
    cost[name] += $5
    if ($3 == "tiles")
        tiles[name] += $5
    if ($3 == "tiles" && $4 in shades)
        shading[name] += $5
}

function row(what, rung, item, figure)
{
    printf "%s,%s,%s,%.3f\n", what, rung, item, figure
}

# Extra cost of an item per vertex.
function more(item, near)
{
    sub(/near$/, "", near)
    return (cost[near item] - cost[near "near"]) / vertices[near "near"]
}

# Fits cost = pixel n + vertex P + wave W P to all views, with the least relative error and
# no coefficient below 0: coordinate descent, until no coefficient changes.
function fit(rung,    item, views, v, name, i, j, k, moved, rest, a, b, part, off)
{
    views = split("near dense small one low rough turned swell" \
                  (rung ~ /^tri/ ? " above gale" : ""), item, " ")
    for (v = 1; v <= views; v++) {
        name = "seen " rung " " item[v]
        rest = cost[name] - whole - sky * (pixels[name] - water[name]) - \
               plain * water[name]
        part[1] = water[name] / cost[name]
        part[2] = vertices[name] / cost[name]
        part[3] = part[2] * waves[name]
        for (i = 1; i <= 3; i++) {
            b[i] += part[i] * rest / cost[name]
            for (j = 1; j <= 3; j++)
                a[i, j] += part[i] * part[j]
        }
    }
    for (i = 1; i <= 3; i++)
        coefficient[i] = 0
    moved = 1
    for (k = 0; moved && k < 50000; k++) {
        moved = 0
        for (i = 1; i <= 3; i++) {
            off = b[i]
            for (j = 1; j <= 3; j++)
                off -= j == i ? 0 : a[i, j] * coefficient[j]
            off = off > 0 && a[i, i] > 0 ? off / a[i, i] : 0
            if (off > coefficient[i] + 1e-9 || off < coefficient[i] - 1e-9)
                moved = 1
            coefficient[i] = off
        }
    }
    for (v = 1; v <= views; v++) {
        name = "seen " rung " " item[v]
        rest = whole + sky * (pixels[name] - water[name]) + plain * water[name] + \
               coefficient[1] * water[name] + \
               (coefficient[2] + coefficient[3] * waves[name]) * vertices[name]
        printf "    %s: %.2f M predicted, %.2f M counted, %.2f\n", name, rest / 1e6, \
               cost[name] / 1e6, rest / cost[name] >"/dev/stderr"
    }
}

function seen(rung,    near)
{
    near = "seen " rung " near"
    fit(rung)
    if (rung == "triangles")
        off_pixel = coefficient[1]
    row("seen", rung, "pixel", coefficient[1])
    row("seen", rung, "vertex", coefficient[2])
    row("seen", rung, "wave", coefficient[3])
    row("seen", rung, "still", still(rung))
    if (rung !~ /^(triangles|rows)/)
        return                              # these renderers support only plain swells
    row("seen", rung, "sharp", more("sharp", near) / waves[near])
    row("seen", rung, "pool", more("pool", near))
    row("seen", rung, "coastal", more("coastal", near))
    row("seen", rung, "floor", more("floor", near))
    row("seen", rung, "map", more("map", near))
}

# Cost of a pixel of level water.
function still(rung,    name, points)
{
    name = "seen " rung " still"
    points = rung ~ /^(triangles|rows)/ ? vertices[name] : 0
    return (cost[name] - whole - sky * (pixels[name] - water[name]) - \
            coefficient[2] * points) / water[name] - plain
}

# Cost of a feature per pixel of water (or of the whole picture): the picture with the
# feature minus the picture without.
function part(rung, item, with, without, over,    a, b)
{
    a = "shaded " rung " " with
    b = "shaded " rung " " without
    row("shaded", rung, item, (cost[a] - cost[b]) / over)
}

function of(rung, item)
{
    return cost["shaded " rung " " item]
}

# Cost of the floor or walls below, without the part that belongs to `behind`.
function ground(rung, item, n)
{
    row("shaded", rung, item, (of(rung, item) - of(rung, item "0") - \
        of(rung, "behind") + of(rung, "mirror")) / n)
}

# `plain` is measured on lit water: the light has a cost of its own.
function shaded(rung,    n)
{
    n = water["shaded " rung " plain"]
    row("shaded", rung, "plain", \
        plain + (of(rung, "unlit") - of("exact.full", "plain")) / n)
    part(rung, "diffuse", "plain", "unlit", n)
    look = of(rung, "mirror") + of(rung, "glint") - of(rung, "both") - of(rung, "unlit")
    row("shaded", rung, "look", look / n)
    row("shaded", rung, "mirror", (of(rung, "both") - of(rung, "glint")) / n)
    row("shaded", rung, "glint", (of(rung, "both") - of(rung, "mirror")) / n)
    part(rung, "rough", "rough", "both", n)
    part(rung, "texture", "texture", "plain", n)
    part(rung, "linear", "linear", "texture", n)
    part(rung, "bend", "bend", "texture", n)
    part(rung, "layer", "layer", "texture", n)
    part(rung, "lined", "lined", "linear", 2 * n)
    part(rung, "ripple", "ripple", "plain", n)
    part(rung, "bump", "bump", "plain", n)
    part(rung, "haze", "haze", "plain", n)
    row("shaded", rung, "dome", (of(rung, "dome") - of(rung, "dome0") - \
        of(rung, "mirror1") + of(rung, "ripple")) / n)
    row("shaded", rung, "cube", (of(rung, "cube") - of(rung, "cube0") - \
        of(rung, "mirror1") + of(rung, "ripple")) / n)
    part(rung, "objects", "objects", "objects0", n)
    if (rung == "exact.full")
        objects = (of(rung, "objects") - of(rung, "objects0")) / n
    part(rung, "behind", "behind", "mirror", n)
    ground(rung, "bed", n)
    ground(rung, "chart", n)
    ground(rung, "tank", n)
    row("shaded", rung, "caustic", (tiles["shaded " rung " caustic"] - \
        tiles["shaded " rung " bed"]) / n)
    part(rung, "dispersion", "spread", "bed", n)
    part(rung, "foam", "foam", "plain", n)
    part(rung, "expose", "expose", "plain", pixels["shaded " rung " plain"])
}

# Pairs of pictures: the extra cost of the second picture over its extra amount of work;
# no figure is below 0. The costs of water pixels and sky pixels are known.
function works(    r, name, than, i, j, k, moved, off, sum, share, right, square, some, with)
{
    for (r = 1; r <= runs; r++) {
        name = run[r]
        if (name !~ /^work / || beside[name] == "")
            continue
        than = beside[name]
        left[name] = cost[name] - cost[than] - (water[name] - water[than]) * \
                     (off_pixel + plain - sky)
        if (name ~ / (lit|sunny)$/)         # the tiles' part belongs to the pixels
            left[name] -= tiles[name] - tiles[than]
        if (name ~ /_mirror$/)
            left[name] -= objects * water[name]
        for (i = 1; i <= items; i++) {
            share[i] = (work[name, i] - work[than, i]) / cost[name]
            right[i] += share[i] * left[name] / cost[name]
        }
        for (i = 1; i <= items; i++)
            for (j = 1; j <= items; j++)
                square[i, j] += share[i] * share[j]
    }
    for (i = 1; i <= items; i++)                # most items do not occur together
        for (j = 1; j <= items; j++)
            if (j != i && square[i, j])
                with[i, ++some[i]] = j
    moved = 1
    for (k = 0; moved && k < 20000; k++) {
        moved = 0
        for (i = 1; i <= items; i++) {
            off = right[i]
            for (j = 1; j <= some[i]; j++)
                off -= square[i, with[i, j]] * price[with[i, j]]
            off = square[i, i] > 0 && (off > 0 || item[i] ~ /^sky_/) ? \
                  off / square[i, i] : 0
            if (off > price[i] + 1e-9 || off < price[i] - 1e-9)
                moved = 1
            price[i] = off
        }
    }
    for (i = 1; i <= items; i++)
        row("work", "-", item[i], price[i])
    for (r = 1; r <= runs; r++) {
        name = run[r]
        if (!(name in left))
            continue
        sum = 0
        for (i = 1; i <= items; i++)
            sum += (work[name, i] - work[beside[name], i]) * price[i]
        printf "    %s: %.2f M more predicted, %.2f M counted, of %.2f M, %+.1f %%\n", \
               name, sum / 1e6, left[name] / 1e6, cost[name] / 1e6, \
               100 * (sum - left[name]) / cost[name] >"/dev/stderr"
    }
}

function there_seen(rung, than,    i, item)
{
    for (i = split("near dense small one pool coastal", item, " "); i > 0; i--)
        if (cost["seen " rung " " item[i]] != cost["seen " than " " item[i]])
            return 1
    return 0
}

function there_shaded(rung, than,    i, name)
{
    for (i = 1; i <= runs; i++)
        if (index(run[i], "shaded " rung " ") == 1) {
            name = substr(run[i], length("shaded " rung " ") + 1)
            if (of(rung, name) != of(than, name))
                return 1
        }
    return 0
}

END {
    if (!runs || !cost[run[runs]]) {
        print "nothing was counted" >"/dev/stderr"
        exit 1
    }
    sky = (cost["sky - large"] - cost["sky - small"]) / \
          (pixels["sky - large"] - pixels["sky - small"])
    whole = cost["sky - large"] - sky * pixels["sky - large"]
    plain = shading["seen triangles near"]
    # the pictures of the sky contain the sky's shading too
    plain = (plain - sky_shading()) / water["seen triangles near"]
    row("whole", "-", "frame", whole / 1000)
    row("whole", "-", "sky", sky)
    split("triangles rows projected flat", visibility, " ")
    for (v = 1; v <= 4; v++)
        if (v == 1 || there_seen(visibility[v], "triangles"))
            seen(visibility[v])
    split("exact quick", shade, " ")
    split("full layers colour", rate, " ")
    for (s = 1; s <= 2; s++)
        for (r = 1; r <= 3; r++) {
            rung = shade[s] "." rate[r]
            if (rung == "exact.full" || \
                (there_shaded(rung, "exact.full") && \
                 (r == 1 || there_shaded(rung, shade[s] ".full"))))
                shaded(rung)
        }
    works()
}

function sky_shading()
{
    return shading["sky - large"] / pixels["sky - large"] * \
           (pixels["seen triangles near"] - water["seen triangles near"])
}
