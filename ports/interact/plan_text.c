/* SPDX-License-Identifier: MIT */
#include "plan_text.h"
#include "fixed/arithmetic.h"
#include "world/text.h"

void plan_text_add(plan_text *to, const char *text)
{
    for (; *text && to->length + 1 < to->bytes; text++)
        to->text[to->length++] = *text;
    if (to->bytes)
        to->text[to->length] = 0;
}

/* Adds a number of hundredths, "12.31". */
static void add_hundredths(plan_text *to, uint64_t hundredths)
{
    char digits[24];
    size_t at = sizeof digits;

    digits[--at] = 0;
    for (int n = 0; n < 3 || hundredths > 0; n++, hundredths /= 10) {
        digits[--at] = (char)('0' + hundredths % 10);
        if (n == 1)
            digits[--at] = '.';
    }
    plan_text_add(to, digits + at);
}

void plan_text_add_price(plan_text *to, tp_set_price price)
{
    add_hundredths(to, (price.cost + 5000) / 10000);
    plan_text_add(to, " M, off ");
    /* the root of Q16 by 10000 is 256 x 100 of the rms */
    add_hundredths(to, (tp_isqrt64(price.square * 10000) + 128) / 256);
}

static bool same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

static const tp_param *row_of_kind(int kind)
{
    const char *name = tp_rung_kind_row(kind);
    size_t bytes = 0;

    while (name[bytes])
        bytes++;
    return tp_param_find(name, bytes);
}

/* Returns the name of a kind's row from its part after "quality.", if it has one. */
static const char *short_name(int kind)
{
    const char *name = tp_rung_kind_row(kind);

    for (const char *part = "quality."; *part; part++)
        if (*name++ != *part)
            return tp_rung_kind_row(kind);
    return name;
}

void plan_text_add_changes(plan_text *to, const tp_scene *scene, const tp_rung_set *from,
                           const tp_rung_set *with, bool whole)
{
    tp_scene before = *scene, after = *scene;
    const char *between = "";

    tp_rung_set_apply(&before, from);
    tp_rung_set_apply(&after, with);
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        char was[32], is[32];
        tp_param_text(&before, row_of_kind(k), was, sizeof was);
        tp_param_text(&after, row_of_kind(k), is, sizeof is);
        if (same(was, is))
            continue;
        plan_text_add(to, between);
        plan_text_add(to, whole ? tp_rung_kind_row(k) : short_name(k));
        plan_text_add(to, "=");
        plan_text_add(to, is);
        between = " ";
    }
}

void plan_text_add_board(plan_text *to, const board_frame *frame, tp_set_price price,
                         bool real_time)
{
    const board_frame second = { frame->board, 1000000, frame->tick };

    plan_text_add(to, frame->board->name);
    plan_text_add(to, ": ");
    add_hundredths(to, price.cost ? board_frame_budget(&second) * 100 / price.cost : 0);
    plan_text_add(to, real_time ? " pictures a second, keeps quality.frame_ms"
                                : " pictures a second, too slow for quality.frame_ms");
}
