/* SPDX-License-Identifier: MIT */
/* Marks for whoever counts instructions: empty functions, whose calls a plugin or
 * callgrind sees.  MARK(count_end) defines one; who calls it knows no more of it. */
#ifndef MARKS_H
#define MARKS_H

#define MARK(name) \
    void name(void); \
    __attribute__((noinline)) void name(void) { __asm__ volatile("" ::: "memory"); }
#endif
