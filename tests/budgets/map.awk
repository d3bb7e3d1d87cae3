# SPDX-License-Identifier: MIT
# What of the core a program links, from ld's map: bytes of text and of constants.
#
#   awk [-v each=1] -f tests/budgets/map.awk PROGRAM.map
#
# With each=1 every section, the largest first if sorted by the second column.
function number(hex,    i, n)
{
    for (i = 3; i <= length(hex); i++)
        n = 16 * n + index("0123456789abcdef", substr(hex, i, 1)) - 1
    return n
}

/^Linker script and memory map/ { mapped = 1 }
!mapped { next }

# A long name stands in a line of its own.
/^ \.[^ ]+$/ { name = $1; next }
/^ \.[^ ]+ +0x/ { name = $1; sub(/^ \.[^ ]+/, "") }
/^ +0x[0-9a-f]+ +0x[0-9a-f]+ .*libtidepool\.a\(/ {
    if (name ~ /^\.text/)
        text += number($2)
    else if (name ~ /^\.rodata/)
        constants += number($2)
    else
        next
    if (each && number($2))
        print name, number($2), $3
    name = ""
}

END { if (!each) printf "%d %d\n", text, constants }
