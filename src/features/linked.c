/* SPDX-License-Identifier: MIT */
/* The program of who names none: everything.  A baked file defines this symbol too, and
 * then a linker does not take this one out of the library. */
#include "tidepool/modules.h"

const tp_program *const tp_program_linked = &tp_program_all;
