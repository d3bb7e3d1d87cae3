/* SPDX-License-Identifier: MIT */
/*
 * Values as text: string views of user text, as in settings and tapes, and the values of
 * parameters.  The text of a view is not terminated.  White space is the space character
 * and the characters from tab to carriage return.
 */
#ifndef TP_WORLD_VALUE_H
#define TP_WORLD_VALUE_H
#include <stdbool.h>
#include <stddef.h>
#include "tidepool/scene.h"
#include "tidepool/status.h"

typedef struct { const char *text; size_t bytes; } tp_string_view;

static inline bool tp_is_white(char c)
{
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* Returns the view without leading and trailing white space. */
tp_string_view tp_string_view_trim(tp_string_view piece);

bool tp_string_view_equals(tp_string_view piece, const char *name);
bool tp_string_view_has_control(tp_string_view piece); /* bytes below the space, or DEL */

/* Reads the whole view as a number.  TP_E_NUMBER: not a number.  TP_E_RANGE: outside
 * Q16.16. */
tp_status tp_string_view_read_fx(tp_string_view piece, tp_fx *x);

/* tp_param_is_file: true if the row's value is a file name. tp_param_is_text: true if the
 * value is any text in a char[TP_NAME_BYTES], false for a number in an int32_t. */
static inline bool tp_param_is_file(const tp_param *param)
{
    return param->kind == TP_PARAM_MESH || param->kind == TP_PARAM_TEXTURE
        || param->kind == TP_PARAM_GREY;
}

static inline bool tp_param_is_text(const tp_param *param)
{
    return tp_param_is_file(param) || param->kind == TP_PARAM_TEXT;
}

/* Returns the row with this name, or NULL. */
const tp_param *tp_param_find(const char *name, size_t bytes);

/* Sets a value from its text ("0.35", "on", "#204060", "linear", a file name); ignores
 * white space around the text.  An invalid text changes nothing; err->word is the text.
 * For TP_E_RANGE err->a and err->b are the ends of the range in the number's own format. */
tp_status tp_param_set(tp_scene *scene, const tp_param *param, const char *text,
                       size_t bytes, tp_error *err);

/* Writes a number as in scene files: by the parameter's kind "0.35", "on", "#204060" or a
 * choice.  Returns the length of the whole text, even if `text` holds only its begin. */
size_t tp_param_number_text(const tp_param *param, int32_t number, char *text,
                            size_t bytes);

#endif
