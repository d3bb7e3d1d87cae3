# SPDX-License-Identifier: MIT
# What a board said and what the plugin counted, as a table for people.
#
#   awk -f tests/budgets/board.awk BOARD COUNTS
#
# The plugin's sections are the board's sizes, in their order.
/^size/  { sizes++; size[sizes] = $2; next }
/^frame/ { frames[sizes]++; next }
/^water/ { water[sizes] += $2; vertices[sizes] += $4; triangles[sizes] += $6; next }
/^ram/   { ram[sizes] = $0; next }
/^count/ {
    i = $2 SUBSEP (++names[$2])
    account[i] = $3
    name[i] = $4
    insns[i] = $5
    spent[$2, $3] += $5
    total[$2] += $5
}
/^stack/ { stack[$2] = $3 }

# Prints the functions of a section, the most expensive first, down to a thousandth.
function list(of,    i, k, best, shown)
{
    for (shown = 0; shown < names[of]; shown++) {
        best = ""
        for (k = 1; k <= names[of]; k++) {
            i = of SUBSEP k
            if (insns[i] > 0 && (best == "" || insns[i] > insns[best]))
                best = i
        }
        if (best == "" || insns[best] < total[of] / 1000)
            break
        printf "  %-6s %-28s %11d %5.1f %% %8.1f\n", account[best], name[best], \
            insns[best] / frames[of], 100 * insns[best] / total[of], \
            insns[best] / water[of]
        insns[best] = 0
    }
}

END {
    for (i = 1; i <= sizes; i++) {
        printf "\n%s: %d instructions a frame, %.1f a water pixel (of %d)\n", size[i], \
            total[i] / frames[i], total[i] / water[i], water[i] / frames[i]
        printf "  once a frame: %d, %.1f a vertex (of %d); in tiles: %d, %.1f a water " \
            "pixel\n", spent[i, "frame"] / frames[i], spent[i, "frame"] / vertices[i], \
            vertices[i] / frames[i], spent[i, "tiles"] / frames[i], \
            spent[i, "tiles"] / water[i]
        print "  part   function                     instructions   share  a water pixel"
        list(i)
        printf "  deepest stack %d bytes; bytes of %s\n", stack[i], ram[i]
    }
}
