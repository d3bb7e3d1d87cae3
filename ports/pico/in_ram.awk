# SPDX-License-Identifier: MIT
# Prints the part of the linker script that lists the functions a scene runs in RAM; for a
# scene that the table lacks, the functions of all scenes.  With other settings than the
# table's, those of the scene at any rungs.
#
#   awk -v scene=NAME [-v settings=TEXT] -f ports/pico/in_ram.awk ports/pico/in_ram.txt
BEGIN {
    sub(/@.*/, "", scene)
    if (settings)
        sub(/\+cheap$/, "", scene)
}
$1 == "scenes" {
    for (i = 2; i <= NF; i++) {
        columns++
        if ($i == scene || settings && $i == scene "+cheap")
            column[++found] = columns
    }
}
function runs(row,    i)
{
    for (i = 1; i <= found; i++)
        if (substr(row, column[i], 1) == "x")
            return 1
    return !found
}
/^[.x]/ && runs($1) {
    print "*(.text." $2 " .text." $2 ".*)"
}
