/* SPDX-License-Identifier: MIT */
/* Tapes: a table names the numbers of tp_input; lines are written and read with this
 * table. */
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "world/text.h"

typedef struct {
    const char *name;
    uint32_t    offset;         /* offset of the int32_t in tp_input */
    bool        whole;          /* true: integer; false: Q16.16 */
    int32_t     low, high;
} field;

#define AT(name)             #name, offsetof(tp_input, name)
#define FX(name)             { AT(name), false, INT32_MIN, INT32_MAX }
#define INT(name, low, high) { AT(name), true, low, high }
#define NAMED(name, at)                                                                  \
    {                                                                                    \
        name, offsetof(tp_input, at), false, INT32_MIN, INT32_MAX                        \
    }
#define PUSH(i, name)                                                                    \
    NAMED(name, push[i].height), NAMED(name "_x", push[i].x), NAMED(name "_z", push[i].z)

static const field fields[] = {
    NAMED("ahead", forward),
    NAMED("aside", strafe),
    FX(up),
    INT(turn, INT32_MIN, INT32_MAX),
    INT(tilt, INT32_MIN, INT32_MAX),
    FX(sphere_x),
    FX(sphere_z),
    INT(drops, 0, 1024),
    FX(throttle),
    FX(rudder),
    PUSH(0, "poke"),
    PUSH(1, "poke2"),
    PUSH(2, "poke3"),
    PUSH(3, "poke4"),
    PUSH(4, "poke5"),
    PUSH(5, "poke6"),
    PUSH(6, "poke7"),
    PUSH(7, "poke8"),
    { "slower", offsetof(tp_input, slowdown), true, INT32_MIN, INT32_MAX },
    INT(light_turn, INT32_MIN, INT32_MAX),
    INT(light_tilt, INT32_MIN, INT32_MAX),
};

enum { FIELDS = sizeof fields / sizeof fields[0] };

_Static_assert(FIELDS * sizeof(int32_t) == sizeof(tp_input), "every input has its row");
_Static_assert(FIELDS <= 64, "a bit of an uint64_t says which were read");

/* -- writing ------------------------------------------------------------------------- */

static int32_t field_value(const tp_input *input, const field *f)
{
    return *(const int32_t *)(const void *)((const char *)input + f->offset);
}

static void put_unsigned(tp_text *out, uint64_t number)
{
    char digits[20];
    int  n = 0;

    do {
        digits[n++] = (char)('0' + number % 10);
        number /= 10;
    } while (number > 0);
    while (n > 0)
        tp_text_append_char(out, digits[--n]);
}

static void put_field(tp_text *out, const field *f, int32_t value)
{
    char digits[16];

    tp_text_append_char(out, ' ');
    tp_text_append(out, f->name);
    tp_text_append_char(out, '=');
    if (f->whole) {
        tp_text_append_int(out, value);
    } else {
        tp_fx_write(value, digits);
        tp_text_append(out, digits);
    }
}

size_t tp_tape_write(const tp_tape_entry *entry, char *text, size_t bytes)
{
    tp_text out = tp_text_init(text, bytes);

    for (int i = 0; i < FIELDS; i++) {
        const int32_t value = field_value(&entry->input, &fields[i]);
        if (value == 0)
            continue;
        if (out.length == 0)
            put_unsigned(&out, entry->tick);
        put_field(&out, &fields[i], value);
    }
    return out.length;
}

/* -- reading ------------------------------------------------------------------------- */

/* Returns the next word of a line and removes the word from the line; 0 bytes at the
 * end. */
static tp_string_view next_word(tp_string_view *line)
{
    while (line->bytes > 0 && tp_is_white(*line->text)) {
        line->text++;
        line->bytes--;
    }
    tp_string_view w = { line->text, 0 };
    while (w.bytes < line->bytes && !tp_is_white(w.text[w.bytes]))
        w.bytes++;
    line->text += w.bytes;
    line->bytes -= w.bytes;
    return w;
}

static tp_status fail_word(tp_error *err, tp_status code, tp_string_view w)
{
    TP_FAIL(err, code, 0, 0, 0);
    tp_error_set_word(err, w.bytes ? w.text : "nothing", w.bytes ? w.bytes : 7);
    return code;
}

/* Reads decimal digits.  TP_E_NUMBER: no digit, or another character.  TP_E_RANGE: above
 * `max`. */
static tp_status read_digits(tp_string_view w, uint64_t max, uint64_t *number)
{
    uint64_t sum = 0;
    bool     beyond = false;

    if (w.bytes == 0)
        return TP_E_NUMBER;
    for (size_t i = 0; i < w.bytes; i++) {
        const char c = w.text[i];
        if (c < '0' || c > '9')
            return TP_E_NUMBER;
        const uint64_t digit = (uint64_t)(c - '0');
        beyond = beyond || sum > (max - digit) / 10;
        sum = beyond ? sum : sum * 10 + digit;
    }
    *number = sum;
    return beyond ? TP_E_RANGE : TP_OK;
}

