/* SPDX-License-Identifier: MIT */
/* The library's version: tidepool/tidepool.h. */
#include "tidepool/tidepool.h"

const char *tp_version(void) { return TP_VERSION_TEXT; }
