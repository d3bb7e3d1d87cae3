#!/bin/sh
# SPDX-License-Identifier: MIT
# Runs the test of the command line again, with the program under ASan and UBSan; with
# TP_SOAK set its other tests too.
. "$(dirname "$0")/../lib/script.sh"
for test in cli ${TP_SOAK:+output bake charts}; do
    tests/host/$test.sh build/san/tidepool || failed=$((failed + 1))
done
finish
