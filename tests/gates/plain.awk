# SPDX-License-Identifier: MIT
# Plain words: no comment opens with Of, What, Whether, How, Which, Where, That, Whose, Who,
# and no function's name ends in a preposition.
#
#   awk -f tests/gates/plain.awk FILE...
#
# Comments: /* */ and // in C, C++, assembly, linker scripts, CSS and JavaScript; # in
# shell, awk and makefiles, on lines of their own or behind two blanks.  Lines of // or #
# that follow each other are one comment; only its first words count.  Strings are skipped.
# Functions: declared or defined at the start of a line, in C, C++ and JavaScript.
BEGIN {
    opening = "^(Of|What|Whether|How|Which|Where|That|Whose|Whom|Who)([^A-Za-z0-9_]|$)"
    n = split("of at to in on by for from with over under into between behind before " \
              "after around inside beyond above below along across through off out up " \
              "down", word, " ")
    for (i = 1; i <= n; i++)
        preposition[word[i]]
    split("if for while switch return sizeof main", word, " ")
    for (i in word)
        keyword[word[i]]
}

function wrong(why, text)
{
    printf "%s:%d: %s: %s\n", FILENAME, FNR, why, substr(text, 1, 60)
    bad = 1
}

# The words of a comment, from its start on: a comment waits until its first word is seen.
function open_comment(text)
{
    sub(/^[ \t*#\/-]+/, "", text)
    if (text ~ /^SPDX-/ || text !~ /[A-Za-z]/)
        return
    waiting = 0
    if (text ~ opening)
        wrong("a comment opens with " substr(text, 1, match(text, /[^A-Za-z]|$/) - 1), text)
}

# Comments of one line in a language with /* */ and //.
function read_slashes(line,     at, end, own)
{
    own = line ~ /^[ \t]*\/\//
    while (line != "") {
        if (within) {
            end = index(line, "*/")
            if (waiting)
                open_comment(end ? substr(line, 1, end - 1) : line)
            line = end ? substr(line, end + 2) : ""
            within = !end
            waiting = waiting && within
        } else {
            at = match(line, /["'`]|\/[*]|\/\//)
            if (!at)
                break
            line = substr(line, at)
            if (substr(line, 1, 2) == "/*") {
                within = waiting = 1
                line = substr(line, 3)
            } else if (substr(line, 1, 2) == "//") {
                if (!own || !slashed)
                    waiting = 1
                if (waiting)
                    open_comment(line)
                line = ""
            } else if (match(line, /^("([^"\\]|\\.)*"|'([^'\\]|\\.)*'|`([^`\\]|\\.)*`)/))
                line = substr(line, RLENGTH + 1)
            else
                line = substr(line, 2)
        }
    }
    slashed = own
}

# Comments of one line in a language with #.
function read_hashes(line)
{
    if (line ~ /^[ \t]*#/) {
        if (!hashed)
            waiting = 1
        if (waiting && line !~ /^#!/)
            open_comment(line)
        hashed = 1
        return
    }
    hashed = 0
    if (match(line, /[ \t][ \t]+# /))
        open_comment(substr(line, RSTART + RLENGTH - 2))
}

function read_function(line,    name, last)
{
    if (line !~ /^[A-Za-z_][A-Za-z0-9_ ]*[ *]+[a-z_][A-Za-z0-9_]*[ \t]*\(/)
        return
    name = line
    sub(/[ \t]*\(.*/, "", name)
    sub(/.*[ *]/, "", name)
    last = name
    sub(/.*_/, "", last)
    if (!(name in keyword) && last != name && last in preposition)
        wrong("a function's name ends in a preposition", name)
}

FNR == 1 { within = waiting = slashed = hashed = 0 }

FILENAME ~ /\.(sh|awk|mk)$/ || FILENAME ~ /Makefile$/ { read_hashes($0); next }

{
    if (!within && FILENAME ~ /\.(c|h|cpp|js)$/)
        read_function($0)
    read_slashes($0)
}

END { exit bad }
