# SPDX-License-Identifier: MIT
# shellcheck shell=sh disable=SC2154
# Rows of tests/boards/configurations.csv; read by `.` after script.sh.

rows=tests/boards/configurations.csv
rows_compiler() { echo "arm-none-eabi-gcc $(arm-none-eabi-gcc -dumpfullversion)"; }

# True if the rows were measured by the compiler of this machine; else a message.
rows_comparable()
{
    want=$(sed -n 's/^# compiler //p' $rows)
    [ "$want" = "$(rows_compiler)" ] && return
    skip "rows of boards by $want, here $(rows_compiler)" "${want% *}"
    return 1
}

# Writes the rows of FILE instead of all other rows of their boards, in the order of
# boards.csv; then the pages.
rows_put()      # FILE
{
    {
        sed "s/^# compiler .*/# compiler $(rows_compiler)/" $rows | sed '/^board/q'
        sed '1,/^board/d' $rows | awk -F, '
            FILENAME ~ /boards[.]csv$/ { if (!/^(#|board,)/) board[++n] = $1; next }
            FILENAME != "-" { measured[$1] }
            FILENAME != "-" || !($1 in measured) { line[$1] = line[$1] $0 "\n" }
            END { for (i = 1; i <= n; i++) printf "%s", line[board[i]] }' \
            tests/boards/boards.csv "$1" -
    } >"$scratch/all-rows"
    cp "$scratch/all-rows" $rows && tests/boards/figures.sh --write
}
