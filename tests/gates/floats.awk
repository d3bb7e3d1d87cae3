# SPDX-License-Identifier: MIT
# Finds floating-point arithmetic and conversion in x86-64 code. Vector moves and integer
# vector arithmetic are allowed.
#
#   objdump -d --no-show-raw-insn libtidepool.a | awk -f tests/gates/floats.awk
/^[0-9a-f]+ <.*>:$/ { here = $2; functions++ }
BEGIN {
    sse = "^v?(add|sub|mul|div|sqrt|max|min|cmp|u?comi|rcp|rsqrt|hadd|hsub|dp|round" \
          "|fn?m(add|sub)[0-9]*)[sp][sd]$"
    x87 = "^f(ild|ld|st|add|sub|mul|div|cos|sin|sqrt|com|i[a-z]+)"
}
/^ +[0-9a-f]+:/ {
    op = $2
    if (op ~ sse || op ~ /^v?cvt/ || op ~ x87) {
        print here " " $0
        bad = 1
    }
}
END {
    if (!functions)
        print "no code at all"
    exit bad || !functions
}
