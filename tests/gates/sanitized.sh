#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the tests of the command line again, with the program under ASan and UBSan.
. "$(dirname "$0")/../lib/script.sh"
for test in cli output bake charts; do
    tests/host/$test.sh build/san/tidepool || failed=$((failed + 1))
done
finish
