/* SPDX-License-Identifier: MIT */
/* The `set` command.  A change is made by ports/interact and undone if it would require
 * making the world anew: a board has no memory for a second world, and a failed refresh
 * leaves the world unchanged.
 *
 * Parameters fixed at bake time, files and the grid's size, are refused.  If the frame
 * lacks memory for a change, the change is made, and the reply says that it is drawn in
 * part: tidepool/frame.h lists the features left out.  The reply says nothing if the new
 * setting needs no more memory than the old one (mirror.method from stencil to cube). */
#include "../interact/setting.h"
#include "reply.h"
#include "world/text.h"

static bool may_change(const control *c, const tp_param *param)
{
    if (c->setup->scene && !setting_names_files(param) && !setting_is_grid(param))
        return true;
    reply_text(c, "error ");
    reply_text(c, param->name);
    reply_text(c, c->setup->scene ? " is fixed when a scene is baked\n"
                                  : " cannot change: the scene is constant\n");
    return false;
}

/* Undoes a change that does not fit the world's block or the data that the world was made
 * with. */
static void take_back(const control *c, const tp_param *param, void *number,
                      const void *before)
{
    const control_setup *s = c->setup;
    const size_t bytes = tp_world_bytes(s->config->program, s->scene, s->config->assets);
    reply_text(c, "error ");
    reply_value(c, param);
    if (bytes > s->world_bytes) {
        reply_text(c, " needs ");
        reply_number(c, (uint32_t)bytes);
        reply_text(c, " bytes of the world, which has ");
        reply_number(c, (uint32_t)s->world_bytes);
        reply_text(c, "\n");
    } else {
        reply_text(c, " cannot change in a running world\n");
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
    reply_text(c, "ok ");
    reply_value(c, param);
    if (needs > needed && needs > c->frame_bytes) {
        reply_text(c, ", in part: needs ");
        reply_number(c, needs);
        reply_text(c, " bytes of the frame, which has ");
        reply_number(c, c->frame_bytes);
    }
    reply_text(c, "\n");
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
        reply_value_error(c, param, &err);
        break;
    default:
        take_back(c, param, number, &before);
    }
}
