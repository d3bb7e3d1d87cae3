# SPDX-License-Identifier: MIT
# Converts the output of errors.c to rows of prices.csv: for each rung and class of water
# the worst of its scenes; a class without scenes takes the figure of the next class with
# scenes.
#
#   awk -f tests/budgets/prices-error.awk COSTS SAID
#
# A rung without a cost is not implemented yet.
FNR == 1 { file++ }
file == 1 {
    split($0, field, ",")
    for (i = split(field[2], part, "."); i > 0; i--)
        there[part[i]]
    next
}
$1 == "error" && !($2 in there) { next }
$1 == "error" {
    if (!($2 in seen))
        rung[++rungs] = $2
    seen[$2]
    px[$2, $3] = most(px[$2, $3], $4, told[$2, $3])
    colour[$2, $3] = most(colour[$2, $3], $5, told[$2, $3])
    told[$2, $3] = 1
    next
}
$1 == "slope" { slope = slope > $2 + 0 ? slope : $2 + 0 }

function most(a, b, known)
{
    return known && a > b + 0 ? a : b + 0
}

END {
    if (!rungs) {
        print "no error was measured" >"/dev/stderr"
        exit 1
    }
    printf "whole,-,slope_colour,%.3f\n", slope
    n = split("level level_glossy level_sparks gentle gentle_glossy gentle_sparks " \
              "steep steep_glossy steep_sparks coastal coastal_glossy coastal_sparks",
              class, " ")
    for (i = 1; i <= rungs; i++)
        for (k = 1; k <= n; k++) {
            for (from = k; from <= n && !((rung[i], class[from]) in told); from++)
                continue
            if (from > n)
                continue
            printf "error,%s,%s.px,%.4f\n", rung[i], class[k], px[rung[i], class[from]]
            printf "error,%s,%s.colour,%.4f\n", rung[i], class[k], \
                colour[rung[i], class[from]]
        }
}
