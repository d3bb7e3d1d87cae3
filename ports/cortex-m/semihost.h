/* SPDX-License-Identifier: MIT */
/* Arm semihosting: words and exit codes to the debugger or emulator that we run under. */
#ifndef SEMIHOST_H
#define SEMIHOST_H
#include <stdint.h>

void semihost_write(const char *text);
_Noreturn void semihost_exit(int code);
#endif
