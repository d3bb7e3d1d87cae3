# SPDX-License-Identifier: MIT
# Reads the call graphs of gcc -fcallgraph-info=su, for stack.awk of gates and of budgets:
# calls[from, i], n_calls[from], and in points[from] callers through pointers.
#
# pointers=FILE lists functions that call through a pointer, and their targets: two columns of
# patterns, caller[i] and callee[i], `rules` of them.
BEGIN {
    while ((getline line < pointers) > 0)
        if (line !~ /^#/ && split(line, column, " ") == 2) {
            caller[++rules] = "^(" column[1] ")$"
            callee[rules] = "^(" column[2] ")$"
        }
}

# Plain name: "src/frame/tile.c:shade_row.isra.0" is shade_row.
function plain(name)
{
    sub(/.*:/, "", name)
    sub(/\..*/, "", name)
    return name
}

function field(key,    s)
{
    if (!match($0, key ": \"[^\"]*\""))
        return ""
    s = substr($0, RSTART, RLENGTH)
    sub(/^[^"]*"/, "", s)
    sub(/"$/, "", s)
    return s
}

/^edge:/ {
    from = field("sourcename")
    to = field("targetname")
    if (to == "__indirect_call")
        points[from]
    else
        calls[from, ++n_calls[from]] = to
}
