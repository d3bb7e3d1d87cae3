/* SPDX-License-Identifier: MIT */
/* Arm semihosting: words and exit codes to the debugger or emulator that we run under. */
#ifndef SEMIHOST_H
#define SEMIHOST_H
#include <stdint.h>

void semihost_write(const char *text);
_Noreturn void semihost_exit(int code);

/* Of base 2 to 16, with zeros before it up to `least_digits`. */
void semihost_number(const char *before, uint32_t n, uint32_t base, int least_digits);
void semihost_decimal(const char *before, uint32_t n);
_Noreturn void semihost_stop(const char *why);
#endif
