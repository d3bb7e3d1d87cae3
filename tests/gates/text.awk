# SPDX-License-Identifier: MIT
# Rules for each source file: a licence line at the top, no tab outside of makefiles and
# scripts, no blank at a line's end, and 90 columns, with a hard limit of 100.
#
#   awk -f tests/gates/text.awk FILE...
function wrong(why)
{
    printf "%s:%d: %s\n", FILENAME, FNR, why
    bad = 1
}

FNR == 1 { licensed = 0; made = FILENAME ~ /Makefile|\.mk$|\.sh$/ }
FNR <= 3 && /SPDX-License-Identifier: (MIT|CC0-1\.0)/ { licensed = 1 }
FNR == 3 && !licensed { wrong("no SPDX line on top") }
/\t/ && !made         { wrong("tab") }
/[ \t]$/              { wrong("blank at the end of the line") }
length($0) > 100 && FILENAME !~ /\.inc$/ { wrong("longer than 100 columns") }
END { exit bad }
