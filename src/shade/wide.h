/* SPDX-License-Identifier: MIT */
/* Where processors work on eight samples at once: what loops are written in two ways for.
 *
 * TP_WIDE says that selects are cheaper than branches, and two small loops than one in
 * which a look-up stands in the way.  Entries of small tables take a word each where
 * vector units gather words alone: on x86-64 that is 6 KB a view, elsewhere nothing. */
#ifndef TP_SHADE_WIDE_H
#define TP_SHADE_WIDE_H
#include <stdint.h>

#if defined(__AVX2__)
#define TP_WIDE 1
#else
#define TP_WIDE 0
#endif

#if defined(__x86_64__)
typedef uint32_t tp_entry8, tp_entry16;
#else
typedef uint8_t  tp_entry8;
typedef uint16_t tp_entry16;
#endif
#endif
