/* SPDX-License-Identifier: MIT */
/* From the command line to a world and a frame renderer. */
#include "loaded_scene.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "pool/pool.h"
#include "scene_plan.h"
#include "set_ladder.h"
#include "tools/bake/program_memory.h"
#include "world/text.h"
#include "world/world.h"

int loaded_scene_read(scene_file *file, const options *o)
{
    int code = scene_file_open(file, o->scene);
    if (!code && o->rung)
        scene_file_set_rung(file, o->rung);
    for (uint32_t i = 0; i < o->n_settings && !code; i++)
        code = scene_file_set(file, o->settings[i]);
    if (!code && o->visibility) {
        uint32_t count;
        const tp_param *row = tp_param_find("quality.visibility", 18);
        file->scene.quality.visibility = o->visibility;
        file->set_at[row - tp_params(&count)] = SET_BY_COMMAND;
    }
    if (!code && !o->quiet)
        scene_file_report_old_names(file);
    return code;
}

/* Reports clamped steepness with three decimals: in 16.16 a sum of decimal values as 0.4 is
 * not a round number. */
static void report_clamps(const scene_file *file, const tp_deep_water *deep)
{
    char sum[16];
    if (!deep->clamped)
        return;
    const int64_t thousandths = ((int64_t)deep->steepness * 1000 + 0x8000) >> 16;
    tp_fx_write((tp_fx)((thousandths * 65536 + 500) / 1000), sum);
    log_line("%s: steepness sum %s is clamped to 0.95", file->name, sum);
}

/* Returns the rounding noise of the steps of a pool at a Courant number of a tick, LSB,
 * 16.16. */
static int64_t step_noise(tp_fx courant, const tp_scene_pool *pool)
{
    return tp_pool_rounding_noise(courant * (1 << pool->interval),
                                  (uint32_t)(pool->damping - pool->interval));
}

/* True if the noise exceeds an eighth of the range: 8-bit cells then show little but their
 * own rounding errors. */
static bool is_noisy(tp_fx courant, const tp_scene_pool *pool)
{
    return step_noise(courant, pool) > 16 * TP_FX_ONE;
}

static void report_noise(const scene_file *file, const tp_scene_pool *pool,
                         const char *courant)
{
    const int64_t noise = step_noise(pool->courant, pool);
    int  thousandths = 50;
    char who[300];

    if (pool->cols == 0 || pool->cell_bits != TP_CELLS_8
        || !is_noisy(pool->courant, pool))
        return;
    while (is_noisy(thousandths * TP_FX_ONE / 1000, pool))
        thousandths++;
    scene_file_who(file, tp_param_find(courant, strlen(courant)), who, sizeof who);
    log_line("%s: 8-bit cells have noise of %d %% of their range; 0.%03d or more, or "
             "cells = 16,"
             " gives less than 13 %%",
             who, (int)((noise * 100 / 127 + 0xffff) >> 16), thousandths);
}

void loaded_scene_report_clamps(const scene_file *file, const tp_deep_water *deep)
{
    report_clamps(file, deep);
    report_noise(file, &file->scene.pool, "pool.courant");
    report_noise(file, &file->scene.field, "field.courant");
}

int loaded_scene_load_assets(const loaded_scene *s, asset_set *a, const options *o)
{
    return assets_load(a, &s->file, &(assets_options){
        .texels = o->texels, .strict = o->strict, .quiet = o->quiet,
        .mesh = s->plan.set.of[TP_KIND_mesh] + 1 });
}

int loaded_scene_load(loaded_scene *s, const options *o)
{
    memset(s, 0, sizeof *s);
    int code = loaded_scene_read(&s->file, o);
    if (!code)
        code = loaded_scene_load_assets(s, &s->assets, o);
    if (!code)
        code = o->stepped ? set_ladder_take(s, o, o->step) : scene_plan_take(s, o);
    if (!code)
        code = loaded_scene_make_world(s);
    if (!code && !o->quiet)
        loaded_scene_report_clamps(&s->file, &s->world->deep);
    return code;
}

int loaded_scene_open(loaded_scene *s, const options *o)
{
    const int code = loaded_scene_load(s, o);
    return code ? code : loaded_scene_open_renderer(s, o);
}

