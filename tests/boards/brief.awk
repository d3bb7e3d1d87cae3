# SPDX-License-Identifier: MIT
# The short table of boards for README.md, from the two tables of ports/BOARDS.md: RAM
# without the stack, flash (code, constants and scene), instructions of a frame.
#
#   awk -f tests/boards/brief.awk ports/BOARDS.md
BEGIN {
    FS = " *[|] *"
    print "| board, scene | picture | RAM, KB | flash, KB | million instructions a frame |"
    print "|---|---|---|---|---|"
}
/^<!-- boards/      { within = 1 }
/^<!-- \/boards/    { within = 0 }
!within || !/`/     { next }
NF == 9 {
    printf "| %s | %s | %.1f | %d | %.1f |\n", $2, $3, ram[$2] / 1024,
        ($4 + $5 + $6 + 512) / 1024, $7 / 1e6
    next
}
{ ram[$2] = $8 }
