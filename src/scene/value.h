/* SPDX-License-Identifier: MIT */
/* Parameter values as text. */
#ifndef TP_SCENE_VALUE_H
#define TP_SCENE_VALUE_H
#include <stddef.h>
#include "tidepool/scene.h"

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

size_t tp_param_number_text(const tp_param *param, int32_t number, char *text,
                            size_t bytes);
#endif
