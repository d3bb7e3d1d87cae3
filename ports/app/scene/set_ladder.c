/* SPDX-License-Identifier: MIT */
#include "set_ladder.h"
#include <stdio.h>
#include <string.h>
#include "world/text.h"

/* -- steps --------------------------------------------------------------------------- */

/* Writes the rows of quality, mirror and grid by which a scene differs from another. */
static void write_choices(const tp_scene *from, const tp_scene *to, char *text, size_t bytes)
{
    size_t used = 0;

    text[0] = 0;
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        const char *name = tp_rung_kind_row(k);
        const tp_param *row = tp_param_find(name, strlen(name));
        char before[TP_NAME_BYTES + 1], after[TP_NAME_BYTES + 1];
        tp_param_text(from, row, before, sizeof before);
        tp_param_text(to, row, after, sizeof after);
        if (strcmp(before, after) != 0 && used < bytes)
            used += (size_t)snprintf(text + used, bytes - used, "%s%s=%s", used ? " " : "",
                                     name, after);
    }
}

static tp_scene exact_scene(const loaded_scene *s)
{
    static const tp_rung_set exact = { .of = { 0 } };
    tp_scene scene = s->file.scene;

    tp_rung_set_apply(&scene, &exact);
    return scene;
}

static ladder_step step_make(const loaded_scene *s, const tp_rung_set *set,
                             tp_set_price price)
{
    const tp_scene exact = exact_scene(s);
    tp_scene scene = s->file.scene;
    ladder_step step = { .set = *set, .frame = price.cost, .total = -1 };

    tp_rung_set_apply(&scene, set);
    write_choices(&exact, &scene, step.choices, sizeof step.choices);
    return step;
}

static tp_view_costs costs_make(const loaded_scene *s, tp_processor processor,
                                uint32_t width, uint32_t height)
{
    tp_view_costs view;
    const tp_plan_input in = { tp_program_all.modules, &s->file.scene, &s->assets.names,
                               width, height };

    tp_view_costs_make(&view, &tp_prices_measured, &in);
    view.processor = processor;
    return view;
}

void set_ladder_find(set_ladder *ladder, const loaded_scene *s, tp_processor processor,
                     uint32_t width, uint32_t height)
{
    const tp_view_costs view = costs_make(s, processor, width, height);
    uint32_t open;
    const tp_rung_set from = tp_rung_set_named(&s->file.scene, true, &open);
    tp_set_walk walk;

    tp_set_walk_make(&walk, &view, from, open);
    ladder->processor = processor;
    ladder->count = walk.count;
    for (uint32_t i = 0; i < walk.count; i++)
        ladder->step[i] = step_make(s, &walk.set[i], walk.price[i]);
}

bool set_ladder_within(const set_ladder *ladder, const loaded_scene *s, uint32_t width,
                       uint32_t height, uint64_t most, ladder_step *step)
{
    const tp_view_costs view = costs_make(s, ladder->processor, width, height);
    uint32_t open, at = 0;

    tp_rung_set_named(&s->file.scene, true, &open);
    while (at < ladder->count && ladder->step[at].frame > most)
        at++;
    if (at == ladder->count)
        return false;
    tp_rung_set set = ladder->step[at].set;
    tp_set_refine(&view, &set, open, most);
    *step = step_make(s, &set, tp_set_price_estimate(&view, &set));
    return true;
}

int set_ladder_apply(loaded_scene *s, const options *o, const ladder_step *step)
{
    const int32_t mesh = s->file.scene.quality.mesh;

    tp_rung_set_apply(&s->file.scene, &step->set);
    if (s->file.scene.quality.mesh == mesh
        || (mesh <= TP_MESH_FULL && s->file.scene.quality.mesh == TP_MESH_FULL))
        return EXIT_DONE;
    assets_close(&s->assets);
    return loaded_scene_load_assets(&s->assets, &s->file, o);
}

int set_ladder_take(loaded_scene *s, const options *o, uint32_t at)
{
    set_ladder ladder;

    set_ladder_find(&ladder, s, TP_PROCESSOR_M4, o->width, o->height);
    if (at >= ladder.count)
        return log_fail(EXIT_INPUT, "%s: its ladder has steps 0 to %u, --step is %u",
                        s->file.name, (unsigned)ladder.count - 1, (unsigned)at);
    return set_ladder_apply(s, o, &ladder.step[at]);
}
