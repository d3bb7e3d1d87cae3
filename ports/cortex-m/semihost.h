/* SPDX-License-Identifier: MIT */
/* Arm semihosting: words and exit codes to the debugger or emulator that we run under. */
#ifndef SEMIHOST_H
#define SEMIHOST_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void semihost_write(const char *text);
/* The command line that the program was given, terminated; false: it does not fit. */
bool semihost_words(char *buffer, size_t size);

/* The host program's exit codes, as far as a board has them; a fault ends a program as a
 * shell tells of SIGSEGV, by 128 + 11. */
enum { SEMIHOST_FAILED = 3, SEMIHOST_FAULT = 139 };
_Noreturn void semihost_exit(int code);

/* Of base 2 to 16, with zeros before it up to `least_digits`. */
void semihost_number(const char *before, uint32_t n, uint32_t base, int least_digits);
void semihost_decimal(const char *before, uint32_t n);
/* Says why it cannot go on and exits with SEMIHOST_FAILED. */
_Noreturn void semihost_stop(const char *why);
#endif
