/* SPDX-License-Identifier: MIT */
/* `set`: a change is made as ports/live says, and taken back if the world had to be
 * made anew for it, which a board has no memory for: a refresh that failed did nothing.
 *
 * What is fixed when a scene is baked, its files and the grid's points, is refused.  What
 * the frame lacks memory for is set, and said to be drawn in part: tidepool/frame.h tells
 * of each what is left out.  Unsaid is what needs no more memory than what it replaces
 * (mirror.objects from stencil to cube). */
#include "../live/setting.h"
#include "answer.h"
#include "scene/value.h"

static bool may_change(const control *c, const tp_param *param)
{
    if (c->setup->scene && !tp_param_is_file(param) && !setting_is_grid(param))
        return true;
    answer(c, "error ");
    answer(c, param->name);
    answer(c, c->setup->scene ? " is fixed when a scene is baked\n"
                              : " cannot change: the scene is constant\n");
    return false;
}

/* Numbers that the world's block has no room for, or that its parts were made with. */
static void take_back(const control *c, const tp_param *param, void *number,
                      const void *before)
{
    const control_setup *s = c->setup;
    const size_t bytes = tp_world_bytes(s->config->program, s->scene, s->config->assets);
    answer(c, "error ");
    answer_value(c, param);
    if (bytes > s->world_bytes) {
        answer(c, " needs ");
        answer_number(c, (uint32_t)bytes);
        answer(c, " bytes of the world, which has ");
        answer_number(c, (uint32_t)s->world_bytes);
        answer(c, "\n");
    } else {
        answer(c, " cannot be had while the water moves\n");
    }
    memcpy(number, before, sizeof(int32_t));
}

static uint32_t frame_needs(const control_setup *s)
{
    return (uint32_t)tp_frame_bytes(s->config, s->scene);
}

static void tell(const control *c, const tp_param *param, uint32_t needed)
{
    const uint32_t needs = frame_needs(c->setup);
    answer(c, "ok ");
    answer_value(c, param);
    if (needs > needed && needs > c->frame_bytes) {
        answer(c, ", in part: needs ");
        answer_number(c, needs);
        answer(c, " bytes of the frame, which has ");
        answer_number(c, c->frame_bytes);
    }
    answer(c, "\n");
}

void control_set(control *c, control_word rest)
{
    const control_setup *s = c->setup;
    const tp_param *param = control_find(c, control_next(&rest, '='));
    tp_error err = { 0 };
    uint32_t before;

    if (!param || !may_change(c, param))
        return;
    if (rest.bytes > 0 && rest.text[0] == '=') {
        rest.text++;
        rest.bytes--;
    }
    char *number = (char *)s->scene + param->offset;
    const uint32_t needed = frame_needs(s);
    memcpy(&before, number, sizeof before);
    switch (setting_put(s->config->program, s->scene, s->world, s->config->assets, param,
                        rest.text, rest.bytes, &err)) {
    case SETTING_DONE:
        c->changed = true;
        tell(c, param, needed);
        break;
    case SETTING_REFUSED:
        refuse_value(c, param, &err);
        break;
    default:
        take_back(c, param, number, &before);
    }
}
