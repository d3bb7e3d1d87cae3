/* SPDX-License-Identifier: MIT */
/* Arm semihosting: text output and exit codes through the debugger or emulator. */
#ifndef TP_CORTEX_M_SEMIHOST_H
#define TP_CORTEX_M_SEMIHOST_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

void semihost_write(const char *text);
/* Reads the program's command line, terminated.  Returns false if it does not fit. */
bool semihost_words(char *buffer, size_t size);

/* The host program's exit codes for failures.  A fault exits with 128 + 11, as a shell
 * reports SIGSEGV. */
enum { SEMIHOST_FAILED = 3, SEMIHOST_FAULT = 139 };
_Noreturn void semihost_exit(int code);

/* Writes n in base 2 to 16, padded with zeros to `least_digits`. */
void semihost_number(const char *before, uint32_t n, uint32_t base, int least_digits);
void semihost_decimal(const char *before, uint32_t n);
/* Writes the reason of a failure and exits with SEMIHOST_FAILED. */
_Noreturn void semihost_stop(const char *why);
#endif
