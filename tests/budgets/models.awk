# SPDX-License-Identifier: MIT
# Cost of the models, as a readable table and as figures for budgets.awk.
#
#   awk -f tests/budgets/models.awk build=o2 SAID COUNTS build=m4 SAID COUNTS
#
# A build's figure is the sum of a section's functions over the number of units that the
# program printed; the counting program's own functions do not count. Bytes must be equal
# in all builds.
BEGIN {
    split("o2 o3 v3 m4", column, " ")
    title["o2"] = "x86 -O2"
    title["o3"] = "x86 -O3"
    title["v3"] = "x86-v3 -O3"
    title["m4"] = "M4 -O2"
}

FNR == 1 { sections = 0 }

$1 == "model" {
    name = $2
    if (!(name in unit)) {
        order[++models] = name
        unit[name] = $3
        bytes[name] = $7
        each[name] = $8 (NF > 8 ? " " $9 : "")
    } else if (bytes[name] != $7)
        wrong(name " takes " bytes[name] " bytes, and " $7 " in " title[build])
    model_of[build, ++sections] = name
    units[build, name] = $5
}
$1 == "count" && $4 !~ /^(counted|model)_/ { insns[build, $2] += $5 }

function wrong(why)
{
    print "FAILED - " why
    failures++
}

function cell(name, build)
{
    return (name, build) in figure ? sprintf("%.1f", figure[name, build]) : "-"
}

function table(    i, k, name)
{
    printf "\n%-20s %-7s", "instructions", "unit"
    for (k = 1; k <= 4; k++)
        printf " %10s", title[column[k]]
    printf "   bytes\n"
    for (i = 1; i <= models; i++) {
        name = order[i]
        printf "%-20s %-7s", name, unit[name]
        for (k = 1; k <= 4; k++)
            printf " %10s", cell(name, column[k])
        printf "%8s%s\n", bytes[name] ? bytes[name] : "-", \
            bytes[name] ? " " each[name] : ""
    }
}

function print_figures(    i, k, name)
{
    for (i = 1; i <= models; i++) {
        name = order[i]
        for (k = 1; k <= 4; k++)
            if ((name, column[k]) in figure)
                printf "figure %s %s %.2f\n", name, column[k], figure[name, column[k]]
        print "figure " name " bytes " bytes[name]
    }
}

END {
    for (key in model_of) {
        split(key, part, SUBSEP)
        name = model_of[key]
        figure[name, part[1]] = insns[key] / units[part[1], name]
        if (!insns[key])
            wrong(name " on " title[part[1]] ": nothing was counted")
    }
    table()
    print_figures()
    exit failures > 0
}
