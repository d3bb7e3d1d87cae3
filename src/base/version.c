/* SPDX-License-Identifier: MIT */
/* The library's version: tidepool/version.h. */
#include "tidepool/version.h"

const char *tp_version(void) { return TP_VERSION_TEXT; }
