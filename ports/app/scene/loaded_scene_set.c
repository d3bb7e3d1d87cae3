/* SPDX-License-Identifier: MIT */
/* Changes a loaded scene while its world moves.  Every possible refusal is tested before
 * the world is touched: after a refusal only the value has to be restored. */
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "interact/setting.h"
#include "loaded_scene.h"
#include "scene_plan.h"
#include "world/text.h"

#define LATER EXIT_CHECK        /* refused by the present scene, without a message */

typedef struct {
    const options  *o;
    const char     *place;
    bool            later;          /* a later attempt may succeed: no message */
    const tp_param *param;
    setting_result  result;
    asset_set      *loaded;         /* newly loaded assets; NULL: unchanged */
    tp_world       *world;          /* new world; NULL: the world continues */
    size_t          world_bytes;
    size_t          frame_bytes;    /* size of the frame after the change */
} change;

static uint32_t param_row(const tp_param *param)
{
    uint32_t count;
    return (uint32_t)(param - tp_params(&count));
}

loaded_scene_value loaded_scene_get(const loaded_scene *s, const tp_param *param)
{
    loaded_scene_value value = { .set_at = s->file.set_at[param_row(param)] };
    tp_param_text(&s->file.scene, param, value.text, sizeof value.text);
    return value;
}

/* -- tests for refusal --------------------------------------------------------------- */

static int refuse_change(const change *c, const tp_error *err)
{
    if (c->later && err->code)
        return LATER;
    return err->code ? log_fail_error(c->place, err) : log_fail_memory(c->world_bytes);
}

static const asset_set *current_assets(const loaded_scene *s, const change *c)
{
    return c->loaded ? c->loaded : &s->assets;
}

static int load_anew(const loaded_scene *s, change *c)
{
    asset_set *loaded = calloc(1, sizeof *loaded);
    if (!loaded)
        return log_fail_memory(sizeof *loaded);
    if (loaded_scene_load_assets(s, loaded, c->o)) {
        free(loaded);
        return EXIT_INPUT;
    }
    c->loaded = loaded;
    return EXIT_DONE;
}

static int check_assets(const loaded_scene *s, const change *c)
{
    const char *lacking = assets_lack(&s->assets, &s->file);
    return !lacking ? EXIT_DONE : c->later ? LATER : assets_refuse(&s->file, lacking);
}

static int world_anew(const loaded_scene *s, change *c)
{
    tp_error err = { 0 };
    c->world = loaded_scene_new_world(&s->file.scene, &current_assets(s, c)->names,
                                      &c->world_bytes, &err);
    if (!c->world)
        return refuse_change(c, &err);
    setting_carry(c->world, s->world);
    return EXIT_DONE;
}

/* Plans the new frame renderer.  A picture beyond --memory is refused while the old frame
 * renderer still exists.  A bad scene is not reported here: making the world reports the
 * error. */
static int plan_anew(const loaded_scene *s, change *c)
{
    const asset_set *a = current_assets(s, c);
    frame_renderer plan;
    if (!s->renderer.frame
        || tp_world_bytes(&tp_program_all, &s->file.scene, &a->names) == 0)
        return EXIT_DONE;
    const int code = loaded_scene_plan_renderer(s, c->o, a, &plan);
    c->frame_bytes = plan.frame_bytes;
    return code;
}

static int take_change(loaded_scene *s, change *c)
{
    tp_error err = { 0 };
    c->result = setting_take(&tp_program_all, &s->file.scene, s->world, &s->assets.names,
                             c->param, &err);
    if (c->result == SETTING_DONE && c->loaded)
        c->result = SETTING_LOAD;       /* the world refers to the assets */
    return c->result == SETTING_REFUSED ? refuse_change(c, &err)
         : c->result == SETTING_DONE    ? EXIT_DONE : world_anew(s, c);
}

static int try_change(loaded_scene *s, change *c, const loaded_scene_value *value)
{
    tp_error err = { 0 };
    if (tp_param_set(&s->file.scene, c->param, value->text, strlen(value->text), &err))
        return refuse_change(c, &err);
    s->file.set_at[param_row(c->param)] = value->set_at;
    int code = setting_names_files(c->param) ? load_anew(s, c) : check_assets(s, c);
    if (!code)
        code = plan_anew(s, c);
    return code ? code : take_change(s, c);
}

