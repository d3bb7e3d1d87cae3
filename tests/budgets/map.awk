# SPDX-License-Identifier: MIT
# Parts of the core that a program links, from ld's map: bytes of text and of constants.
#
#   awk [-v each=1] [-v files=PATTERN] -f tests/budgets/map.awk PROGRAM.map
#
# With each=1 prints each section; sort by the second column to get the largest first.
# files: counts other files than those of the core.
function number(hex,    i, n)
{
    for (i = 3; i <= length(hex); i++)
        n = 16 * n + index("0123456789abcdef", substr(hex, i, 1)) - 1
    return n
}

BEGIN { if (files == "") files = "libtidepool[.]a[(]" }
/^Linker script and memory map/ { mapped = 1 }
!mapped { next }

# Counts the last section, unless the next section begins at the same address: for merged
# strings the map prints the size of all of them.
function take(next_at)
{
    if (name && at != next_at) {
        if (name ~ /^\.text/)
            text += size
        else
            constants += size
        if (each && size)
            print name, size, file
    }
    name = ""
}

# A long name stands in a line of its own.
/^ \.[^ ]+$/ { long = $1; next }
/^ \.[^ ]+ +0x/ { long = $1; sub(/^ \.[^ ]+/, "") }
/^ \*fill\* / { take($2) }
/^ +0x[0-9a-f]+ +0x[0-9a-f]+ / {
    take($1)
    name = $0 ~ files && long ~ /^\.(text|rodata)/ ? long : ""
    at = $1
    size = number($2)
    file = $3
}

END { take(""); if (!each) printf "%d %d\n", text, constants }
