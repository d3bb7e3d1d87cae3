/* SPDX-License-Identifier: MIT */
/* From the command line to a world and a canvas. */
#include "stage.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "../live/setting.h"
#include "say.h"

int stage_read(scene_file *file, const options *o)
{
    int code = scene_file_open(file, o->scene);
    for (uint32_t i = 0; i < o->n_settings && !code; i++)
        code = scene_file_set(file, o->settings[i]);
    if (!code && o->visibility) {
        uint32_t count;
        const tp_param *row = tp_param_find("quality.visibility", 18);
        file->scene.quality.visibility = o->visibility;
        file->set_at[row - tp_params(&count)] = SET_BY_COMMAND;
    }
    return code;
}

/* To three decimals: 16.16 of a sum of people's 0.4 is no round number. */
void stage_report_clamps(const scene_file *file, const tp_sea *sea)
{
    char sum[16];
    if (!sea->clamped)
        return;
    const int64_t thousandths = ((int64_t)sea->steepness * 1000 + 0x8000) >> 16;
    tp_fx_write((tp_fx)((thousandths * 65536 + 500) / 1000), sum);
    say("%s: steepness sum %s is clamped to 0.95", file->name, sum);
}

static int load_assets(assets *a, const scene_file *file, const options *o)
{
    return assets_load(a, file, &(assets_options){
        .texels = o->texels, .strict = o->strict, .quiet = o->quiet });
}

int stage_load(stage *s, const options *o)
{
    memset(s, 0, sizeof *s);
    int code = stage_read(&s->file, o);
    if (!code)
        code = load_assets(&s->assets, &s->file, o);
    if (!code)
        code = stage_world(s);
    if (!code && !o->quiet)
        stage_report_clamps(&s->file, &s->world->sea);
    return code;
}

int stage_open(stage *s, const options *o)
{
    const int code = stage_load(s, o);
    return code ? code : stage_canvas(s, o);
}

/* At tick 0; NULL: no memory, or not of this scene, and *err tells. */
static tp_world *new_world(const tp_scene *scene, const tp_assets *names, size_t *bytes,
                           tp_error *err)
{
    *bytes = tp_world_bytes(scene, names);
    tp_world *world = malloc(*bytes > sizeof *world ? *bytes : sizeof *world);
    if (world && tp_world_init(world, *bytes, scene, names, err) == TP_OK)
        return world;
    free(world);
    return NULL;
}

static void take_world(stage *s, tp_world *world, size_t bytes)
{
    free(s->world);
    s->world = world;
    s->world_bytes = bytes;
}

int stage_world(stage *s)
{
    tp_error err = { 0 };
    size_t bytes;
    tp_world *world = new_world(&s->file.scene, &s->assets.names, &bytes, &err);
    if (!world)
        return err.code ? scene_file_refuse(&s->file, &err) : fail_memory(bytes);
    take_world(s, world, bytes);
    return EXIT_DONE;
}

/* What a board would need beside the picture. */
static size_t bytes_of(const canvas *c, size_t world_bytes)
{
    return c->frame_bytes + world_bytes + c->scratch_bytes;
}

/* Crossings are not stored if there is no room for them. */
static void choose_store(canvas *c, const tp_scene *scene, const tp_assets *names,
                         size_t world_bytes, const options *o)
{
    c->stream = o->stream;
    canvas_count(c, scene, names);
    if (o->memory && bytes_of(c, world_bytes) > o->memory) {
        c->stream = true;
        canvas_count(c, scene, names);
    }
}

/* What the scene names may lie in ROM there. */
static int check_memory(const stage *s, const canvas *c, const assets *a,
                        size_t world_bytes, uint64_t allowed)
{
    const size_t named = a->mesh_bytes + a->texture_bytes;
    const size_t bytes = bytes_of(c, world_bytes);
    char rom[80] = "";
    if (!allowed || bytes <= allowed)
        return EXIT_DONE;
    if (named)
        snprintf(rom, sizeof rom, "; what it names, %zu bytes, is not counted", named);
    return fail(EXIT_INPUT, "%s needs %zu bytes (frame %zu, world %zu, scratch %zu),"
                " --memory allows %" PRIu64 "%s", s->file.name, bytes, c->frame_bytes,
                world_bytes, c->scratch_bytes, allowed, rom);
}

/* Nothing is allocated. */
static int plan_canvas(const stage *s, const options *o, const assets *a,
                       size_t world_bytes, canvas *c)
{
    const tp_frame_config config = {
        .width = o->width, .height = o->height,
        .tile_width = o->strip, .tile_height = o->band,
        .format = o->format,
    };
    canvas_plan(c, &config, o->threads);
    if (o->machine)
        c->machine = o->machine;
    choose_store(c, &s->file.scene, &a->names, world_bytes, o);
    return check_memory(s, c, a, world_bytes, o->memory);
}

static tp_ladder ladder_of(const stage *s)
{
    return tp_ladder_of(&s->file.scene, &s->assets.names, s->canvas.config.width,
                        s->canvas.config.height);
}

int stage_canvas(stage *s, const options *o)
{
    canvas_close(&s->canvas);
    const int code = plan_canvas(s, o, &s->assets, s->world_bytes, &s->canvas);
    s->ladder = ladder_of(s);
    return code ? code : canvas_open(&s->canvas, &s->file.scene, &s->assets.names);
}

void stage_close(stage *s)
{
    canvas_close(&s->canvas);
    free(s->world);
    assets_close(&s->assets);
    scene_file_close(&s->file);
}

/* -- changes while it moves ------------------------------------------------------ */

#define LATER EXIT_CHECK        /* refused as the scene is now, and nothing was said */

