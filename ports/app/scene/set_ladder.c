/* SPDX-License-Identifier: MIT */
#include "set_ladder.h"
#include "plan_sheet.h"
#include "scene_plan.h"

/* -- steps --------------------------------------------------------------------------- */

static ladder_step step_make(const loaded_scene *s, const tp_rung_set *set,
                             tp_set_price price)
{
    static const tp_rung_set exact = { .of = { 0 } };
    ladder_step step = { .set = *set, .price = price, .total = -1 };

    plan_write_changes(&s->file.scene, &exact, set, step.choices, sizeof step.choices);
    return step;
}

void set_ladder_find(set_ladder *ladder, const loaded_scene *s, uint32_t width,
                     uint32_t height)
{
    const tp_scene *scene = &s->file.scene;
    tp_view_costs view;
    tp_set_walk walk = { .count = 0 };
    uint32_t open;
    const tp_rung_set from = tp_rung_set_named(scene, true, &open);

    if (tp_plan_view(&view, scene, scene_plan_assets(s), width, height))
        tp_set_walk_make(&walk, &view, from, open);
    ladder->count = walk.count;
    for (uint32_t i = 0; i < walk.count; i++)
        ladder->step[i] = step_make(s, &walk.set[i], walk.price[i]);
}

ladder_step set_ladder_step(const loaded_scene *s, const tp_plan *plan)
{
    return step_make(s, &plan->set, plan->price);
}

/* Returns the rung of the boat's mesh that is loaded. */
static uint8_t loaded_mesh(const loaded_scene *s)
{
    const int32_t named = s->file.scene.quality.mesh;

    return named ? (uint8_t)(named - 1) : s->plan.set.of[TP_KIND_mesh];
}

int set_ladder_apply(loaded_scene *s, const options *o, const ladder_step *step)
{
    const bool same = loaded_mesh(s) == step->set.of[TP_KIND_mesh];

    tp_rung_set_apply(&s->file.scene, &step->set);
    s->file.scene.quality.board = TP_BOARD_none;    /* its rows are named now */
    s->plan = (tp_plan){ .set = step->set, .price = step->price };
    if (same)
        return EXIT_DONE;
    assets_close(&s->assets);
    return loaded_scene_load_assets(s, &s->assets, o);
}

int set_ladder_take(loaded_scene *s, const options *o, uint32_t at)
{
    set_ladder ladder;

    set_ladder_find(&ladder, s, o->width, o->height);
    if (at >= ladder.count)
        return log_fail(EXIT_INPUT, "%s: its ladder has steps 0 to %u, --step is %u",
                        s->file.name, (unsigned)ladder.count - 1, (unsigned)at);
    return set_ladder_apply(s, o, &ladder.step[at]);
}
