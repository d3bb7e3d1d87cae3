# SPDX-License-Identifier: MIT
# The deepest stack of the core, from gcc -fcallgraph-info=su: no recursion, no frame of
# a size not known before, and no more than LIMIT bytes from any public function down.
#
#   awk -v limit=BYTES -f tests/gates/stack.awk FILE.ci...
#
# A call through a pointer is taken as one to any function that nobody calls by name and
# that is not public: among those are all that a table can hold.  Functions of the
# compiler's library have no figure; they are leaves of a few words.
function field(key,    s)
{
    if (!match($0, key ": \"[^\"]*\""))
        return ""
    s = substr($0, RSTART, RLENGTH)
    sub(/^[^"]*"/, "", s)
    sub(/"$/, "", s)
    return s
}

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

/^edge:/ {
    from = field("sourcename")
    to = field("targetname")
    calls[from, ++n_calls[from]] = to
    called[to]
}

# Depth of the stack below and with `name`; `path` is the chain of callers.
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
    pointer = "__indirect_call"
    for (name in own)
        if (name ~ /:/ && !(name in called))
            calls[pointer, ++n_calls[pointer]] = name
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
