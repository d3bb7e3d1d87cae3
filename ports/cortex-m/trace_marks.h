/* SPDX-License-Identifier: MIT */
/* Marks for instruction counters: empty functions, their calls visible to a plugin or
 * callgrind.  MARK(count_end) defines one; a caller needs no other declaration. */
#ifndef TP_CORTEX_M_TRACE_MARKS_H
#define TP_CORTEX_M_TRACE_MARKS_H

#define TRACE_MARK(name) \
    void name(void); \
    __attribute__((noinline)) void name(void) { __asm__ volatile("" ::: "memory"); }
#endif
