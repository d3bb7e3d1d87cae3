/* SPDX-License-Identifier: MIT */
#include "scene_plan.h"
#include "app/files/log.h"
#include "world_rungs.h"

#define MESH (1u << TP_KIND_mesh)

const tp_assets *scene_plan_assets(const loaded_scene *s)
{
    return s->whole.names.boat ? &s->whole.names : &s->assets.names;
}

board_frame scene_plan_board_frame(const loaded_scene *s)
{
    board_frame frame = board_frame_of_scene(&s->file.scene);
    tick_cost tick = { s->frame.tick, 0 };

    if (frame.board && !s->frame.board)
        world_rungs_tick(&s->file.scene, &s->assets.names, frame.board->priced_as, &tick);
    frame.tick = tick.mean;
    return frame;
}

tp_plan scene_plan_make(const loaded_scene *s, const board_frame *frame, uint32_t width,
                        uint32_t height, bool *real_time)
{
    bool kept;

    if (frame->board)
        return board_plan_make(frame, &s->file.scene, scene_plan_assets(s), width, height,
                               real_time ? real_time : &kept);
    return tp_plan_make(&s->file.scene, scene_plan_assets(s), width, height);
}

int scene_plan_take(loaded_scene *s, const options *o)
{
    s->frame = scene_plan_board_frame(s);
    s->plan = scene_plan_make(s, &s->frame, o->width, o->height, NULL);
    if (!(s->plan.open & MESH) || s->plan.set.of[TP_KIND_mesh] == 0)
        return EXIT_DONE;
    assets_move(&s->whole, &s->assets);
    return loaded_scene_load_assets(s, &s->assets, o);
}

tp_plan scene_plan_renew(const loaded_scene *s, uint32_t width, uint32_t height)
{
    const board_frame frame = scene_plan_board_frame(s);
    tp_plan plan = scene_plan_make(s, &frame, width, height, NULL);

    plan.set.of[TP_KIND_mesh] = s->plan.set.of[TP_KIND_mesh];
    return plan;
}