tp_world *loaded_scene_new_world(const tp_scene *scene, const tp_assets *names,
                                 size_t *bytes, tp_error *err)
{
    *bytes = tp_world_bytes(&tp_program_all, scene, names);
    tp_world *world = malloc(*bytes > sizeof *world ? *bytes : sizeof *world);
    if (world
        && tp_world_init(&tp_program_all, world, *bytes, scene, names, err) == TP_OK)
        return world;
    free(world);
    return NULL;
}

void loaded_scene_take_world(loaded_scene *s, tp_world *world, size_t bytes)
{
    free(s->world);
    s->world = world;
    s->world_bytes = bytes;
}

int loaded_scene_make_world(loaded_scene *s)
{
    tp_error err = { 0 };
    size_t bytes;
    tp_world *world =
        loaded_scene_new_world(&s->file.scene, &s->assets.names, &bytes, &err);
    if (!world)
        return err.code ? scene_file_refuse(&s->file, &err) : log_fail_memory(bytes);
    loaded_scene_take_world(s, world, bytes);
    return EXIT_DONE;
}

/* -- memory of a board --------------------------------------------------------------- */

/* Sets the memory of the program that draws as the renderer does, baked for a board. */
static int find_board_memory(program_memory *m, const loaded_scene *s,
                             const frame_renderer *c, const asset_set *a, const options *o)
{
    tp_scene drawn = s->file.scene;
    options baked = *o;

    tp_rung_set_apply_some(&drawn, &c->plan.set, c->plan.open);
    baked.strip = c->config.tile_width;
    baked.band = c->config.tile_height;
    baked.stream = c->stream;
    baked.kept = c->config.kept_bytes;
    return program_memory_find(m, &drawn, &a->names, &baked, NULL);
}

/* Returns the RAM of a board: each thread has a tile and a stack of its own. */
static size_t board_ram(const program_memory *m, const frame_renderer *c)
{
    return program_memory_ram(m) + (c->threads - 1) * (m->tile + m->stack);
}

/* Checks --memory; streams the grid's vertices if they do not fit. */
static int check_memory(const loaded_scene *s, frame_renderer *c, const asset_set *a,
                        const options *o)
{
    program_memory m;

    if (!o->memory)
        return EXIT_DONE;
    int code = find_board_memory(&m, s, c, a, o);
    if (!code && board_ram(&m, c) > o->memory && !c->stream) {
        c->stream = true;
        code = find_board_memory(&m, s, c, a, o);
    }
    if (code || board_ram(&m, c) <= o->memory)
        return code;
    return log_fail(EXIT_INPUT,
                    "%s needs %zu bytes of RAM on a board (frame %zu, tiles %zu, world %zu,"
                    " stacks %zu), --memory allows %" PRIu64
                    "; %zu bytes of flash are not counted",
                    s->file.name, board_ram(&m, c),
                    m.frame + m.vertices + m.tables + m.mirror, c->threads * m.tile,
                    m.world, c->threads * m.stack, o->memory, program_memory_flash(&m));
}

int loaded_scene_plan_renderer(const loaded_scene *s, const options *o,
                               const asset_set *a, frame_renderer *c)
{
    const tp_config config = {
        .width = o->width,
        .height = o->height,
        .tile_width = o->strip,
        .tile_height = o->band,
        .format = o->format,
        .kept_bytes = o->kept,
    };
    frame_renderer_plan(c, &config, o->threads);
    if (o->machine)
        c->machine = o->machine;
    c->plan = scene_plan_renew(s, o->width, o->height);
    c->stream = o->stream;
    const int code = check_memory(s, c, a, o);
    frame_renderer_measure(c, &s->file.scene, &a->names);
    return code;
}

int loaded_scene_open_renderer(loaded_scene *s, const options *o)
{
    frame_renderer_close(&s->renderer);
    const int code =
        loaded_scene_plan_renderer(s, o, &s->assets, &s->renderer);
    s->frame = scene_plan_board_frame(s);
    s->plan = s->renderer.plan;
    return code ? code
                : frame_renderer_open(&s->renderer, &s->file.scene, &s->assets.names);
}

void loaded_scene_close(loaded_scene *s)
{
    frame_renderer_close(&s->renderer);
    free(s->world);
    assets_close(&s->assets);
    assets_close(&s->whole);
    scene_file_close(&s->file);
}
