# SPDX-License-Identifier: MIT
# Arguments of TP_ASSERT must have no effect: a release leaves them out.
#
#   awk -f tests/gates/asserts.awk src/*/*
#
# Forbidden: assignments, ++ and --, and calls except of macros and of the functions named
# here, which change nothing. Prints the number of asserts per thousand lines of each
# folder and of the core. A core figure below `least` or above `most`, if given, is an
# error.
BEGIN {
    n = split("sizeof tp_abs tp_clz tp_screen_vertex_in_guard_band " \
              "tp_projection_can_project tp_pool_max_lsb tp_grid_is_coastal", name, " ")
    for (i = 1; i <= n; i++)
        pure[name[i]]
}

function folder_of(file,    part)
{
    split(file, part, "/")
    return part[2]
}

# Text within the parentheses of TP_ASSERT, or "" while they are open.
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
