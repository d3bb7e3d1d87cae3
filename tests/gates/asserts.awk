# SPDX-License-Identifier: MIT
# What TP_ASSERT is given has no effect: a release leaves it out.
#
#   awk -f tests/gates/asserts.awk src/*/*
#
# No assignment, no ++ and --, and no call but of macros and of the functions named here,
# which change nothing.  Prints how many asserts a folder has in a thousand lines, then
# the core: fewer than `least` or more than `most` of the core are wrong, if those are
# given.
BEGIN {
    n = split("sizeof tp_abs tp_clz tp_corner_fits tp_lens_holds tp_pool_full " \
              "tp_sheet_is", name, " ")
    for (i = 1; i <= n; i++)
        pure[name[i]]
}

function folder_of(file,    part)
{
    split(file, part, "/")
    return part[2]
}

# What is within the parentheses that TP_ASSERT opens, or "" while they are open.
function within(text,    from, i, c, depth)
{
    from = index(text, "TP_ASSERT(") + 10
    depth = 1
    for (i = from; i <= length(text); i++) {
        c = substr(text, i, 1)
        depth += (c == "(") - (c == ")")
        if (depth == 0)
            return substr(text, from, i - from)
    }
    return ""
}

function wrong(why)
{
    printf "%s:%d: %s: %s\n", FILENAME, FNR, why, given
    bad = 1
}

function look(text,    rest, call)
{
    if (text ~ /\+\+|--/)
        wrong("a step in an assert")
    gsub(/[=!<>]=/, " ", text)
    if (text ~ /=/)
        wrong("an assignment in an assert")
    for (rest = text; match(rest, /[A-Za-z_][A-Za-z_0-9]*\(/); ) {
        call = substr(rest, RSTART, RLENGTH - 1)
        rest = substr(rest, RSTART + RLENGTH)
        if (call ~ /[a-z]/ && !(call in pure))
            wrong("a call of " call " in an assert")
    }
}

{ folder = folder_of(FILENAME); lines[folder]++ }
/^[ \t]*(#|\/\*|\* )/ { next }                 # macros and comments
/TP_ASSERT\(/ { open = 1; text = ""; asserts[folder]++ }
open {
    text = text $0
    given = within(text)
    if (given != "") {
        look(given)
        open = 0
    }
}

END {
    for (folder in lines) {
        all += lines[folder]
        set += asserts[folder]
        printf "%-8s %4d asserts in %5d lines, %4.1f in a thousand\n", folder,
            asserts[folder], lines[folder], asserts[folder] * 1000 / lines[folder]
    }
    printf "%-8s %4d asserts in %5d lines, %4.1f in a thousand\n", "core", set, all,
        set * 1000 / all
    exit bad || (least && set * 1000 < least * all) || (most && set * 1000 > most * all)
}
