# SPDX-License-Identifier: MIT
# Prints the part of the linker script that lists the functions a scene runs in RAM; for a
# scene that the table lacks, the functions of all scenes.
#
#   awk -v scene=NAME -f ports/pico/in_ram.awk ports/pico/in_ram.txt
BEGIN {
    sub(/@.*/, "", scene)
}
$1 == "scenes" {
    for (i = 2; i <= NF; i++) {
        columns++
        if ($i == scene)
            column = columns
    }
}
/^[.x]/ && (!column || substr($1, column, 1) == "x") {
    print "*(.text." $2 " .text." $2 ".*)"
}
