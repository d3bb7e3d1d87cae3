#!/bin/sh
# SPDX-License-Identifier: MIT
# The command line's tests once more, on the program under ASan and UBSan.
failures=0
for test in cli output bake charts; do
    tests/host/$test.sh build/san/tidepool || failures=$((failures + 1))
done
exit $((failures > 0))
