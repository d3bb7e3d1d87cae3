# SPDX-License-Identifier: MIT
# Converts callgrind's dumps, one for each section, to the lines of count.c's plugin:
#     count SECTION model FUNCTION INSTRUCTIONS
# The cost of a call stands behind its line "calls=" and belongs to the callee.
#
#   awk -f tests/budgets/callgrind.awk DUMP...
/^part:/   { section = $2 }
/^fn=/     { name = substr($0, 4); gsub(/ /, "_", name); next }
/^calls=/  { getline; next }
/^[0-9]/   { insns[section " model " name] += $2 }
END {
    for (i in insns)
        printf "count %s %d\n", i, insns[i]
}
