# SPDX-License-Identifier: MIT
# A scene's working memory as a readable table.
#
#   awk -v scene=NAME -v goal=BYTES [-v most=INSTRUCTIONS] -f tests/budgets/ram.awk COUNTS SAID
#
# Each section of the counts belongs to a line of the output.  The goal holds for a row of
# so many bytes in all, and of at most so many instructions a pixel of water.
$1 == "count" { insns[$2] += $5; next }
$1 == "ram" {
    for (i = 3; i < NF; i += 2)
        value[$i] = $(i + 1)
    fixed = value["frame"] - value["vertices"] - value["tables"] - value["mirror"]
    sum = value["frame"] + value["scratch"] + value["world"]
    pixel = insns[rows + 1] / value["water"]
    if (!rows++) {
        print "\n" scene ", bytes      frame vertices  mirror  tables    tile   world" \
            "  in all  million instructions, a pixel"
    }
    printf "%-9s %7s tiles %5d %8d %7d %7d %7d %7d %7d %7.2f %4d\n", $2, value["tile"], \
        fixed, value["vertices"], value["mirror"], value["tables"], value["scratch"], \
        value["world"], sum, insns[rows] / 1e6, pixel
    if (sum <= goal && (!most || pixel <= most) && (!met || insns[rows] < cheapest)) {
        met = sum
        cheapest = insns[rows]
        by = $2 " " value["tile"] sprintf(", %d instructions a pixel", pixel)
    }
    if (!least || sum < least)
        least = sum
    stack = value["stack"] > stack ? value["stack"] : stack
}
END {
    print "stack " stack " beside it; vertices: crossings of the grid, corners of meshes"
    if (met)
        printf "met: %s working-bytes %d, goal %d; cheapest by %s\n", scene, met, goal, by
    else
        printf "MISSED: %s working-bytes %d, goal %d\n", scene, least, goal
}
