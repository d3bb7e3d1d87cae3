# SPDX-License-Identifier: MIT
# What the whole core asks of its surroundings, and what it shows them.
#
#   nm -A libtidepool.a | awk -f tests/gates/symbols.awk
#
# Undefined may be mem*, and the compiler's helpers for whole numbers.  A soft-float call
# (__aeabi_fmul, __muldf3 ...) is none of them, so this is a gate against floats as well.
# Every name that is defined for others begins with tp_.
BEGIN {
    allowed = "^(mem(cpy|set|move|cmp)|__aeabi_(u?i|u?l)div(mod)?" \
              "|__aeabi_(lmul|llsl|llsr|lasr|lcmp|ulcmp|mem.*)|__gnu_thumb1_case_.*" \
              "|__clz[sd]i2)$"
}

{ type = $(NF - 1); name = $NF }
type == "C"           { print $1 " " name ": mutable state"; bad = 1 }
type == "U"           { wanted[name] = $1; next }
type ~ /[A-TV-Z]/     { defined[name] }
type ~ /[A-TV-Z]/ && name !~ /^tp_/ { print $1 " " name ": defined without tp_"; bad = 1 }

END {
    for (name in wanted)
        if (!(name in defined) && name !~ allowed) {
            print wanted[name] " " name ": not to be had on a bare machine"
            bad = 1
        }
    if (!NR) {
        print "no symbols at all"
        bad = 1
    }
    exit bad
}