/* -- applying the change ------------------------------------------------------------- */

/* True if the plan or a row of quality changes.  Frames have memory for their own rungs
 * only. */
static bool changes_rungs(const loaded_scene *s)
{
    const frame_renderer *now = &s->renderer;
    const tp_plan plan = scene_plan_renew(s, now->config.width, now->config.height);

    return plan.open != s->plan.open
        || memcmp(&plan.set, &s->plan.set, sizeof plan.set) != 0;
}

static bool needs_canvas(const loaded_scene *s, const change *c)
{
    const frame_renderer *now = &s->renderer;
    if (!now->frame)
        return false;
    return c->result != SETTING_DONE || setting_is_grid(c->param)
        || setting_is_wall(c->param, &s->assets.names)
        || c->frame_bytes != now->frame_bytes || changes_rungs(s);
}

/* Applies the change.  Only lack of memory for the frame renderer can still fail. */
static int do_change(loaded_scene *s, change *c, bool *opened)
{
    const bool again = needs_canvas(s, c);
    if (c->loaded) {
        assets_move(&s->assets, c->loaded);
        assets_close(&s->whole);
    }
    if (c->world)
        loaded_scene_take_world(s, c->world, c->world_bytes);
    c->world = NULL;
    *opened = again || *opened;
    return again ? loaded_scene_open_renderer(s, c->o) : EXIT_DONE;
}

static int put(loaded_scene *s, change *c, const loaded_scene_value *value, bool *opened)
{
    const loaded_scene_value before = loaded_scene_get(s, c->param);
    s->file.by = c->place;
    int code = try_change(s, c, value);
    s->file.by = NULL;
    if (!code) {
        code = do_change(s, c, opened);
    } else {
        (void)tp_param_set(&s->file.scene, c->param, before.text, strlen(before.text),
                           NULL);
        s->file.set_at[param_row(c->param)] = before.set_at;
    }
    free(c->world);
    if (c->loaded)
        assets_close(c->loaded);
    free(c->loaded);
    return code;
}

int loaded_scene_put(loaded_scene *s, const options *o, const char *place,
                     const tp_param *param, const loaded_scene_value *value, bool *opened)
{
    change c = { .o = o, .place = place, .param = param };
    return put(s, &c, value, opened);
}

/* -- by name ------------------------------------------------------------------------- */

/* Returns the value set by hand, without the white space around it. */
static loaded_scene_value normalise_value(const tp_param *param, const char *text)
{
    tp_scene scene = { .title = "" };
    loaded_scene_value value = { .set_at = SET_BY_COMMAND };
    (void)tp_param_set(&scene, param, text, strlen(text), NULL);
    tp_param_text(&scene, param, value.text, sizeof value.text);
    return value;
}

static int set(loaded_scene *s, const options *o, const loaded_scene_setting *setting,
               bool later, bool *opened)
{
    const char *text;
    change c = { .o = o, .place = setting->place, .later = later,
                 .param = scene_file_check(setting->place, setting->setting, &text) };
    if (!c.param)
        return EXIT_INPUT;
    const loaded_scene_value value = normalise_value(c.param, text);
    return put(s, &c, &value, opened);
}

static void report_old_names(const loaded_scene_setting *all, size_t count)
{
    old_name_note note = { .count = 0 };
    for (size_t i = 0; i < count; i++)
        (void)old_name_note_add(&note, all[i].setting, strcspn(all[i].setting, "="), 0);
    old_name_note_print(&note, count ? all->place : "", NULL);
}

int loaded_scene_set(loaded_scene *s, const options *o, const char *place,
                     const char *setting, bool *opened)
{
    const loaded_scene_setting one = { place, setting };
    report_old_names(&one, 1);
    return set(s, o, &one, false, opened);
}

/* Makes passes over the remaining values as long as a pass sets at least one value. */
int loaded_scene_set_all(loaded_scene *s, const options *o,
                         const loaded_scene_setting *all, size_t count, bool *opened)
{
    bool *done = calloc(count ? count : 1, sizeof *done), later = true;
    report_old_names(all, count);
    int code = done ? EXIT_DONE : log_fail_memory(count);
    for (size_t left = done ? count : 0; left > 0;) {
        const size_t before = left;
        for (size_t i = 0; i < count; i++) {
            const int one = done[i] ? LATER : set(s, o, &all[i], later, opened);
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
