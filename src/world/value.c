/* SPDX-License-Identifier: MIT */
/*
 * Values as text: string views, and a parameter's value from and to text, by its row in
 * the table (features/all_rows.c).
 */
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "world/text.h"

tp_string_view tp_string_view_trim(tp_string_view piece)
{
    while (piece.bytes > 0 && tp_is_white(*piece.text)) {
        piece.text++;
        piece.bytes--;
    }
    while (piece.bytes > 0 && tp_is_white(piece.text[piece.bytes - 1]))
        piece.bytes--;
    return piece;
}

bool tp_string_view_equals(tp_string_view piece, const char *name)
{
    return tp_string_length(name) == piece.bytes
           && memcmp(name, piece.text, piece.bytes) == 0;
}

bool tp_string_view_has_control(tp_string_view piece)
{
    for (size_t i = 0; i < piece.bytes; i++)
        if ((unsigned char)piece.text[i] < 0x20 || piece.text[i] == 0x7f)
            return true;
    return false;
}

tp_status tp_string_view_read_fx(tp_string_view piece, tp_fx *x)
{
    int beyond = 0;

    if (piece.bytes == 0 || piece.bytes > UINT32_MAX
        || tp_fx_read(piece.text, (uint32_t)piece.bytes, x, &beyond) != piece.bytes)
        return TP_E_NUMBER;
    return beyond ? TP_E_RANGE : TP_OK;
}

/* ---- text to value */

static tp_status read_int(tp_string_view w, int32_t *value)
{
    const bool negative = w.bytes > 0 && w.text[0] == '-';
    const size_t first = w.bytes > 0 && (negative || w.text[0] == '+');
    int64_t sum = 0;
    if (first == w.bytes)
        return TP_E_NUMBER;
    for (size_t i = first; i < w.bytes; i++) {
        if (w.text[i] < '0' || w.text[i] > '9')
            return TP_E_NUMBER;
        if (sum <= INT32_MAX)           /* a sum above the limit stays above the limit */
            sum = sum * 10 + (w.text[i] - '0');
    }
    if (sum > INT32_MAX)
        return TP_E_RANGE;
    *value = (int32_t)(negative ? -sum : sum);
    return TP_OK;
}

