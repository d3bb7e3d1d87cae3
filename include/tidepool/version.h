/* SPDX-License-Identifier: MIT */
/* The version, which is written here alone.
 *
 * The same version draws the same bits on every machine.  MAJOR rises when a program that
 * used the API no longer compiles or means something else, MINOR when pictures change or
 * the API grows, PATCH when neither does.  While MAJOR is 0, MINOR stands for both. */
#ifndef TP_VERSION_H
#define TP_VERSION_H
#include "tidepool/language.h"

#define TP_VERSION_MAJOR 0
#define TP_VERSION_MINOR 1
#define TP_VERSION_PATCH 0
#define TP_VERSION_DATE  "2026-11-22"

/* One number, to compare in #if: MAJOR 1000000 + MINOR 1000 + PATCH, so 1002003 is
 * 1.2.3. */
#define TP_VERSION \
    (TP_VERSION_MAJOR * 1000000 + TP_VERSION_MINOR * 1000 + TP_VERSION_PATCH)

/* "MAJOR.MINOR.PATCH" of this header. */
#define TP_VERSION_TEXT \
    TP_VERSION_WORD(TP_VERSION_MAJOR) "." \
    TP_VERSION_WORD(TP_VERSION_MINOR) "." \
    TP_VERSION_WORD(TP_VERSION_PATCH)
#define TP_VERSION_WORD(number)  TP_VERSION_WORD_(number)
#define TP_VERSION_WORD_(number) #number

TP_BEGIN_C

/* The library's own TP_VERSION_TEXT: a program linked with another version than it was
 * compiled for finds the two unequal. */
const char *tp_version(void);

TP_END_C
#endif
