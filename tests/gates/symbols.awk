# SPDX-License-Identifier: MIT
# External symbols of the whole core: undefined and exported names.
#
#   nm -A libtidepool.a | awk -f tests/gates/symbols.awk
#
# Allowed as undefined: mem*, and the compiler's helpers for integers. A soft-float call
# (__aeabi_fmul, __muldf3 ...) is not allowed, so this is also a gate against floats. Each
# exported name begins with tp_.
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
