/* SPDX-License-Identifier: MIT */
/* Words of a command line, and pieces of its reply.  Pieces are sent at once: the reply
 * needs no buffer. */
#include "reply.h"
#include "base/base.h"
#include "world/text.h"

/* -- words --------------------------------------------------------------------------- */

static bool is_blank(char byte)
{
    return byte == ' ' || byte == '\t';
}

control_word control_next(control_word *rest, char end)
{
    control_word word = { rest->text, 0 };
    size_t n = 0;
    while (n < rest->bytes && !is_blank(rest->text[n]) && rest->text[n] != end)
        n++;
    word.bytes = n;
    while (n < rest->bytes && is_blank(rest->text[n]))
        n++;
    rest->text += n;
    rest->bytes -= n;
    return word;
}

bool control_is(control_word word, const char *name)
{
    size_t n = 0;
    while (n < word.bytes && name[n] != '\0' && word.text[n] == name[n])
        n++;
    return n == word.bytes && name[n] == '\0';
}

const tp_param *control_find(const control *c, control_word name)
{
    const tp_param *param = c->setup->find ? c->setup->find(name.text, name.bytes)
                                           : tp_param_find(name.text, name.bytes);
    tp_error err = { .code = TP_E_NAME };
    tp_error_set_word(&err, name.text, name.bytes);
    if (!param) {
        reply_input_error(c, &err);
    } else if (!control_is(name, param->name)) {
        reply_text(c, err.word);
        reply_text(c, " is now called ");
        reply_text(c, param->name);
        reply_text(c, "\n");
    }
    return param;
}

/* -- replies ------------------------------------------------------------------------- */

void reply_text(const control *c, const char *text)
{
    c->setup->write(c->setup->to, text);
}

void reply_number(const control *c, uint32_t number)
{
    char  text[11];
    char *at = text + sizeof text - 1;
    *at = '\0';
    do {
        *--at = (char)('0' + number % 10);
    } while (number /= 10);
    reply_text(c, at);
}

static void answer_unit(const control *c, const tp_param *param)
{
    if (param->kind != TP_PARAM_CHOICE && param->unit[0]) {
        reply_text(c, " ");
        reply_text(c, param->unit);
    }
}

void reply_value(const control *c, const tp_param *param)
{
    char text[TP_NAME_BYTES];
    tp_param_text(c->setup->shown, param, text, sizeof text);
    reply_text(c, param->name);
    reply_text(c, " = ");
    reply_text(c, text);
    answer_unit(c, param);
}

void reply_range(const control *c, const char *before, const tp_param *param)
{
    char text[16];
    if (param->kind == TP_PARAM_BOOL || param->kind == TP_PARAM_CHOICE) {
        reply_text(c, before);
        reply_text(c, param->kind == TP_PARAM_BOOL ? "off|on" : param->unit);
    } else if (param->kind == TP_PARAM_FX || param->kind == TP_PARAM_INT) {
        reply_text(c, before);
        tp_param_number_text(param, param->low, text, sizeof text);
        reply_text(c, text);
        reply_text(c, "..");
        tp_param_number_text(param, param->high, text, sizeof text);
        reply_text(c, text);
    }
}

void reply_error(const control *c, const char *why)
{
    reply_text(c, "error ");
    reply_text(c, why);
    reply_text(c, "\n");
}

void reply_input_error(const control *c, const tp_error *err)
{
    char text[160];
    tp_error_text(err, text, sizeof text);
    reply_error(c, text);
}

void reply_value_error(const control *c, const tp_param *param, const tp_error *err)
{
    char text[160];
    reply_text(c, "error ");
    reply_text(c, param->name);
    switch (err->code) {
    case TP_E_RANGE:
    case TP_E_CHOICE:
        reply_text(c, " = ");
        reply_text(c, err->word);
        reply_range(c, err->code == TP_E_RANGE ? " is outside " : " is none of ", param);
        answer_unit(c, param);
        break;
    default:
        tp_error_text(err, text, sizeof text);
        reply_text(c, ": ");
        reply_text(c, text);
    }
    reply_text(c, "\n");
}
