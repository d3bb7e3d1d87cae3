/* SPDX-License-Identifier: MIT */
#include "plan_sheet.h"
#include <string.h>
#include "fixed/arithmetic.h"
#include "interact/plan_text.h"
#include "scene_plan.h"
#include "world/text.h"

#define MESH (1u << TP_KIND_mesh)

double plan_error(tp_set_price price)
{
    return (double)tp_isqrt64(price.square * 10000) / 25600;
}

static void make_view(tp_view_costs *view, const loaded_scene *s)
{
    const tp_config *config = &s->renderer.config;

    tp_plan_view(view, &s->file.scene, scene_plan_assets(s), config->width,
                 config->height);
    if (s->frame.board)
        view->processor = s->frame.board->priced_as;
}

void plan_sheet_make_walk(tp_set_walk *walk, const loaded_scene *s)
{
    const tp_plan *plan = &s->plan;
    tp_view_costs view;

    make_view(&view, s);
    tp_set_walk_make(walk, &view, plan->set, plan->open & ~MESH);
}

void plan_sheet_make(plan_sheet *p, const loaded_scene *s)
{
    const tp_config *config = &s->renderer.config;
    const tp_rung_set exact = { .of = { 0 } };

    p->plan = scene_plan_make(s, &s->frame, config->width, config->height, &p->real_time);
    p->plan.set.of[TP_KIND_mesh] = s->plan.set.of[TP_KIND_mesh];
    make_view(&p->view, s);
    p->plan.price = tp_set_price_estimate(&p->view, &p->plan.set);
    p->exact = tp_set_price_estimate(&p->view, &exact);
    tp_set_walk_make(&p->walk, &p->view, p->plan.set, p->plan.open & ~MESH);
}

static void write_word(const tp_scene *scene, int kind, char *word, size_t bytes)
{
    const char *name = tp_rung_kind_row(kind);

    tp_param_text(scene, tp_param_find(name, strlen(name)), word, bytes);
}

plan_kind plan_sheet_kind(const plan_sheet *p, const tp_scene *scene, int kind)
{
    tp_scene drawn = *scene;
    tp_rung_set without = p->plan.set;

    without.of[kind] = 0;
    tp_rung_set_apply(&drawn, &p->plan.set);
    const tp_set_price price = tp_set_price_estimate(&p->view, &without);
    const uint64_t now = p->plan.price.square;
    const tp_set_price more = { 0, now > price.square ? now - price.square : 0 };
    plan_kind of = { .named = !(p->plan.open >> kind & 1),
                     .saves = (double)price.cost - (double)p->plan.price.cost,
                     .adds = plan_error(more) };
    write_word(&drawn, kind, of.word, sizeof of.word);
    return of;
}

void plan_write_changes(const tp_scene *scene, const tp_rung_set *from,
                        const tp_rung_set *to, char *text, size_t bytes)
{
    plan_text rows = { text, bytes, 0 };

    plan_text_add(&rows, "");
    plan_text_add_changes(&rows, scene, from, to, true);
}
