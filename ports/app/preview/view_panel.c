/* SPDX-License-Identifier: MIT */
/* Callbacks of the panel: values from the table of parameters, actions, and current
 * figures. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/timing.h"
#include "app/scene/scene_save.h"
#include "app/scene/stopwatch.h"
#include "view.h"
#include "world/text.h"

#define PANEL_WIDE 340          /* px at 100% letter size */
#define FILL_US    250000u      /* least interval between updates of the texts */

static panel_row *rows;
static char (*normals)[PANEL_TEXT];     /* default values of the rows, as text */

int view_panel_width(const view *v)
{
    return PANEL_WIDE * v->ui / 100;
}

/* -- values -------------------------------------------------------------------------- */

static const tp_param *row_param(uint32_t row)
{
    uint32_t count;
    return &tp_params(&count)[row];
}

static void get(void *user, uint32_t row, char text[PANEL_TEXT])
{
    const view *v = user;
    tp_param_text(&v->loaded->file.scene, row_param(row), text, PANEL_TEXT);
}

static bool is_same(const tp_scene *a, const tp_scene *b, uint32_t row)
{
    char one[PANEL_TEXT], other[PANEL_TEXT];
    tp_param_text(a, row_param(row), one, sizeof one);
    tp_param_text(b, row_param(row), other, sizeof other);
    return strcmp(one, other) == 0;
}

static void normal_text(const tp_param *param, char text[PANEL_TEXT])
{
    if (tp_param_is_text(param))
        snprintf(text, PANEL_TEXT, "%s", param->text);
    else
        tp_param_number_text(param, param->normal, text, PANEL_TEXT);
}

static bool is_normal(void *user, uint32_t row)
{
    const view *v = user;
    const tp_param *param = row_param(row);
    char text[PANEL_TEXT], normal[PANEL_TEXT];
    tp_param_text(&v->loaded->file.scene, param, text, sizeof text);
    normal_text(param, normal);
    return strcmp(text, normal) == 0;
}

static bool is_filed(void *user, uint32_t row)
{
    const view *v = user;
    return is_same(&v->loaded->file.scene, &v->filed, row);
}

static bool set(void *user, uint32_t row, const char *text, bool going)
{
    return view_set(user, row, text, going);
}

static void reset(void *user, uint32_t row)
{
    const view *v = user;
    const tp_param *param = row_param(row);
    char text[PANEL_TEXT];
    if (!is_filed(user, row))
        tp_param_text(&v->filed, param, text, sizeof text);
    else
        normal_text(param, text);
    view_set(user, row, text, false);
}

/* -- scenes and actions -------------------------------------------------------------- */

static void open_scene(void *user, uint32_t scene)
{
    view *v = user;
    if (scene < v->scenes.count)
        view_open(v, v->scenes.name[scene]);
}

static void act(void *user, int what)
{
    view_act(user, (action)what);
}

static const char *action_keys(void *user, int what)
{
    const view *v = user;
    return v->keys.text[what];
}

static bool is_action_active(void *user, int what)
{
    return view_is_active(user, (action)what);
}

static bool measures(void *user, bool on)
{
    view *v = user;
    v->measures = on;
    return true;
}

/* -- rows ---------------------------------------------------------------------------- */

static panel_row make_panel_row(const tp_param *param, char normal[PANEL_TEXT])
{
    static const panel_kind kinds[] = {
        [TP_PARAM_FX] = PANEL_NUMBER, [TP_PARAM_INT] = PANEL_COUNT,
        [TP_PARAM_BOOL] = PANEL_SWITCH, [TP_PARAM_COLOUR] = PANEL_COLOUR,
        [TP_PARAM_CHOICE] = PANEL_CHOICE, [TP_PARAM_MESH] = PANEL_MESH,
        [TP_PARAM_TEXTURE] = PANEL_PICTURE, [TP_PARAM_GREY] = PANEL_PICTURE,
        [TP_PARAM_TEXT] = PANEL_WORDS,
    };
    const double one = param->kind == TP_PARAM_FX ? 65536 : 1;
    normal_text(param, normal);
    return (panel_row){ param->name, param->unit, param->help, kinds[param->kind],
                        param->low / one, param->high / one, normal };
}

static const char *const *words(char **list)
{
    return (const char *const *)list;
}

void view_panel_open(view *v)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    rows = malloc(count * sizeof *rows);
    normals = malloc(count * sizeof *normals);
    if (!rows || !normals)
        return;
    for (uint32_t i = 0; i < count; i++)
        rows[i] = make_panel_row(&params[i], normals[i]);
    v->host = (panel_host){
        .user = v,
        .row = rows,
        .rows = count,
        .get = get,
        .is_normal = is_normal,
        .is_filed = is_filed,
        .set = set,
        .reset = reset,
        .open = open_scene,
        .act = act,
        .keys = action_keys,
        .is_on = is_action_active,
        .measures = measures,
        .performance = &v->shown,
        .compare = &v->compared,
        .message = "",
        .saved_as = "",
        .scenes = words(v->scenes.name),
        .shows = words(v->scenes.shows),
        .scene_count = v->scenes.count,
        .pictures = words(v->pictures), .picture_count = (uint32_t)v->picture_count,
    };
    v->panel = panel_open(v->window.window, v->window.renderer, &v->host);
    if (v->panel)
        panel_scale(v->panel, (float)v->ui / 100);
}

static void fill_texts(view *v, uint64_t now)
{
    char more[2 * TP_NAME_BYTES + 96];
    if (now - v->filled_at < FILL_US)
        return;
    v->filled_at = now;
    snprintf(more, sizeof more, "%s%s%s%s%s", camera_mode_name(v->camera_mode.mode),
             v->taping ? ", on tape " : v->playing ? ", a tape plays: " : "",
             v->taping ? v->tape.name : v->playing ? v->replay.tape.name : "",
             v->film ? ", filming " : "", v->film ? recorder_name(v->film) : "");
    performance_describe_scene(v->performance, &v->plan, v->loaded, &v->governor);
    performance_describe_world(v->performance, v->loaded, more);
}

void view_panel_fill(view *v, uint64_t now)
{
    v->host.scene = v->scenes.at;
    v->host.name = v->loaded->file.name;
    v->host.about = v->loaded->file.scene.description;
    v->host.saved_as = v->saved_as ? v->saved_as : "";
    v->host.message = v->said;
    v->compared = (panel_compare){
        .off = compare_how_name[compare_get_how(v->compare)],
        .against = compare_against_name[compare_get_against(v->compare)],
        .psnr = compare_psnr(v->compare), .note = compare_note(v->compare),
    };
    if (v->window.panel || v->sheet)
        fill_texts(v, now);
    performance_fill(v->performance, now, &v->shown);
}

void view_panel_close(view *v)
{
    if (v->panel)
        panel_close(v->panel);
    v->panel = NULL;
    free(rows);
    free(normals);
    rows = NULL;
    normals = NULL;
}
