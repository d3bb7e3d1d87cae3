#!/bin/sh
# SPDX-License-Identifier: MIT
# The command line's tests once more, on the program under ASan and UBSan.
exec tests/host/cli.sh build/san/tidepool
