# SPDX-License-Identifier: MIT
# Lists the mutants of C files, one a line, separated by tabs:
#     FILE LINE COLUMN LENGTH OPERATOR NEW
# NEW replaces the text at COLUMN with LENGTH. Operators:
#     sum       + and - exchanged
#     product   * and / exchanged
#     bound     < and <=, > and >=, == and != exchanged
#     logic     && and || exchanged
#     constant  an integer plus or minus one
#     delete    an assignment or a call left out
#     negate    the condition of an if inverted
# Comments, strings, preprocessor lines and assertions have no mutants. Blanks around an
# operator distinguish binary from unary operators.

function site(column, length_, operator, new) {
    print FILENAME "\t" FNR "\t" column "\t" length_ "\t" operator "\t" new
}

# The line with comments, strings and characters blanked; `inside`: within a comment.
function bare_of(line,    out, c, two, i, quote) {
    out = ""
    quote = ""
    for (i = 1; i <= length(line); i++) {
        c = substr(line, i, 1)
        two = substr(line, i, 2)
        if (inside) {
            if (two == "*/") { inside = 0; out = out " "; i++ }
            out = out " "
        } else if (quote != "") {
            if (c == "\\") { out = out " "; i++ }
            else if (c == quote) quote = ""
            out = out " "
        } else if (two == "/*") {
            inside = 1
            out = out "  "
            i++
        } else if (c == "\"" || c == "'") {
            quote = c
            out = out " "
        } else {
            out = out c
        }
    }
    return out
}

function operators(bare,    i, text) {
    for (i = 2; i < length(bare); i++) {
        text = substr(bare, i - 1, 3)
        if (text == " + ") site(i, 1, "sum", "-")
        if (text == " - ") site(i, 1, "sum", "+")
        if (text == " * ") site(i, 1, "product", "/")
        if (text == " / ") site(i, 1, "product", "*")
        if (text == " < ") site(i, 1, "bound", "<=")
        if (text == " > ") site(i, 1, "bound", ">=")
        text = substr(bare, i - 1, 4)
        if (text == " += ") site(i, 2, "sum", "-=")
        if (text == " -= ") site(i, 2, "sum", "+=")
        if (text == " <= ") site(i, 2, "bound", "<")
        if (text == " >= ") site(i, 2, "bound", ">")
        if (text == " == ") site(i, 2, "bound", "!=")
        if (text == " != ") site(i, 2, "bound", "==")
        if (text == " && ") site(i, 2, "logic", "||")
        if (text == " || ") site(i, 2, "logic", "&&")
    }
}

function constants(bare,    at, rest, number, before) {
    rest = bare
    at = 0
    while (match(rest, /[0-9][0-9A-Za-z_.]*/)) {
        number = substr(rest, RSTART, RLENGTH)
        before = substr(bare, at + RSTART - 1, 1)
        if (before !~ /[A-Za-z0-9_.]/ && number ~ /^[0-9]+$/ && length(number) < 10) {
            site(at + RSTART, RLENGTH, "constant", number + 1)
            if (number > 0)
                site(at + RSTART, RLENGTH, "constant", number - 1)
        }
        at += RSTART + RLENGTH - 1
        rest = substr(rest, RSTART + RLENGTH)
    }
}

# True if the text's brackets close as often as they open, and never before.
function is_balanced(text,    i, c, depth) {
    depth = 0
    for (i = 1; i <= length(text); i++) {
        c = substr(text, i, 1)
        depth += c == "(" || c == "[" || c == "{"
        depth -= c == ")" || c == "]" || c == "}"
        if (depth < 0)
            return 0
    }
    return depth == 0
}

# Whole statements on one line, behind a complete statement.
function statements(bare,    text, from) {
    text = bare
    sub(/ +$/, "", text)
    if (match(text, /^ +/) && is_balanced(text) && ended) {
        from = RLENGTH + 1
        text = substr(text, from)
        if (text ~ /^[a-z_*(][A-Za-z0-9_.>\[\]()*-]* ([-+*\/|&^]|<<|>>)?= .*;$/ ||
            text ~ /^[a-z_][a-z0-9_.>-]*\(.*\);$/ ||
            text ~ /^[a-z_*(][A-Za-z0-9_.>\[\]()*-]*(\+\+|--);$/)
            site(from, length(text), "delete", ";")
    }
}

function conditions(bare,    from, i, depth, c) {
    if (!match(bare, /(^| )if \(/))
        return
    from = RSTART + RLENGTH
    depth = 1
    for (i = from; i <= length(bare) && depth; i++) {
        c = substr(bare, i, 1)
        depth += (c == "(") - (c == ")")
    }
    if (!depth)
        site(from, i - 1 - from, "negate", "!(" substr($0, from, i - 1 - from) ")")
}

FNR == 1 { inside = 0; directive = 0; check = 0; ended = 1 }
{
    bare = bare_of($0)
    if (bare ~ /^#/ || directive) {
        directive = bare ~ /\\$/
        next
    }
    if (bare ~ /_Static_assert|TP_ASSERT/ || check) {
        check = bare !~ /;/
        next
    }
    operators(bare)
    constants(bare)
    statements(bare)
    conditions(bare)
    if (bare ~ /[^ ]/)
        ended = bare ~ /[;{}:] *$/ || bare ~ /\) *$/ && bare ~ /^ *(if|for|while) /
}
