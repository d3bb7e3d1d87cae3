/* SPDX-License-Identifier: MIT */
/* Shared by the files of the command interface: words of a line, and pieces of its
 * reply. */
#ifndef TP_SERIAL_REPLY_H
#define TP_SERIAL_REPLY_H
#include "control.h"
#include "tidepool/scene.h"

void *memcpy(void *restrict to, const void *restrict from, size_t bytes);
void *memset(void *to, int value, size_t bytes);

/* A part of the line, not terminated. */
typedef struct { const char *text; size_t bytes; } control_word;

/* Returns the next word of *rest, up to a blank or `end`; *rest then starts after the
 * following blanks. */
control_word control_next(control_word *rest, char end);
bool control_is(control_word word, const char *name);

/* Returns the parameter of a name.  An earlier name is answered with a line that gives the
 * present name, an unknown name with an error; the function then returns NULL. */
const tp_param *control_find(const control *c, control_word name);
void control_set(control *c, control_word rest);

void reply_text(const control *c, const char *text);
void reply_number(const control *c, uint32_t number);
void reply_value(const control *c, const tp_param *param);     /* "name = 0.8 m" */
/* Writes `before` and the permitted values: "0..16" or words; writes nothing for colours
 * and names. */
void reply_range(const control *c, const char *before, const tp_param *param);
void reply_error(const control *c, const char *why);                 /* whole lines */
void reply_input_error(const control *c, const tp_error *err);
void reply_value_error(const control *c, const tp_param *param, const tp_error *err);
#endif
