# SPDX-License-Identifier: MIT
# Prints the lines of sites.awk in a random order given by `seed`; all operators are
# equally likely.
BEGIN { FS = "\t" }
{
    if (!($5 in count)) operators[++kinds] = $5
    sites[$5, ++count[$5]] = $0
}

# A random integer from 1 to n, by the minimal standard generator: its products stay below
# 2^47, so all awks draw the same numbers.
function chance(n) {
    seed = seed * 16807 % 2147483647
    return seed % n + 1
}

END {
    seed = seed % 2147483646 + 1
    chance(1)
    for (n = 0; kinds > 0; n++) {
        k = chance(kinds)
        operator = operators[k]
        at = chance(count[operator])
        print sites[operator, at]
        sites[operator, at] = sites[operator, count[operator]]
        if (--count[operator] == 0)
            operators[k] = operators[kinds--]
    }
}
