/* SPDX-License-Identifier: MIT */
/*
 * Values and tapes as text: string views of user text, as in settings and tapes; the
 * values of parameters; the lines of tapes.  The text of a view is not terminated.  White
 * space is the space character and the characters from tab to carriage return.
 */
#ifndef TP_WORLD_TEXT_H
#define TP_WORLD_TEXT_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/scene.h"
#include "tidepool/status.h"
#include "tidepool/world.h"

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

/* -- tapes --------------------------------------------------------------------------- */

/* Inputs by tick as lines of text, for bit-exact replays.
 *
 *     tape 2 three-swells
 *     120 ahead=0.05 turn=-1200
 *     121 drops=1
 *     122 poke=0.3 poke_x=1.5 poke_z=-2 poke2=0.3 poke2_x=-1.5
 *
 * The head names the format and the scene.  A line holds a tick and the members of
 * tp_input with a value other than 0, by name.  Height and position of push[0] are poke,
 * poke_x and poke_z; push[1] to push[7] use poke2 ... poke8_z.  Ticks increase.  Q16.16
 * numbers are written with enough digits to read back the same bits. */

#define TP_TAPE_LINE 1024       /* longest line in bytes, line end included */

typedef struct {
    uint64_t tick;              /* tick before the step with this input; 0: first step */
    tp_input input;
} tp_tape_entry;

/* Writes the line of an entry, terminated, without line end, cut to `bytes`.  Returns the
 * whole length of the line.  Returns 0 if no input is set; such an entry needs no line. */
size_t tp_tape_write(const tp_tape_entry *entry, char *text, size_t bytes);

/* Reads a line of `bytes` bytes without line end: a tick, then name=number in any order,
 * each name at most once, separated by white space.  On failure err->word is the wrong
 * word and *entry does not change.  A line with a tick only is an entry without input. */
tp_status tp_tape_read(tp_tape_entry *entry, const char *text, size_t bytes,
                       tp_error *err);

/* Writes the head line "tape 2 SCENE", terminated and cut like tp_tape_write.  A scene's
 * name is any text without control characters, not empty, without white space at its
 * ends. */
size_t tp_tape_head_write(const char *scene, char *text, size_t bytes);

/* Reads the scene's name from a head line into `scene` of `room` bytes.  TP_E_LONG:
 * `room` is too small.  TP_E_TAPE_VERSION: the tape was recorded by a version that draws
 * other pictures. */
tp_status tp_tape_head_read(char *scene, size_t room, const char *text, size_t bytes,
                            tp_error *err);

#endif
