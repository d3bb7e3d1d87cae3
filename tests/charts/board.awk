# SPDX-License-Identifier: MIT
# Joins the output of board.c and the counts of the plugin, a line a picture; see board.sh.
#
#   awk -v pictures=N -f tests/lib/symbol_at.awk \
#       -f tests/charts/board.awk SYMBOLS SAID COUNTS
#
# SYMBOLS: the output of nm, sorted, in decimal, with files.
FNR == 1 { file++ }
file == 1 {
    if (tolower($2) == "t" || $2 == "W") {
        start[++symbols] = $1 + 0
        folder[symbols] = match($4, /src\/[a-z]+\//) ? \
            substr($4, RSTART + 4, RLENGTH - 5) : "helpers"
    }
    next
}
file == 2 && $1 == "run" {
    said[++runs] = $2 " " $3 " " $5 " " $6
    crc[runs] = $9
    next
}
$1 == "count" {
    total[$2, $3] += $5
    if (finds($3, folder[symbol_at($6 + 0)]))
        seen[$2] += $5
}

# True if the function helps to find the water, and does not compute its colours.
function finds(account, place)
{
    return account == "frame" ? place !~ /^(shade|pixel)$/ \
         : account == "tiles" && place ~ /^(view|raster|frame|waves)$/
}

END {
    if (runs != pictures || !total[runs, "tiles"]) {
        print "board.awk: " runs + 0 " pictures of " pictures " were drawn and counted" \
            >"/dev/stderr"
        exit 1
    }
    for (i = 1; i <= runs; i++)
        printf "%d %s %.0f %.0f %.0f %.0f %s\n", i, said[i], total[i, "tick"], \
            total[i, "frame"], total[i, "tiles"], seen[i], crc[i]
}
