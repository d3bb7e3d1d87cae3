/* SPDX-License-Identifier: MIT */
#include "world_rungs.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A change of a scene; returns false if there is nothing to change. */
typedef bool change(tp_scene *scene);

static bool slice_foam(tp_scene *s)
{
    const bool has = s->foam.cells > 0 && s->foam.slices < 4;

    s->foam.slices = has ? 4 : s->foam.slices;
    return has;
}

/* Steps take twice as long; the checks of pools tell if the Courant number allows it. */
static bool double_interval(tp_scene_pool *p)
{
    const bool has = p->cols > 0 && p->interval < 2;

    p->interval += has;
    return has;
}

/* Returns twice a length, m; a whole number of millimetres if the double of the rounded
 * length is next to one. */
static tp_fx twice_length(tp_fx length)
{
    const int64_t millimetres = ((int64_t)length * 2000 + 0x8000) >> 16;
    const tp_fx whole = (tp_fx)((millimetres * 65536 + 500) / 1000), twice = 2 * length;

    return tp_abs(whole - twice) <= 1 ? whole : twice;
}

/* Half as many cells a side, of twice the side.  The Courant number is halved with the cell,
 * so waves keep their speed, and steps of twice the ticks keep that of a step. */
static bool halve_cells(tp_scene_pool *p)
{
    if (p->cols < 32 || p->rows < 32 || p->cols % 2 || p->rows % 2
        || p->cell > 25 * TP_FX_ONE || p->courant < TP_FX(0.1) || p->interval > 1
        || p->damping - p->interval < 5)
        return false;
    p->cols /= 2;
    p->rows /= 2;
    p->cell = twice_length(p->cell);
    p->courant = (p->courant + 1) / 2;
    p->interval++;
    if (p->boundary == TP_EDGES_SPONGE)
        p->sponge = p->sponge / 2 > 4 ? p->sponge / 2 : 4;
    return true;
}

/* Cells of 16 bits round where cells of 32 bits keep every volume. */
static bool narrow_cells(tp_scene_pool *p)
{
    const bool has = p->cols > 0 && p->cell_bits == TP_CELLS_32;

    p->cell_bits = has ? TP_CELLS_16 : p->cell_bits;
    return has;
}

static bool double_pool_interval(tp_scene *s)  { return double_interval(&s->pool); }
static bool double_field_interval(tp_scene *s) { return double_interval(&s->field); }
static bool halve_pool(tp_scene *s)   { return halve_cells(&s->pool); }
static bool halve_field(tp_scene *s)  { return halve_cells(&s->field); }
static bool narrow_pool(tp_scene *s)  { return narrow_cells(&s->pool); }
static bool narrow_field(tp_scene *s) { return narrow_cells(&s->field); }

static change *const changes[] = {
    slice_foam, narrow_pool, double_pool_interval, halve_pool,
    narrow_field, double_field_interval, halve_field,
};

/* Writes the rows by which two scenes differ as settings. */
static void write_settings(const tp_scene *from, const tp_scene *to, char *text, size_t bytes)
{
    uint32_t rows;
    const tp_param *row = tp_params(&rows);
    size_t used = 0;

    text[0] = 0;
    for (uint32_t i = 0; i < rows; i++) {
        char before[TP_NAME_BYTES + 1], after[TP_NAME_BYTES + 1];
        tp_param_text(from, &row[i], before, sizeof before);
        tp_param_text(to, &row[i], after, sizeof after);
        if (strcmp(before, after) == 0 || used >= bytes)
            continue;
        used += (size_t)snprintf(text + used, bytes - used, "%s%s=%s", used ? " " : "",
                                 row[i].name, after);
    }
}

/* Moves the last rung to its place by cost, the cheapest first. */
static void sort_last(world_rungs *to)
{
    for (int i = to->count - 1; i > 0; i--) {
        const world_rung rung = to->rung[i];
        if (to->rung[i - 1].cost.mean <= rung.cost.mean)
            return;
        to->rung[i] = to->rung[i - 1];
        to->rung[i - 1] = rung;
    }
}

bool world_rungs_tick(const tp_scene *scene, const tp_assets *assets,
                      tp_processor processor, tick_cost *cost)
{
    size_t bytes;
    tp_world *world = loaded_scene_new_world(scene, assets, &bytes, &(tp_error){ 0 });

    if (!world)
        return false;
    *cost = tick_cost_estimate(world, scene, processor);
    free(world);
    return true;
}

/* Adds the changed scene if its world can be made and its ticks cost less. */
static bool add_rung(world_rungs *to, const loaded_scene *s, const tp_scene *scene,
                     tp_processor processor, bool all)
{
    world_rung *rung = &to->rung[to->count];

    if (!world_rungs_tick(scene, &s->assets.names, processor, &rung->cost)
        || rung->cost.mean >= to->now.mean)
        return false;
    write_settings(&s->file.scene, scene, rung->text, sizeof rung->text);
    rung->all = all;
    to->count++;
    if (!all)
        sort_last(to);
    return true;
}

world_rungs world_rungs_find(const loaded_scene *s, tp_processor processor)
{
    const tp_scene *scene = &s->file.scene;
    world_rungs found = { .count = 0 };
    tp_scene all = *scene;

    if ((scene->pool.cols == 0 && scene->field.cols == 0 && scene->foam.cells == 0)
        || !world_rungs_tick(scene, &s->assets.names, processor, &found.now))
        return found;
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        tp_scene changed = *scene;
        if (changes[i](&changed) && add_rung(&found, s, &changed, processor, false))
            changes[i](&all);
    }
    if (found.count > 1)
        add_rung(&found, s, &all, processor, true);
    return found;
}
