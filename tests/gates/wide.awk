# SPDX-License-Identifier: MIT
# Finds loops of a list that a compiler's report does not call vectorised.
#
#   awk -f tests/gates/wide.awk LIST SOURCE... report=1 REPORT...
#
# A loop counts as wide if the report has its line as vectorised by vectors of 32 bytes
# (gcc -fopt-info-vec-optimized-missed) or for four samples or more (clang
# -Rpass=loop-vectorize -Rpass-missed=loop-vectorize), and never as not vectorised: a
# function that is compiled into several stages has a report for each. Loops for cores with
# packed arithmetic, between #if TP_DSP and #endif, do not count.
function wrong(why)
{
    print why
    bad = 1
}

FNR == 1 { files++; function_name = "" }
files == 1 {
    if ($0 !~ /^#/ && NF) { wanted[$2, $3] = $1; loops[$2, $3] = 0 }
    next
}

# Definitions start in the first column, as do the braces around a function's body.
!report && /^[A-Za-z].*\(/ && !/;$/ {
    head = $0
    sub(/\(.*/, "", head)
    sub(/.*[ *]/, "", head)
    function_name = head
}
!report && /^}/ { function_name = "" }
!report && /^#if TP_DSP/ { packed = 1 }
!report && /^#endif/ { packed = 0 }
!report && !packed && (FILENAME, function_name) in wanted && /^ +for \(/ {
    at[FILENAME ":" FNR] = FILENAME SUBSEP function_name
    loops[FILENAME, function_name]++
}
!report { next }

{
    split($0, part, ":")
    place = part[1] ":" part[2]
    if (!(place in at))
        next
}
/optimized: loop vectorized using 32 byte vectors/ { wide[place]++ }
match($0, /vectorized loop \(vectorization width: [0-9]+/) {
    width = substr($0, RSTART, RLENGTH)
    sub(/.* /, "", width)
    if (width >= 4) wide[place]++
    else narrow[place]++
}
/missed: couldn't vectorize loop/ || /remark: loop not vectorized \[/ { narrow[place]++ }

END {
    for (key in loops) {
        split(key, of, SUBSEP)
        if (!loops[key])
            wrong(of[1] ": no loop in a function " of[2])
    }
    for (place in at) {
        split(at[place], of, SUBSEP)
        if (narrow[place] || !wide[place])
            wrong(place ": the loop of " of[2] " (" wanted[of[1], of[2]] ") is wide in " \
                  wide[place] + 0 " copies, not in " narrow[place] + 0)
    }
    exit bad
}
