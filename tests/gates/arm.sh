#!/bin/sh
# SPDX-License-Identifier: MIT
# The same gates on the core as Cortex-M0+ and Cortex-M4 run it.
. tests/gates/lib.sh

stack_limit=4096

lacks arm-none-eabi-gcc gcc-arm-none-eabi "gates on Cortex-M code" && exit 77
for cpu in cortex-m0plus cortex-m4; do
    whole=build/$cpu/libtidepool.a
    check "$cpu: the core compiles" build TARGET=$cpu CC=arm-none-eabi-gcc \
        AR=arm-none-eabi-ar ARCH="-mcpu=$cpu -mthumb -mfloat-abi=soft" \
        OPT='-O2 -fstack-usage -fcallgraph-info=su' $whole
    check "$cpu: no soft float, nothing but mem* and helpers" \
        symbols arm-none-eabi- $whole
    check "$cpu: no mutable state" no_state arm-none-eabi- $whole
    check "$cpu: no recursion, and a stack below $stack_limit bytes" \
        no_deeper $stack_limit $(find build/$cpu/src -name '*.ci')
done
exit $((failures > 0))
