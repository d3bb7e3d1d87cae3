#!/bin/sh
# SPDX-License-Identifier: MIT
# The command line's tests once more, on the program under ASan and UBSan.
tests/host/cli.sh build/san/tidepool
cli=$?
tests/host/bake.sh build/san/tidepool && exit $cli
