#!/bin/sh
# SPDX-License-Identifier: MIT
# clang finds nothing to warn of either, in the core, the program and the tests.
. tests/gates/lib.sh

lacks clang clang "clang's warnings" && exit 77
check "clang compiles everything without a warning" \
    alone build TARGET=cross/host-clang-O0 MACHINE=host CC=clang OPT=-O0 \
    V3_OPT=-march=x86-64-v3 everything unit
exit $((failures > 0))