typedef struct {
    const options  *o;
    const char     *place;
    bool            later;          /* what may be taken later is refused in silence */
    const tp_param *param;
    uint32_t        row;
    setting_result  result;
    assets         *loaded;         /* what the scene now names; NULL: as before */
    tp_world       *world;          /* made anew; NULL: it goes on */
    size_t          world_bytes;
    size_t          frame_bytes;    /* that the picture wants now */
} change;

static int refuse_change(const change *c, const tp_error *err)
{
    if (c->later && err->code)
        return LATER;
    return err->code ? fail_at(c->place, err) : fail_memory(c->world_bytes);
}

static int load_anew(stage *s, change *c)
{
    assets *loaded = calloc(1, sizeof *loaded);
    if (!loaded)
        return fail_memory(sizeof *loaded);
    if (load_assets(loaded, &s->file, c->o)) {
        free(loaded);
        return EXIT_INPUT;
    }
    c->loaded = loaded;
    return EXIT_DONE;
}

static int world_anew(stage *s, change *c)
{
    const tp_assets *names = c->loaded ? &c->loaded->names : &s->assets.names;
    tp_error err = { 0 };
    c->world = new_world(&s->file.scene, names, &c->world_bytes, &err);
    if (!c->world)
        return refuse_change(c, &err);
    setting_carry(c->world, s->world);
    return EXIT_DONE;
}

/* A picture that would not fit into --memory is refused while the old one is there. */
static int plan_anew(const stage *s, change *c)
{
    const assets *a = c->loaded ? c->loaded : &s->assets;
    canvas plan;
    if (!s->canvas.frame)
        return EXIT_DONE;
    const int code = plan_canvas(s, c->o, a, c->world ? c->world_bytes : s->world_bytes,
                                 &plan);
    c->frame_bytes = plan.frame_bytes;
    return code;
}

/* Frames are planned when they are opened: calm water that was made rough may want other
 * rungs. */
static bool changes_plan(const stage *s)
{
    const tp_ladder now = ladder_of(s);
    return now.count != s->ladder.count
        || memcmp(now.rung, s->ladder.rung, now.count * sizeof *now.rung) != 0;
}

static bool needs_canvas(const stage *s, const change *c)
{
    const canvas *now = &s->canvas;
    if (!now->frame)
        return false;
    return c->result != SETTING_DONE || setting_is_grid(c->param)
        || setting_is_wall(c->param, &s->assets.names)
        || c->frame_bytes != now->frame_bytes || changes_plan(s);
}

static int check_assets(const stage *s, const change *c)
{
    const char *lacking = assets_lack(&s->assets, &s->file);
    return !lacking ? EXIT_DONE : c->later ? LATER : assets_refuse(&s->file, lacking);
}

static int prepare_change(stage *s, change *c)
{
    int code;
    s->file.set_at[c->row] = SET_BY_COMMAND;
    if (c->result == SETTING_LOAD)
        code = load_anew(s, c);
    else
        code = check_assets(s, c);
    if (!code && c->result != SETTING_DONE)
        code = world_anew(s, c);
    return code ? code : plan_anew(s, c);
}

/* Nothing can go wrong any more but memory for the canvas. */
static int do_change(stage *s, change *c, bool *opened)
{
    const bool again = needs_canvas(s, c);
    if (c->loaded)
        assets_move(&s->assets, c->loaded);
    if (c->world)
        take_world(s, c->world, c->world_bytes);
    c->world = NULL;
    *opened = again || *opened;
    return again ? stage_canvas(s, c->o) : EXIT_DONE;
}

static void take_back(stage *s, const change *c, const char *before, uint32_t set_at)
{
    s->file.set_at[c->row] = set_at;
    (void)setting_put(&tp_kit_all, &s->file.scene, s->world, &s->assets.names, c->param,
                      before, strlen(before), NULL);
}

static int set(stage *s, const options *o, const char *place, const char *setting,
               bool later, bool *opened)
{
    char before[TP_NAME_BYTES + 64];
    const char *value;
    uint32_t count;
    tp_error err = { 0 };
    change c = { .o = o, .place = place, .later = later,
                 .param = scene_file_check(place, setting, &value) };
    if (!c.param)
        return EXIT_INPUT;
    c.row = (uint32_t)(c.param - tp_params(&count));
    const uint32_t set_at = s->file.set_at[c.row];
    tp_param_text(&s->file.scene, c.param, before, sizeof before);
    s->file.by = place;
    c.result = setting_put(&tp_kit_all, &s->file.scene, s->world, &s->assets.names,
                           c.param, value, strlen(value), &err);
    int code = c.result == SETTING_REFUSED ? refuse_change(&c, &err)
                                           : prepare_change(s, &c);
    s->file.by = NULL;
    if (code && c.result != SETTING_REFUSED)
        take_back(s, &c, before, set_at);
    else if (!code)
        code = do_change(s, &c, opened);
    free(c.world);
    if (c.loaded)
        assets_close(c.loaded);
    free(c.loaded);
    return code;
}

int stage_set(stage *s, const options *o, const char *place, const char *setting,
              bool *opened)
{
    return set(s, o, place, setting, false, opened);
}

/* Passes over what is left, as long as one of them gets something done. */
int stage_set_all(stage *s, const options *o, const stage_setting *all, size_t count,
                  bool *opened)
{
    bool *done = calloc(count ? count : 1, sizeof *done), later = true;
    int code = done ? EXIT_DONE : fail_memory(count);
    for (size_t left = done ? count : 0; left > 0;) {
        const size_t before = left;
        for (size_t i = 0; i < count; i++) {
            const int one = done[i] ? LATER : set(s, o, all[i].place, all[i].setting,
                                                  later, opened);
            if (one == LATER)
                continue;
            done[i] = true;
            left--;
            code = one ? one : code;
        }
        later = left < before;
    }
    free(done);
    return code;
}
