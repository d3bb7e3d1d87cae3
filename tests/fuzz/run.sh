#!/bin/sh
# SPDX-License-Identifier: MIT
# Feeds every fuzz target random input for FUZZ_SECONDS (10) under ASan and UBSan.  Seeds
# lie in tests/fuzz/NAME/; what breaks a target is kept as build/fuzz/NAME-...
. tests/gates/lib.sh

lacks clang clang "fuzzing" && exit 77
echo 'int LLVMFuzzerTestOneInput(void) { return 0; }' >"$scratch/try.c"
clang -fsanitize=fuzzer "$scratch/try.c" -o "$scratch/try" 2>/dev/null ||
    { echo "skipped: fuzzing (package libclang-rt-dev)"; exit 77; }

sanitize=address,undefined
check "the fuzz targets build" build TARGET=fuzz CC=clang \
    OPT="-O1 -g1 -fsanitize=fuzzer-no-link,$sanitize -fno-sanitize-recover=all" \
    LDFLAGS="-fsanitize=$sanitize" fuzzers
for source in tests/fuzz/fuzz_*.c; do
    [ -f "$source" ] || continue
    name=$(basename "$source" .c)
    mkdir -p "$scratch/$name"
    set --
    [ ! -d "tests/fuzz/${name#fuzz_}" ] || set -- "tests/fuzz/${name#fuzz_}"
    check "$name finds nothing in ${FUZZ_SECONDS:-10} s" "build/fuzz/tests/fuzz/$name" \
        -max_total_time="${FUZZ_SECONDS:-10}" -rss_limit_mb=2048 -timeout=10 \
        -artifact_prefix="build/fuzz/$name-" -print_final_stats=1 "$scratch/$name" "$@"
    sed -n 's/^stat::number_of_executed_units: */    runs: /p' "$scratch/output"
done
exit $((failures > 0))
