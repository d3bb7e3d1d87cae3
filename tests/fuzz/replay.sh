#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the seeds of each fuzz target, its past failures among them, and random changes of
# them for 400 ms, by the sanitized build's own programs.  tests/fuzz/run.sh searches with
# libFuzzer: `make fuzz`, and the soak.
. "$(dirname "$0")/../lib/script.sh"

described()     # each target has seeds, and a row of the table
{
    for source in tests/fuzz/fuzz_*.c; do
        target=$(basename "$source" .c)
        grep -q "^| \`$target\` |" tests/fuzz/README.md ||
            { echo "no row of $target"; return 1; }
        ls "tests/fuzz/${target#fuzz_}" | grep -vqx README.md || return 1
    done
}
check "each fuzz target has seeds and its row in tests/fuzz/README.md" described

replayed()      # NAME
{
    TMPDIR=$scratch "build/san/tests/fuzz/replay_$1" "tests/fuzz/$1" 400 \
        >"$scratch/said" 2>"$scratch/words" </dev/null && return
    tail -n 60 "$scratch/words"
    return 1
}
for source in tests/fuzz/fuzz_*.c; do
    name=$(basename "$source" .c)
    name=${name#fuzz_}
    [ -x "build/san/tests/fuzz/replay_$name" ] ||
        { skip "fuzz_$name" "libsdl2-dev"; continue; }
    check "fuzz_$name finds nothing" replayed "$name"
    sed -n '/runs:/p' "$scratch/said"
done
finish