static int hex_digit(char c)
{
    return c >= '0' && c <= '9' ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

static tp_status read_colour(tp_string_view w, int32_t *value)
{
    int32_t colour = 0;
    if (w.bytes != 7 || w.text[0] != '#')
        return TP_E_COLOUR;
    for (int i = 1; i < 7; i++) {
        const int digit = hex_digit(w.text[i]);
        if (digit < 0)
            return TP_E_COLOUR;
        colour = colour * 16 + digit;
    }
    *value = colour;
    return TP_OK;
}

/* Reads a word of a list like "nearest|linear"; the value is the word's index. */
static tp_status read_choice(tp_string_view w, const char *list, int32_t *value)
{
    for (int32_t i = 0;; i++) {
        size_t n = 0;
        while (list[n] != '\0' && list[n] != '|')
            n++;
        if (n == w.bytes && memcmp(list, w.text, n) == 0) {
            *value = i;
            return TP_OK;
        }
        if (list[n] == '\0')
            return TP_E_CHOICE;
        list += n + 1;
    }
}

static tp_status read_switch(tp_string_view w, int32_t *value)
{
    const tp_status status = read_choice(w, "off|on|no|yes|false|true|0|1", value);
    if (status == TP_OK)
        *value &= 1;
    return status;
}

static tp_status read_number(const tp_param *param, tp_string_view w, int32_t *value)
{
    tp_status status = TP_OK;
    switch (param->kind) {
    case TP_PARAM_FX:     status = tp_string_view_read_fx(w, value);               break;
    case TP_PARAM_INT:    status = read_int(w, value);                  break;
    case TP_PARAM_BOOL:   status = read_switch(w, value);               break;
    case TP_PARAM_COLOUR: status = read_colour(w, value);               break;
    case TP_PARAM_CHOICE: status = read_choice(w, param->unit, value);  break;
    default:              return TP_E_ARG;
    }
    if (status == TP_OK && (*value < param->low || *value > param->high))
        status = TP_E_RANGE;
    return status;
}

static tp_status check_text(tp_string_view w)
{
    if (w.bytes >= TP_NAME_BYTES)
        return TP_E_LONG;
    return tp_string_view_has_control(w) ? TP_E_TEXT : TP_OK;
}

/* Returns the address of a row's value: an int32_t or a char[TP_NAME_BYTES]. */
static void *value_pointer(tp_scene *scene, const tp_param *param)
{
    TP_ASSERT(param->offset < sizeof *scene);
    return (char *)scene + param->offset;
}

static tp_status set_text(tp_scene *scene, const tp_param *param, tp_string_view w)
{
    const tp_status status = check_text(w);
    if (status != TP_OK)
        return status;
    char *const name = value_pointer(scene, param);
    memset(name, 0, TP_NAME_BYTES);     /* equal scenes must be equal byte by byte */
    memcpy(name, w.text, w.bytes);
    return TP_OK;
}

static tp_status set_number(tp_scene *scene, const tp_param *param, tp_string_view w)
{
    int32_t value = 0;
    const tp_status status = read_number(param, w, &value);
    if (status == TP_OK)
        *(int32_t *)value_pointer(scene, param) = value;
    return status;
}

tp_status tp_scene_set(tp_scene *scene, const char *name, const char *value, tp_error *err)
{
    const void *const given[] = { scene, name, value };
    const char *const names[] = { "scene", "name", "value" };
    for (int i = 0; i < 3; i++)
        if (tp_pointer_check(given[i], names[i], err) != TP_OK)
            return TP_E_NULL;
    const tp_param *param = tp_param_find(name, tp_string_length(name));
    if (!param)
        return tp_error_add_word(err, TP_FAIL(err, TP_E_NAME, 0, 0, 0), name);
    return tp_param_set(scene, param, value, tp_string_length(value), err);
}

tp_status tp_param_set(tp_scene *scene, const tp_param *param, const char *text,
                       size_t bytes, tp_error *err)
{
    TP_ASSERT(scene != NULL && param != NULL && (text != NULL || bytes == 0));
    const tp_string_view w = tp_string_view_trim((tp_string_view){ text, bytes });
    const tp_status status = tp_param_is_text(param) ? set_text(scene, param, w)
                                            : set_number(scene, param, w);
    if (status == TP_OK)
        return TP_OK;
    const bool is_long = status == TP_E_LONG;
    TP_FAIL(err, status, 0, is_long ? TP_NAME_BYTES - 1 : param->low,
            is_long ? 0 : param->high);
    tp_error_set_word(err, w.text, w.bytes);
    return status;
}

/* ---- value to text */

static void put_colour(tp_text *out, int32_t colour)
{
    tp_text_append_char(out, '#');
    for (int shift = 20; shift >= 0; shift -= 4)
        tp_text_append_char(out, "0123456789abcdef"[(uint32_t)colour >> shift & 15]);
}

static void put_choice(tp_text *out, const char *list, int32_t number)
{
    for (; *list != '\0' && number > 0; list++)
        number -= *list == '|';
    for (; *list != '\0' && *list != '|'; list++)
        tp_text_append_char(out, *list);
}

static void put_fx(tp_text *out, tp_fx number)
{
    char digits[16];
    tp_fx_write(number, digits);
    tp_text_append(out, digits);
}

size_t tp_param_number_text(const tp_param *param, int32_t number, char *text,
                            size_t bytes)
{
    tp_text out = tp_text_init(text, bytes);
    switch (param->kind) {
    case TP_PARAM_FX:     put_fx(&out, number);                         break;
    case TP_PARAM_INT:    tp_text_append_int(&out, number);                    break;
    case TP_PARAM_BOOL:   tp_text_append(&out, number != 0 ? "on" : "off"); break;
    case TP_PARAM_COLOUR: put_colour(&out, number);                     break;
    case TP_PARAM_CHOICE: put_choice(&out, param->unit, number);        break;
    default:              tp_text_append(&out, param->text);               break;
    }
    return out.length;
}

size_t tp_param_text(const tp_scene *scene, const tp_param *param, char *text,
                     size_t bytes)
{
    const char *const value = (const char *)scene + param->offset;
    if (!tp_param_is_text(param))
        return tp_param_number_text(param, *(const int32_t *)(const void *)value, text,
                                    bytes);
    tp_text out = tp_text_init(text, bytes);
    tp_text_append(&out, value);
    return out.length;
}

void tp_scene_level(tp_scene *scene)
{
    uint32_t count;
    const tp_param *const rows = tp_params(&count);

    memset(scene, 0, sizeof *scene);
    for (uint32_t i = 0; i < count; i++) {
        const tp_param *const row = &rows[i];
        if (tp_param_is_text(row))
            memcpy(value_pointer(scene, row), row->text, tp_string_length(row->text));
        else
            *(int32_t *)value_pointer(scene, row) = row->normal;
    }
}
