# SPDX-License-Identifier: MIT
# Prints the functions that take a thousandth or more of a program's counted instructions,
# each behind the scene's name; see in_ram.sh.
#
#   awk -v scene=NAME -f tests/lib/symbol_at.awk -f tests/boards/pico/in_ram.awk \
#       SYMBOLS COUNTS
#
# SYMBOLS: the output of nm, sorted, in decimal. COUNTS: the output of the plugin.
FNR == NR {
    if (tolower($2) == "t") {
        start[++symbols] = $1 + 0
        name[symbols] = $3
    }
    next
}
$1 == "count" && $3 ~ /^(frame|tiles|tick)$/ {
    done[symbol_at($6 + 0)] += $5
    all += $5
}
END {
    for (i in done)
        if (1000 * done[i] >= all) {
            sub(/\..*/, "", name[i])            # .isra.0 and others
            if (name[i] !~ /^(__|mem)/)         # functions of the port
                print scene, name[i]
        }
}
