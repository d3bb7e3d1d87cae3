# SPDX-License-Identifier: MIT
# The deepest stack of the core, from gcc -fcallgraph-info=su: no recursion, no frame of
# unknown size, and at most LIMIT bytes below any public function.
#
#   awk -v limit=BYTES -v pointers=FILE -f tests/lib/callgraph.awk \
#       -f tests/gates/stack.awk FILE.ci...
#
# FILE lists the functions that call through a pointer, and their targets; a call through
# an unlisted pointer is an error. Functions of the compiler's library have no figure;
# they are leaves with a few words of stack.

/^node:/ {
    name = field("title")
    label = field("label")
    if (match(label, /[0-9]+ bytes \([a-z,]+\)/)) {
        usage = substr(label, RSTART, RLENGTH)
        split(usage, figure, " ")
        own[name] = figure[1] + 0
        if (usage ~ /\(dynamic\)/) {
            print name ": stack of unknown size"
            bad = 1
        }
    }
}

# Adds the calls of `from` through pointers, by the rules.
function follow(from,    i, name, found)
{
    for (i = 1; i <= rules; i++)
        if (plain(from) ~ caller[i])
            for (name in own)
                if (plain(name) ~ callee[i]) {
                    calls[from, ++n_calls[from]] = name
                    found = 1
                }
    if (!found) {
        print from ": calls through a pointer, to whom is not known"
        bad = 1
    }
}

# Depth of the stack from `name` down; `path` is the chain of callers.
function depth(name, path,    i, deepest, d, to)
{
    if (index(path, " " name " ")) {
        print "recursion:" path name
        bad = 1
        return 0
    }
    if (name in known)
        return known[name]
    deepest = 0
    for (i = 1; i <= n_calls[name]; i++) {
        to = calls[name, i]
        d = depth(to, path name " ")
        if (d > deepest) {
            deepest = d
            below[name] = to
        }
    }
    return known[name] = deepest + own[name]
}

END {
    for (name in points)
        follow(name)
    for (name in own) {
        d = depth(name, " ")
        if (d > worst) {
            worst = d
            top = name
        }
    }
    for (name = top; name != ""; name = below[name])
        chain = chain " " name "(" own[name] + 0 ")"
    print "deepest stack: " worst + 0 " bytes," chain
    if (worst > limit) {
        print "more than " limit
        bad = 1
    }
    exit bad || !worst
}
