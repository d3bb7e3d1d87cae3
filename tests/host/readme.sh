#!/bin/sh
# SPDX-License-Identifier: MIT
# The README's first program compiles as it stands there and draws a whole picture.
. tests/gates/lib.sh

program=$scratch/first
{
    echo '#include <stdio.h>'
    echo '#include "tidepool/tidepool.h"'
    echo 'static uint32_t drawn;'
    echo 'static void show(uint32_t x0, uint32_t y0, uint32_t x1, uint32_t y1,'
    echo '                 const void *pixels, size_t stride)'
    echo '{ drawn += pixels && stride ? (x1 - x0) * (y1 - y0) : 0; }'
    echo 'int main(void) {'
    sed -n '/^## A first program/,/^Link with/s/^    //p' README.md | grep -v '^#include'
    echo 'return printf("%u pixels", (unsigned)drawn) < 0 || drawn != 320 * 240; }'
} >"$program.c"

check "the README has a program" grep -q tp_frame_tile "$program.c"
check "it compiles without a warning" cc -std=c11 -Wall -Wextra -Werror -Iinclude \
    "$program.c" build/host/libtidepool.a -o "$program"
check "it draws every pixel" "$program"
exit $((failures > 0))