static tp_status read_signed_integer(tp_string_view w, int32_t *value)
{
    const bool negative = w.bytes > 0 && w.text[0] == '-';
    const size_t sign = negative || (w.bytes > 0 && w.text[0] == '+');
    uint64_t size = 0;
    const tp_status status = read_digits((tp_string_view){ w.text + sign, w.bytes - sign },
                                         (uint64_t)INT32_MAX + negative, &size);
    if (status == TP_OK)
        *value = (int32_t)(negative ? -(int64_t)size : (int64_t)size);
    return status;
}

/* Returns the index of the field with this name, or FIELDS. */
static int find_field(tp_string_view name)
{
    int i = 0;
    while (i < FIELDS && !tp_string_view_equals(name, fields[i].name))
        i++;
    return i;
}

/* Reads NAME=NUMBER into the input. `seen` has a bit for each field read so far. */
static tp_status read_field(tp_input *input, tp_string_view w, uint64_t *seen,
                            tp_error *err)
{
    tp_string_view name = { w.text, 0 };
    int32_t value = 0;

    while (name.bytes < w.bytes && w.text[name.bytes] != '=')
        name.bytes++;
    if (name.bytes == w.bytes || name.bytes == 0)
        return fail_word(err, TP_E_TAPE_VALUE, w);
    const int i = find_field(name);
    if (i == FIELDS)
        return fail_word(err, TP_E_TAPE_NAME, name);
    if (*seen >> i & 1)
        return fail_word(err, TP_E_TAPE_TWICE, name);
    *seen |= (uint64_t)1 << i;

    const field *f = &fields[i];
    const tp_string_view number = { name.text + name.bytes + 1, w.bytes - name.bytes - 1 };
    tp_status status = f->whole ? read_signed_integer(number, &value)
                                : tp_string_view_read_fx(number, &value);
    if (status == TP_OK && (value < f->low || value > f->high))
        status = TP_E_RANGE;
    if (status != TP_OK)
        return fail_word(err, status, status == TP_E_RANGE ? w : number);
    memcpy((char *)input + f->offset, &value, sizeof value);
    return TP_OK;
}

tp_status tp_tape_read(tp_tape_entry *entry, const char *text, size_t bytes,
                       tp_error *err)
{
    TP_ASSERT(entry != NULL && (text != NULL || bytes == 0));
    tp_string_view line = { text, bytes }, w = next_word(&line);
    tp_tape_entry read = { .tick = 0 };
    uint64_t seen = 0;
    tp_status status = read_digits(w, UINT64_MAX, &read.tick);

    if (status != TP_OK)
        return fail_word(err, status == TP_E_RANGE ? status : TP_E_TAPE_TICK, w);
    while ((w = next_word(&line)).bytes > 0) {
        status = read_field(&read.input, w, &seen, err);
        if (status != TP_OK)
            return status;
    }
    *entry = read;
    return TP_OK;
}

/* -- the head ------------------------------------------------------------------------ */

/* Rises when the same inputs give another world or another picture. */
#define TAPE_VERSION "2"

size_t tp_tape_head_write(const char *scene, char *text, size_t bytes)
{
    tp_text out = tp_text_init(text, bytes);
    tp_text_append(&out, "tape " TAPE_VERSION " ");
    tp_text_append(&out, scene);
    return out.length;
}

tp_status tp_tape_head_read(char *scene, size_t room, const char *text, size_t bytes,
                            tp_error *err)
{
    tp_string_view line = { text, bytes };
    const bool tape = tp_string_view_equals(next_word(&line), "tape");
    const tp_string_view version = next_word(&line), first = next_word(&line);
    const tp_string_view name = tp_string_view_trim((tp_string_view){ first.text,
                                                       first.bytes + line.bytes });
    uint64_t number;
    if (!tape || name.bytes == 0 || read_digits(version, UINT64_MAX, &number) != TP_OK)
        return fail_word(err, TP_E_TAPE_HEAD, (tp_string_view){ text, bytes });
    if (!tp_string_view_equals(version, TAPE_VERSION))
        return fail_word(err, TP_E_TAPE_VERSION, version);
    if (tp_string_view_has_control(name))
        return fail_word(err, TP_E_TEXT, name);
    if (name.bytes >= room)
        return TP_FAIL(err, TP_E_LONG, 0, room > 0 ? room - 1 : 0, 0);
    memcpy(scene, name.text, name.bytes);
    scene[name.bytes] = '\0';
    return TP_OK;
}
