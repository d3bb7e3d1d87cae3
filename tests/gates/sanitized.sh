#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the tests of the command line again, with the program under ASan and UBSan.
failures=0
for test in cli output bake charts; do
    tests/host/$test.sh build/san/tidepool || failures=$((failures + 1))
done
exit $((failures > 0))
