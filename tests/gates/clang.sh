#!/bin/sh
# SPDX-License-Identifier: MIT
# clang finds nothing to warn of either, in the core, the program and the tests.
. tests/gates/lib.sh

lacks clang clang "clang's warnings" && exit 77
check "clang compiles everything without a warning" \
    build TARGET=clang CC=clang everything
exit $((failures > 0))
