# SPDX-License-Identifier: MIT
# Converts the cost table from CSV to C, one initializer a row.
#
#   awk -f tests/budgets/prices.awk assets/charts/prices.csv >src/quality/prices.inc
#
# Rows: what,rung,item,figure. The plan has the exact rows of shading alone.
BEGIN {
    FS = ","
    n["visibility"] = split("triangles rows projected flat", visibility, " ")
    index_of(visibility, n["visibility"])
    print "/* SPDX-License-Identifier: MIT */"
    print "/* Made by tests/budgets/prices.awk from assets/charts/prices.csv; not to be edited. */"
}

function index_of(names, count,    i)
{
    for (i = 1; i <= count; i++)
        at[names[i]] = i - 1
}

# "quick.colour" as [1][2]; an unknown word ends the program.
function places(text,    part, count, i, made)
{
    count = split(text, part, ".")
    for (i = 1; i <= count; i++) {
        if (!(part[i] in at))
            wrong("no rung " part[i])
        made = made "[" at[part[i]] "]"
    }
    return made
}

function wrong(why)
{
    print FILENAME ":" FNR ": " why >"/dev/stderr"
    failed = 1
    exit 1
}

/^#/ || /^what,/ { next }
NF != 4 || $4 !~ /^-?[0-9]+(\.[0-9]+)?$/ { wrong("expected what,rung,item,figure") }
$1 == "whole" { printf "    .%s = TP_FX(%s),\n", $3, $4; next }
$1 == "work" { printf "    .work[TP_WORK_%s] = TP_FX(%s),\n", $3, $4; next }
$1 == "seen" {
    path = ".seen" places($2)
    printf "    %s.%s = TP_FX(%s),\n", path, $3, $4
    next
}
$1 == "shaded" && $2 == "exact.full" {
    printf "    .shaded[TP_TRAIT_%s] = TP_FX(%s),\n", $3, $4
    next
}
$1 == "shaded" { next }         # for the chart
{ wrong("no price of " $1) }
