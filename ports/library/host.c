/* SPDX-License-Identifier: MIT */
/* A scene for library callers: loading, values, steps.  Camera modes are in host_look.c,
 * pictures in host_picture.c. */
#include "host.h"
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "frame/tools.h"
#include "world/text.h"
#include "world/world.h"

void host_call_begin(host_call *call, tp_host_error *err)
{
    call->err = err ? err : &call->own;
    log_redirect(call->err->text, sizeof call->err->text);
}

void host_call_end(void)
{
    log_redirect(NULL, 0);
}

/* -- a scene ------------------------------------------------------------------------- */

/* Returns the path to open.  A plain word is a file in the current folder, never a
 * shipped scene. */
static char *explicit_path(const char *path)
{
    const bool plain = !strchr(path, '/') && !path_ends(path, ".ini");
    return plain ? path_join(".", path, "") : path_copy(path, strlen(path));
}

static options make_options(const char *path, const tp_host_config *config)
{
    const bool sized = config->width || config->height;
    return (options){ .scene = path,
                      .width = sized ? config->width : 640,
                      .height = sized ? config->height : 480,
                      .format = config->format,
                      .threads = config->threads };
}

/* Checks the size before any file is read; a frame would refuse it too. */
static int check(const options *o)
{
    const tp_config config = { .width = o->width,
                               .height = o->height,
                               .format = o->format };
    tp_error err = { 0 };
    return tp_config_check(&config, NULL, &err) ? log_fail_error("tp_host_open", &err)
                                                : EXIT_DONE;
}

static int load(tp_host *h)
{
    int code = check(&h->options);
    if (code)
        return code;
    code = loaded_scene_open(&h->loaded, &h->options);
    h->filed = h->loaded.file.scene;
    h->options.scene = NULL; /* the loaded scene has a copy */
    return code;
}

static tp_host *open_path(const char *path, const tp_host_config *config)
{
    tp_host *h = calloc(1, sizeof *h);
    char *name = explicit_path(path);
    if (h && name)
        h->options = make_options(name, config);
    else
        log_fail_memory(sizeof *h);
    const int code = h && name ? load(h) : EXIT_INPUT;
    free(name);
    if (!code)
        return h;
    tp_host_close(h);
    return NULL;
}

tp_host *tp_host_open(const char *path, const tp_host_config *config, tp_host_error *err)
{
    host_call call;
    host_call_begin(&call, err);
    tp_host *h = path ? open_path(path, config ? config : &(tp_host_config){ 0 }) : NULL;
    if (!path)
        log_line("tp_host_open: no path is given");
    host_call_end();
    return h;
}

void tp_host_close(tp_host *host)
{
    if (!host)
        return;
    loaded_scene_close(&host->loaded);
    free(host);
}

const tp_scene *tp_host_scene(const tp_host *host)
{
    return &host->loaded.file.scene;
}

const tp_assets *tp_host_assets(const tp_host *host)
{
    return &host->loaded.assets.names;
}

/* -- values -------------------------------------------------------------------------- */

static char *format_setting(const char *name, const char *value)
{
    const size_t bytes = strlen(name) + strlen(value) + 2;
    char *setting = malloc(bytes);
    if (!setting) {
        log_fail_memory(bytes);
        return NULL;
    }
    strcpy(setting, name);
    strcat(setting, "=");
    return strcat(setting, value);
}

/* Sets a value. camera.follow set by the caller applies to the free camera; other camera
 * modes set their own. */
static int set(tp_host *h, const char *name, const char *setting)
{
    bool opened = false;
    const int code =
        loaded_scene_set(&h->loaded, &h->options, "tp_host_set", setting, &opened);
    if (code || strcmp(name, "camera.follow") != 0)
        return code;
    h->filed.camera.follow = h->loaded.file.scene.camera.follow;
    return host_follow(h);
}

bool tp_host_set(tp_host *host, const char *name, const char *value, tp_host_error *err)
{
    host_call call;
    host_call_begin(&call, err);
    char *setting = format_setting(name, value);
    const int code = setting ? set(host, name, setting) : EXIT_INPUT;
    free(setting);
    host_call_end();
    return !code;
}

static void put_value(const tp_host *host, const tp_param *param, uint32_t set_at,
                      tp_host_value *value)
{
    *value = (tp_host_value){ .name = param->name,
                              .line = set_at == SET_BY_COMMAND ? 0 : set_at,
                              .by_hand = set_at == SET_BY_COMMAND };
    tp_param_text(&host->loaded.file.scene, param, value->value, sizeof value->value);
}

bool tp_host_get(const tp_host *host, const char *name, tp_host_value *value)
{
    uint32_t count;
    const tp_param *params = tp_params(&count),
                   *param = tp_param_find(name, strlen(name));
    if (param)
        put_value(host, param, host->loaded.file.set_at[param - params], value);
    return param != NULL;
}

bool tp_host_changed(const tp_host *host, uint32_t i, tp_host_value *value)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    const uint32_t *set_at = host->loaded.file.set_at;
    for (uint32_t row = 0; row < count; row++) {
        if (set_at[row] && i-- == 0) {
            put_value(host, &params[row], set_at[row], value);
            return true;
        }
    }
    return false;
}

/* -- the water ----------------------------------------------------------------------- */

tp_world *tp_host_world(tp_host *host)
{
    return host->loaded.world;
}

void tp_host_turn(tp_host *host, const tp_input *input)
{
    tp_input bent = input ? *input : (tp_input){ 0 };
    camera_mode_steer(&host->camera_mode, host->loaded.world, &host->loaded.file.scene,
                      &bent);
    tp_world_move_camera(host->loaded.world, &bent);
}

void tp_host_step(tp_host *host, const tp_input *input)
{
    const tp_scene *scene = &host->loaded.file.scene;
    tp_input bent = input ? *input : (tp_input){ 0 };
    uint32_t ticks = tp_world_advance_clock(host->loaded.world);
    if (ticks == 0)
        tp_host_turn(host, &bent);
    for (; ticks > 0; ticks--, bent = (tp_input){ 0 }) {
        poke_take(&host->pokes, scene, &bent);
        camera_mode_steer(&host->camera_mode, host->loaded.world, scene, &bent);
        tp_world_step(&tp_program_all, host->loaded.world, scene, &bent);
    }
}

static bool has_pool(const tp_host *host)
{
    return host->loaded.file.scene.pool.cols > 0;
}

bool tp_host_poke(tp_host *host, tp_fx x, tp_fx z)
{
    const tp_push push = poke_make_push(&host->loaded.file.scene, x, z);
    return has_pool(host) && poke_add(&host->pokes, &push);
}

bool tp_host_stir(tp_host *host, tp_fx x, tp_fx z)
{
    if (has_pool(host))
        poke_stir(&host->pokes, x, z);
    return has_pool(host);
}
