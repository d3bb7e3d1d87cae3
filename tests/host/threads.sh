#!/bin/sh
# SPDX-License-Identifier: MIT
# 1, 2, 9 and 16 threads under ThreadSanitizer, with TP_SOAK set 1 to 16: no data race.
. "$(dirname "$0")/../lib/script.sh"

echo 'int main(void) { return 0; }' >"$scratch/a.c"
if ! gcc -fsanitize=thread "$scratch/a.c" -o "$scratch/a" 2>/dev/null; then
    skip "threads under ThreadSanitizer" "libgcc-12-dev"
    exit 77
fi
step=7; [ -z "${TP_SOAK:-}" ] || step=1
test=build/tsan/tests/host/test_threads
# Without the build for level v3, whose loops share the same memory as the baseline's, and
# without the ports that the test does not link.
built()
{
    build TARGET=tsan OPT='-O1 -g1 -fsanitize=thread' V3_C= CHECKED=1 \
        PORTS="$(echo ports/app/files/*.c ports/app/scene/*.c ports/app/cli/argument_types.c \
            ports/interact/*.c ports/serial/*.c)" $test
}
check "the program builds with ThreadSanitizer" built
check "no races by 1 to 16 threads" env TP_SCENE_STEP=5 \
    TP_THREAD_STEP=$step TSAN_OPTIONS=halt_on_error=1 $test
finish
