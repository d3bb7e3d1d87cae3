# SPDX-License-Identifier: MIT
# Checks and writes budgets; read after tests/gates/lib.sh. The figures are the lines of
# $scratch/figures; $whole is 1 if all names must be present, $skip names measures that
# are not compared. budgets.awk has the rule.

budgets_by()    # BUDGETS [VARIABLE]...
{
    of=$1
    shift
    awk -v whole="$whole" -v skip="$skip" "$@" -f tests/budgets/budgets.awk "$of" \
        "$scratch/figures"
}

# Checks a budget, and that budgets can fail: with budgets lowered by 2 % some must fail.
hold()          # BUDGETS
{
    awk -F, -v OFS=, '$3 ~ /^[0-9]/ { $3 /= 1.02 } { print }' "$1" >"$scratch/lower"
    refuse "budgets of 2 % less are missed" budgets_by "$scratch/lower"
    budgets_by "$1" || failures=$((failures + 1))
}

rewrite()       # BUDGETS BUILD=COMPILER...
{
    of=$1
    budgets_by "$of" -v write=1 >"$scratch/budgets" || return 1
    shift
    for by; do
        sed -i "s/^\(# compiler ${by%%=*} .*\) .*/\1 $("${by#*=}" -dumpfullversion)/" \
            "$scratch/budgets"
    done
    cp "$scratch/budgets" "$of"
}

# pinned BUDGETS BUILD COMPILER: true if the compiler has the version that made the
# budgets; other versions are skipped.
pinned()
{
    want=$(sed -n "s/^# compiler $2 //p" "$1")
    here="${want% *} $("$3" -dumpfullversion)"
    [ "$here" = "$want" ] && return
    echo "skipped: budgets of $want, here $here (package ${want% *})"
    return 1
}
