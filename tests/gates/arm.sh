#!/bin/sh
# SPDX-License-Identifier: MIT
# The gates on the core's code for Cortex-M0 and Cortex-M4.
. "$(dirname "$0")/../lib/script.sh"

stack_limit=4096

lacks arm-none-eabi-gcc gcc-arm-none-eabi "gates on Cortex-M code" && exit 77
for board in cortex-m:cortex-m4 cortex-m/microbit:cortex-m0-small; do
    built=build/${board#*:} board=${board%:*}
    whole=$built/libtidepool.a
    check "$board: the core compiles" build BOARD=$board $whole
    check "$board: no soft float, nothing but mem* and helpers" \
        symbols arm-none-eabi- $whole
    check "$board: no mutable state" no_state arm-none-eabi- $whole
    check "$board: no recursion, and a stack below $stack_limit bytes" \
        no_deeper $stack_limit $(find $built/src -name '*.ci')
done
finish
