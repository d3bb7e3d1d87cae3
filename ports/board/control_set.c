/* SPDX-License-Identifier: MIT */
/* `set`: a change is made, the world asked to take it, and taken back if the world
 * cannot: no scene is left half changed.
 *
 * What is fixed when a scene is baked, its files and the grid's points, is refused.  What
 * the frame lacks memory for is set, and said to be drawn in part: tidepool/frame.h tells
 * of each what is left out.  Unsaid is what needs no more memory than what it replaces
 * (mirror.objects from stencil to cube). */
#include "answer.h"

static bool is_fixed(const tp_param *param)
{
    return param->kind == TP_PARAM_MESH || param->kind == TP_PARAM_TEXTURE
        || param->kind == TP_PARAM_GREY
        || param->offset == offsetof(tp_scene, grid.cols)
        || param->offset == offsetof(tp_scene, grid.rows);
}

static bool may_change(const control *c, const tp_param *param)
{
    if (c->setup->scene && !is_fixed(param))
        return true;
    answer(c, "error ");
    answer(c, param->name);
    answer(c, c->setup->scene ? " is fixed when a scene is baked\n"
                              : " cannot change: the scene is constant\n");
    return false;
}

static bool refresh(const control_setup *s)
{
    return tp_world_refresh_with(s->kit, s->world, s->scene, s->assets);
}

/* The camera stands where input has led it, and tp_world_refresh leaves it there. */
static void place_camera(tp_world *world, const tp_scene *scene, uint32_t offset)
{
    static const tp_input still;
    switch (offset) {
    case offsetof(tp_scene, camera.x): world->eye.x = scene->camera.x; break;
    case offsetof(tp_scene, camera.y): world->eye.y = scene->camera.y; break;
    case offsetof(tp_scene, camera.z): world->eye.z = scene->camera.z; break;
    case offsetof(tp_scene, camera.heading):
        world->heading = tp_turn_of_degrees(scene->camera.heading);
        break;
    case offsetof(tp_scene, camera.pitch):
        world->pitch = tp_turn_of_degrees(scene->camera.pitch);
        break;
    default:
        return;
    }
    tp_world_look(world, &still);       /* it jumps: there is no way between */
}

/* Numbers that the world's block has no room for, or that make none. */
static void take_back(const control *c, const tp_param *param, void *number,
                      const void *before)
{
    const control_setup *s = c->setup;
    const size_t bytes = tp_world_bytes_with(s->kit, s->scene, s->assets);
    answer(c, "error ");
    answer_value(c, param);
    if (bytes > s->world->parts.bytes) {
        answer(c, " needs ");
        answer_number(c, (uint32_t)bytes);
        answer(c, " bytes of the world, which has ");
        answer_number(c, s->world->parts.bytes);
        answer(c, "\n");
    } else {
        answer(c, " cannot be had while the water moves\n");
    }
    memcpy(number, before, sizeof(int32_t));
    refresh(s);
}

static uint32_t frame_needs(const control_setup *s)
{
    return (uint32_t)tp_frame_bytes_with(s->kit, s->scene, s->assets, s->config);
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
    if (tp_param_set(s->scene, param, rest.text, rest.bytes, &err)) {
        refuse_value(c, param, &err);
    } else if (!refresh(s)) {
        take_back(c, param, number, &before);
    } else {
        place_camera(s->world, s->scene, param->offset);
        c->changed = true;
        tell(c, param, needed);
    }
}
