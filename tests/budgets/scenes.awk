# SPDX-License-Identifier: MIT
# The scenes' figures as a readable table, beside their budgets.
#
#   awk -f tests/budgets/scenes.awk scenes.csv FIGURES
FILENAME == ARGV[1] {
    split($0, cell, ",")
    if (cell[2] == "instructions")
        budget[cell[1]] = cell[3]
    next
}
$1 == "figure" {
    if (!($2 in seen))
        order[++scenes] = $2
    seen[$2]
    value[$2, $3] = $4
    if (split($3, part, ".") == 2 && part[1] == "frame")
        value[$2, "once"] += $4
    else if (index($3, ".") && part[1] != "tick" && $3 != "tiles.visibility" && \
             $3 != "tiles.store")
        value[$2, "shading"] += $4
}
END {
    print "\n              million instructions at 320x240                  thousand"
    print "scene         a frame   once  visible  shading  store  /water   a tick" \
        "  RAM KB  stack  change"
    for (i = 1; i <= scenes; i++) {
        s = order[i]
        printf "%-13s %7.2f %6.2f %8.2f %8.2f %6.2f %7.1f %8.1f %7.1f %6d  ", s, \
            value[s, "instructions"] / 1e6, value[s, "once"] / 1e6, \
            value[s, "tiles.visibility"] / 1e6, value[s, "shading"] / 1e6, \
            value[s, "tiles.store"] / 1e6, value[s, "pixel"], value[s, "tick"] / 1e3, \
            value[s, "working-bytes"] / 1024, value[s, "stack-bytes"]
        printf budget[s] ? "%+.1f %%\n" : "-\n", \
            budget[s] ? 100 * value[s, "instructions"] / budget[s] - 100 : 0
    }
    print "RAM: frame, tile and world, without tables that could be constants; the" \
        " stack beside it"
}
