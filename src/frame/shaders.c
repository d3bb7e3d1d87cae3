/* SPDX-License-Identifier: MIT */
/* Shader lists; see shaders.h. */
#include "frame/shaders.h"

void tp_shaders_init(tp_shaders *list, tp_list_kind kind, tp_shader *shader,
                     uint8_t *place, uint32_t room)
{
    *list = (tp_shaders){ .shader = shader, .order = place, .kind = (uint8_t)kind,
                          .room = (uint8_t)room };
    tp_shaders_clear(list);
}

void tp_shaders_clear(tp_shaders *list)
{
    list->shader[0] = (tp_shader){ NULL, NULL };
    list->count = 0;
    list->rippled = list->shines = false;
    list->lacks = list->lacking = 0;
}

void tp_shaders_add(tp_shaders *list, tp_shader_order place, tp_stage stage,
                    const void *mine)
{
    uint32_t at = list->count;

    if (!stage) {
        list->lacks++;
        return;
    }
    TP_ASSERT(list->count + 1 < list->room);
    list->shader[++list->count] = (tp_shader){ NULL, NULL };
    for (; at > 0 && list->order[at - 1] > place; at--) {
        list->shader[at] = list->shader[at - 1];
        list->order[at] = list->order[at - 1];
    }
    list->shader[at] = (tp_shader){ stage, mine };
    list->order[at] = (uint8_t)place;
}

tp_stage tp_shaders_pick(tp_shaders *list, tp_stage wanted, tp_stage plainer)
{
    if (wanted)
        return wanted;
    list->lacks++;
    return plainer;
}

bool tp_shaders_has(const tp_shaders *list, tp_shader_order place)
{
    for (uint32_t i = 0; i < list->count; i++)
        if (list->order[i] == place)
            return true;
    return false;
}
