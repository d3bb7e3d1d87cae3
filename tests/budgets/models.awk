# SPDX-License-Identifier: MIT
# What the models cost, as a table for people, and their budgets held.
#
#   awk -f tests/budgets/models.awk models.txt build=o2 SAID COUNTS build=m4 SAID COUNTS
#
# A build's figure is the sum of a section's functions over the units that the program
# said; the counting program's own functions are left out.  Bytes are the same in all
# builds, or that is a failure.  `write=1` prints the figures' ceilings instead, a tenth
# above each.  `held` lists the builds whose ceilings count: others' compilers differ.
BEGIN {
    split("o2 o3 v3 m4", column, " ")
    title["o2"] = "x86 -O2"
    title["o3"] = "x86 -O3"
    title["v3"] = "x86-v3 -O3"
    title["m4"] = "M4 -O2"
    build = ""
}

FNR == 1 { sections = 0 }

# -- budgets ---------------------------------------------------------------------------
build == "" && NF != 6 { head = head $0 "\n" }
build == "" && /^#/ { next }
build == "" && $1 == "goal" {
    goals++
    goal_model[goals] = $2
    goal_build[goals] = $3
    goal_most[goals] = $4
    next
}
build == "" && NF == 6 {
    budgeted[$1]
    for (k = 1; k <= 4; k++)
        ceiling[$1, column[k]] = $(k + 1)
    bytes_most[$1] = $6
    next
}
build == "" { next }

# -- figures ---------------------------------------------------------------------------
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
    seen[build]
}
$1 == "count" && $4 !~ /^(counted|model)_/ { insns[build, $2] += $5 }

function wrong(why)
{
    failed[++failures] = why
}

# A ceiling: a tenth more, but no more than a goal that has been met.
function raised(name, build,    g, x, most)
{
    x = figure[name, build]
    most = x < 100 ? sprintf("%.1f", x * 1.1 + 0.05) : sprintf("%d", x * 1.1 + 1)
    for (g = 1; g <= goals; g++)
        if (goal_model[g] == name && goal_build[g] == build && x <= goal_most[g] &&
            most > goal_most[g] + 0)
            most = goal_most[g]
    return most
}

function cell(name, build)
{
    return (name, build) in figure ? sprintf("%.1f", figure[name, build]) : "-"
}

# What the goals say of a model, to stand behind its row.
function marks(name,    g, text, value)
{
    for (g = 1; g <= goals; g++) {
        if (goal_model[g] != name || !((name, goal_build[g]) in figure))
            continue
        value = figure[name, goal_build[g]]
        text = text sprintf("  %s: %.1f of %s on %s", \
            value <= goal_most[g] ? "met" : "MISSED", value, goal_most[g], \
            title[goal_build[g]])
    }
    return text
}

function hold(name, build)
{
    if (!((name, build) in figure) || !index(" " held " ", " " build " "))
        return
    if (figure[name, build] > ceiling[name, build])
        wrong(sprintf("%s on %s: %.2f a %s, budget %s", name, title[build], \
            figure[name, build], unit[name], ceiling[name, build]))
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
        printf "%8s%s%s\n", bytes[name] ? bytes[name] : "-", \
            bytes[name] ? " " each[name] : "", marks(name)
    }
}

function budgets(    i, k, name)
{
    printf "%s", head
    for (i = 1; i <= models; i++) {
        name = order[i]
        printf "%-20s", name
        for (k = 1; k <= 4; k++)
            printf " %9s", (name, column[k]) in figure \
                ? raised(name, column[k]) : ceiling[name, column[k]]
        printf " %7d\n", bytes[name] + int(bytes[name] / 10)
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
    if (write) {
        budgets()
        exit 0
    }
    table()
    for (i = 1; i <= models; i++) {
        name = order[i]
        if (!(name in budgeted)) {
            wrong(name " has no budget")
            continue
        }
        for (k = 1; k <= 4; k++)
            hold(name, column[k])
        if (bytes[name] > bytes_most[name])
            wrong(name ": " bytes[name] " bytes, budget " bytes_most[name])
    }
    for (name in budgeted)
        if (!(name in unit))
            wrong(name " has a budget, but is not counted")
    print ""
    for (i = 1; i <= failures; i++)
        print "FAILED - " failed[i]
    if (!failures)
        printf "ok - %d models within their budgets\n", models
    exit failures > 0
}
