/* SPDX-License-Identifier: MIT */
/* Selects between two forms of some loops: for processors with eight-lane vectors and for
 * all others.
 *
 * If TP_WIDE is 1, selects are cheaper than branches, and two small loops are cheaper than
 * one loop with a table look-up.  On x86-64 entries of small tables take a word each,
 * because vector units gather only words: 6 KB more per view there, none elsewhere. */
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
