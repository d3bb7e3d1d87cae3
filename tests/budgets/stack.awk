# SPDX-License-Identifier: MIT
# The stack that the pieces of a program list need, from gcc -fcallgraph-info=su.
#
#   awk -v pointers=FILE -f tests/lib/callgraph.awk -f tests/budgets/stack.awk \
#       REACHED FILE.ci...
#
# REACHED has lines FILE(MEMBER) SECTION BYTES PIECE of code-sizes.sh.  A chain of calls
# belongs to a program that has one piece of each of its functions.  Prints lines
# BYTES,PIECE PIECE...&PIECE...: the deepest chain of every set of groups of pieces, unless
# a deeper one needs no more; in the first line no piece.  Calls through pointers go where
# tests/gates/pointers.txt says.

# A function's name in the linker's map: a static one with its file's, "tile:shade_row".
function map_name(name,    file)
{
    if (name !~ /:/)
        return name
    file = name
    sub(/:.*/, "", file)
    sub(/.*\//, "", file)
    sub(/\.c$/, "", file)
    sub(/.*:/, "", name)
    return file ":" name
}

function add_piece(name, piece)
{
    if (piece == "base")
        owner[name] = "base"
    else if (owner[name] != "base")
        owner[name] = owner[name] (owner[name] == "" ? "" : " ") piece
}

FNR == NR {
    if ($2 !~ /^\.text/)
        next
    name = $2
    sub(/^\.text\.(unlikely\.)?/, "", name)
    file = $1
    sub(/.*\(/, "", file)
    sub(/\.o.*/, "", file)
    add_piece(name, $4)
    if (file ":" name != name)
        add_piece(file ":" name, $4)
    next
}

/^node:/ {
    name = field("title")
    if (match($0, /[0-9]+ bytes \([a-z,]+\)/) && (map_name(name) in owner)) {
        split(substr($0, RSTART, RLENGTH), figure, " ")
        own[name] = figure[1] + 0
    }
}
function follow(from,    i, name)
{
    for (i = 1; i <= rules; i++)
        if (plain(from) ~ caller[i])
            for (name in own)
                if (plain(name) ~ callee[i])
                    calls[from, ++n_calls[from]] = name
}

# True if a program with a piece of group `a` has one of group `b`.
function implies(a, b,    piece, n, i)
{
    n = split(a, piece, " ")
    for (i = 1; i <= n; i++)
        if (index(" " b " ", " " piece[i] " ") == 0)
            return 0
    return 1
}
# True if a program with all groups of set `a` has all of set `b`.
function covers(a, b,    group, other, n, m, i, k)
{
    n = split(a, group, "&")
    m = split(b, other, "&")
    for (k = 1; k <= m; k++) {
        for (i = 1; i <= n && !implies(group[i], other[k]); i++);
        if (i > n)
            return 0
    }
    return 1
}
# The set with a group more, without groups that others imply, in order.
function with(set, more,    group, n, i, to, placed)
{
    if (more == "base" || covers(set, more))
        return set
    n = split(set, group, "&")
    to = ""
    for (i = 1; i <= n; i++) {
        if (implies(more, group[i]))
            continue
        if (!placed && more < group[i]) {
            to = to (to == "" ? "" : "&") more
            placed = 1
        }
        to = to (to == "" ? "" : "&") group[i]
    }
    return placed ? to : to (to == "" ? "" : "&") more
}

# Lists the chains below `name`: deepest[name, set], the sets in sets[name].
function list(name,    i, k, n, to, set, of, depth)
{
    if (name in listed)
        return
    listed[name]
    of = owner[map_name(name)]
    keep(name, with("", of), own[name])
    for (i = 1; i <= n_calls[name]; i++) {
        to = calls[name, i]
        if (!(to in own))
            continue
        list(to)
        n = n_sets[to]
        for (k = 1; k <= n; k++) {
            set = sets[to, k]
            keep(name, with(set, of), own[name] + deepest[to, set])
        }
    }
}
function keep(name, set, depth)
{
    if (!((name, set) in deepest))
        sets[name, ++n_sets[name]] = set
    if (depth > deepest[name, set] + 0)
        deepest[name, set] = depth
}

# True if programs with the pieces of `set` have a deeper chain, that of set `other`; of two
# equal ones the first by name.
function beats(other, set)
{
    return all[other] >= all[set] && covers(set, other) \
        && (all[other] > all[set] || !covers(other, set) || other < set)
}

END {
    for (name in points)
        follow(name)
    for (name in own) {
        list(name)
        for (k = 1; k <= n_sets[name]; k++) {
            set = sets[name, k]
            if (deepest[name, set] > all[set] + 0)
                all[set] = deepest[name, set]
        }
    }
    for (set in all) {
        beaten = 0
        for (other in all)
            if (other != set && beats(other, set)) {
                beaten = 1
                break
            }
        if (!beaten)
            print all[set] "," set
    }
}
