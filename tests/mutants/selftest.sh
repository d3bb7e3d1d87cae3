#!/bin/sh
# SPDX-License-Identifier: MIT
# Tests of the list of mutants: places that can break, and places that cannot.
. "$(dirname "$0")/../lib/script.sh"

sites()         # C-LINE...: the mutants as OPERATOR:NEW
{
    printf '%s\n' "$@" >"$scratch/a.c"
    awk -f tests/mutants/sites.awk "$scratch/a.c" | cut -f5,6 | tr '\t\n' ': ' |
        sed 's/ $//'
}
same()          # WANT C-LINE...
{
    want=$1; shift
    got=$(sites "$@")
    [ "$got" = "$want" ] || { echo "got  $got"; echo "want $want"; return 1; }
}
check "sums and products"    same 'sum:- product:/' '    return a + b * c;'
check "bounds"               same 'bound:<= bound:!=' '    return a < b | c == d;'
check "logic, and conditions" same 'logic:|| negate:!(a && b)' '    if (a && b)'
check "whole numbers"        same 'constant:8 constant:6' '    return 7;'
check "statements of a line" same 'delete:;' '    f(a);'
check "a declaration is no statement" same '' '    int a = b;'
check "comments, strings, preprocessor" same '' '#define A 7' '/* a + 7' ' b && c */' \
    'char *s = "a + 7";'
check "names and numbers with a point" same '' 'int x1 = y2 = TP_FX(0.5);'
check "assertions" same '' '    TP_ASSERT(a < 7);'

awk -f tests/mutants/sites.awk src/fixed/*.c >"$scratch/sites"
picked()        # SEED
{
    awk -v seed="$1" -f tests/mutants/pick.awk "$scratch/sites"
}
each_once()     { picked 1 | sort | diff - "$scratch/sorted"; }
again()         { [ "$(picked 7 | head -n 40 | cksum)" = "$(picked "$1" | head -n 40 | cksum)" ]; }
sort "$scratch/sites" >"$scratch/sorted"
check  "every place is picked once" each_once
check  "a seed picks the same again" again 7
refuse "another seed picks others" again 8
finish
