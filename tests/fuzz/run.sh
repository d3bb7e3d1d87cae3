#!/bin/sh
# SPDX-License-Identifier: MIT
# Feeds each fuzz target random input for FUZZ_SECONDS (6) under ASan and UBSan, in
# parallel on all processors. FUZZ_ONLY="csv tape" selects targets.
#
# Seeds and inputs of past failures lie in tests/fuzz/NAME/ and run first; the words of an
# input format are in tests/fuzz/NAME.dict. TP_SEED repeats the random numbers of a run,
# apart from the effect of the machine's speed.
. "$(dirname "$0")/../lib/script.sh"

seconds=${FUZZ_SECONDS:-6}

# Writes the result to $scratch/NAME; an input that breaks the target stays in build/fuzz.
run_one()       # NAME
{
    program=build/fuzz/tests/fuzz/fuzz_$1
    log=$scratch/$1.log
    [ -x "$program" ] || { skip "fuzz_$1" "libsdl2-dev"; return; }
    mkdir "$scratch/$1" "$scratch/$1.tmp"
    cp -r "tests/fuzz/$1" "$scratch/$1.seeds" && rm -f "$scratch/$1.seeds/README.md"
    set -- "$1" "$scratch/$1" "$scratch/$1.seeds"
    name=$1; shift
    [ ! -f "tests/fuzz/$name.dict" ] || set -- -dict="tests/fuzz/$name.dict" "$@"
    if TMPDIR=$scratch/$name.tmp "$program" -max_total_time="$seconds" -timeout=60 \
        -rss_limit_mb=2048 -close_fd_mask=3 -print_final_stats=1 \
        -artifact_prefix="build/fuzz/$name-" ${TP_SEED:+-seed="$TP_SEED"} \
        "$@" >"$log" 2>&1 </dev/null
    then
        echo "ok - fuzz_$name finds nothing in $seconds s"
        sed -n 's/^stat::number_of_executed_units: */    runs: /p' "$log"
    else
        grep -v '^#' "$log" | tail -n 60 | sed 's/^/    /'
        echo "FAILED - fuzz_$name finds nothing in $seconds s"
        sed -n "s,^artifact_prefix=.*written to ,    again: $program ,p" "$log"
    fi
}

if [ "${1:-}" = -one ]; then
    rm -rf "$scratch"
    scratch=$3
    trap - EXIT
    run_one "$2"
    exit 0
fi

lacks clang clang "fuzzing" && exit 77
echo 'int LLVMFuzzerTestOneInput(void) { return 0; }' >"$scratch/try.c"
clang -fsanitize=fuzzer "$scratch/try.c" -o "$scratch/try" 2>/dev/null ||
    { skip "fuzzing" "libclang-rt-dev"; exit 77; }

sanitize=address,undefined
# Only C++ has the check of calls through pointers, by a library that C does not link.
check "the fuzz targets build" build SAY=@ TARGET=fuzz CC=clang V3_C= CHECKED=1 \
    OPT="-O1 -g1 -fsanitize=fuzzer-no-link,$sanitize -fno-sanitize=function \
         -fno-sanitize-recover=all" LDFLAGS="-fsanitize=$sanitize" fuzzers
[ "$failed" -eq 0 ] || exit 1

names=${FUZZ_ONLY:-$(ls tests/fuzz/fuzz_*.c | sed 's,.*/fuzz_,,; s,\.c$,,')}
printf '%s\n' $names | xargs -P "$(nproc)" -I{} "$0" -one {} "$scratch" |
    tee "$scratch/results"
! grep -q '^FAILED' "$scratch/results" && [ "$failed" -eq 0 ]
