/* SPDX-License-Identifier: MIT */
/* The default program for applications without a program of their own: all modules.  A
 * baked file defines the same symbol; the linker then leaves this file in the library. */
#include "tidepool/modules.h"

const tp_program *const tp_program_linked = &tp_program_all;
