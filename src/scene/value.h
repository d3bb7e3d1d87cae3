/* SPDX-License-Identifier: MIT */
/* Values of a row of parameters, as text. */
#ifndef TP_SCENE_VALUE_H
#define TP_SCENE_VALUE_H
#include <stddef.h>
#include "tidepool/scene.h"

/* True if the row's value is a file's name; true if it is text of any kind, in a
 * char[TP_NAME_BYTES], rather than a number in an int32_t. */
static inline bool tp_param_is_file(const tp_param *param)
{
    return param->kind == TP_PARAM_MESH || param->kind == TP_PARAM_TEXTURE
        || param->kind == TP_PARAM_GREY;
}

static inline bool tp_param_is_text(const tp_param *param)
{
    return tp_param_is_file(param) || param->kind == TP_PARAM_TEXT;
}

/* The row of that name, or NULL. */
const tp_param *tp_param_find(const char *name, size_t bytes);

/* Sets one value from its text ("0.35", "on", "#204060", "linear", a file name), white
 * space around it ignored; a bad text changes nothing.  err->word is the bad text; of
 * E_RANGE err->a and err->b are the range's ends in the number's own format. */
tp_status tp_param_set(tp_scene *scene, const tp_param *param, const char *text,
                       size_t bytes, tp_error *err);

size_t tp_param_number_text(const tp_param *param, int32_t number, char *text,
                            size_t bytes);
#endif
