# SPDX-License-Identifier: MIT
# Budgets: exact figures, and the rule for comparing them.
#
#   awk [-v whole=1] [-v write=1] [-v skip="MEASURE..."] \
#       -f tests/budgets/budgets.awk BUDGETS.csv FIGURES
#
# BUDGETS.csv has rows NAME,MEASURE,FIGURE,GOAL; FIGURES has lines "figure NAME MEASURE
# VALUE", other lines are ignored. A figure may exceed its row by at most 1 %. A measure
# with a dot is a part of `instructions`: it fails only if it also grows by 0.1 % of
# `instructions`; a part without a row counts as 0. `whole`: all names of the budgets must
# be present. `skip`: measures of another compiler. A GOAL is the aim for a figure.
#
# With write=1 prints new budgets: counted names with their new figures and their goals,
# other names with their old figures, or not at all with `whole`.
BEGIN { FS = "," }

FILENAME == ARGV[1] {
    if (NF < 3 || $1 == "name") {
        head = head $0 "\n"
        next
    }
    old_name[++olds] = $1
    old_measure[olds] = $2
    old[$1, $2] = $3
    goal[$1, $2] = $4
    known[$1]
    next
}
/^figure / {
    split($0, word, " ")
    if (!((word[2], word[3]) in now)) {
        new_name[++news] = word[2]
        new_measure[news] = word[3]
    }
    now[word[2], word[3]] = word[4]
    seen[word[2]]
}

function wrong(why)
{
    print "FAILED - " why
    failures++
}

function hold(name, measure,    figure, budget, part)
{
    if (index(" " skip " ", " " measure " "))
        return
    part = index(measure, ".") > 0
    if (!((name, measure) in old) && !part) {
        wrong(name " " measure ": " now[name, measure] ", without a budget")
        return
    }
    held++
    figure = now[name, measure] + 0
    budget = old[name, measure] + 0
    if (figure <= budget * 1.01) {
        lower += figure < budget * 0.99
        return
    }
    if (!part || figure - budget > now[name, "instructions"] / 1000)
        wrong(sprintf("%s %s: %s, budget %s, %s", name, measure, now[name, measure], \
            budget, budget ? sprintf("+%.1f %%", 100 * figure / budget - 100) : "new"))
}

function tell_goals(    i, name, measure)
{
    for (i = 1; i <= news; i++) {
        name = new_name[i]
        measure = new_measure[i]
        if (goal[name, measure] != "")
            printf "%s: %s %s %s, goal %s\n", \
                now[name, measure] + 0 <= goal[name, measure] + 0 ? "met" : "MISSED", \
                name, measure, now[name, measure], goal[name, measure]
    }
}

function print_row(name, measure, figure)
{
    print name "," measure "," figure "," goal[name, measure]
}

# Prints all rows of a name, once.
function print_name(name,    i)
{
    for (i = 1; i <= news && (name in seen) && !(name in printed); i++)
        if (new_name[i] == name)
            print_row(name, new_measure[i], now[name, new_measure[i]])
    printed[name]
}

# Names keep their order.
function print_budgets(    i)
{
    printf "%s", head
    for (i = 1; i <= olds; i++)
        if (old_name[i] in seen)
            print_name(old_name[i])
        else if (!whole)
            print_row(old_name[i], old_measure[i], old[old_name[i], old_measure[i]])
    for (i = 1; i <= news; i++)
        print_name(new_name[i])
}

END {
    if (!news) {
        print "FAILED - nothing was counted"
        exit 1
    }
    if (write) {
        print_budgets()
        exit 0
    }
    tell_goals()
    for (i = 1; i <= news; i++)
        hold(new_name[i], new_measure[i])
    for (name in known)
        if (whole && !(name in seen))
            wrong(name " has a budget, but is not counted")
    if (lower)
        print lower " of the figures are lower by 1 % or more: --write holds them"
    if (!failures)
        print "ok - " held " figures within 1 % of their budgets"
    exit failures > 0
}
