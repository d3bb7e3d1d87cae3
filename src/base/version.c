/* SPDX-License-Identifier: MIT */
/* The version of the library: tidepool/tidepool.h. */
#include "tidepool/tidepool.h"

const char *tp_version(void) { return TP_VERSION_TEXT; }
