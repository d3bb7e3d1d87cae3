/* SPDX-License-Identifier: MIT */
/* Effects of the actions.  Held actions are not handled here: user_input.c reads them at
 * each tick. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "features/drops/drops.h"
#include "pixel/pixel.h"
#include "view.h"
#include "world/world.h"

#define UI_LEAST 50             /* percent */
#define UI_MOST  400
#define UI_STEP  25
#define SCALES   4

/* Sets the message; say() messages printed before now no longer replace the new message. */
void view_say(view *v, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(v->said, sizeof v->said, format, list);
    va_end(list);
    (void)log_last(&v->said_count);
    v->said_at = 0;
    v->lively = 2;
}

void view_hush(view *v)
{
    v->said[0] = '\0';
}

static void drop(view *v)
{
    if (tp_world_drops(v->loaded->world))
        v->next_input.drops += v->next_input.drops < 1024;
    else
        view_say(v, "this scene has no drops: set drops.count in the panel");
}

static void poke(view *v, uint32_t number)
{
    const tp_scene *scene = &v->loaded->file.scene;
    const tp_push push = poke_point(scene, number);
    if (scene->pool.cols || scene->field.cols)
        view_poke(v, &push);
    else
        view_say(v, "this scene has no pool");
}

static void shift_clock(view *v, int slower)
{
    const int64_t target = v->loaded->world->clock.target;
    const int64_t to = slower > 0 ? target / 2 : target * 2;
    v->next_input.slowdown += slower;
    if (to < TP_CLOCK_SLOWEST || to > TP_CLOCK_FASTEST)
        view_say(v, "this is the %s speed", slower > 0 ? "slowest" : "fastest");
    else if (to >= TP_FX_ONE)
        view_say(v, "speed of time: %d", (int)(to >> 16));
    else
        view_say(v, "speed of time: 1/%d", (int)(TP_FX_ONE / to));
}

static void pause(view *v, bool on)
{
    v->paused = on;
    v->lively = 2;
}

static void next_format(view *v)
{
    options *o = v->options;
    o->format = (tp_format)((o->format + 1) % TP_FORMAT_COUNT);
    o->formatted = true;
    if (view_size(v) == EXIT_DONE)
        view_say(v, "pixels: %s", tp_format_name(o->format));
}

static void next_scale(view *v)
{
    v->scale = v->scale % SCALES + 1;
    if (view_size(v) == EXIT_DONE)
        view_say(v, "pixels %d times as large: %ux%u", v->scale,
                 (unsigned)v->options->width, (unsigned)v->options->height);
}

static void compare_next(view *v, bool against)
{
    compare_how how = compare_get_how(v->compare);
    compare_against other = compare_get_against(v->compare);
    if (!v->compare)
        return;
    if (!against && how == COMPARE_OFF && !v->chosen)
        other = compare_usual(v->loaded);
    if (!against)
        how = (compare_how)((how + 1) % COMPARE_HOWS);
    else
        other = (compare_against)((other + 1) % AGAINSTS);
    v->chosen = v->chosen || against;
    if (how == COMPARE_OFF && against)
        how = COMPARE_SPLIT;
    compare_set(v->compare, how, other);
    view_say(v, how == COMPARE_OFF ? "comparison off" : "%s: %s", compare_how_name[how],
             compare_against_name[other]);
    v->stale = true;
}

static void resize_letters(view *v, int percent)
{
    v->ui = tp_clamp(v->ui + percent, UI_LEAST, UI_MOST);
    if (v->panel)
        panel_scale(v->panel, (float)v->ui / 100);
    v->window.usual = view_panel_width(v);
    if (v->window.panel)
        v->window.panel = v->window.usual;
    view_size(v);
    view_say(v, "letters %d%%", v->ui);
}

static void tape(view *v)
{
    if (v->taping || v->playing) {
        view_untape(v);
        view_say(v, "the tape has ended");
        return;
    }
    view_restart(v);
    path_numbered(v->tape_name, sizeof v->tape_name, v->loaded->file.name, ".tape");
    if (view_tape(v, v->tape_name) != EXIT_DONE)
        return;
    view_tape_changes(v);
    view_say(v, "recording %s", v->tape_name);
}

static void show_panel(view *v, bool on)
{
    if (!v->panel) {
        view_say(v, "built without the panel: it needs Dear ImGui (libimgui-dev)");
        return;
    }
    if (!on)
        v->hidden_panel = v->window.panel;
    v->window.panel = !on ? 0 : v->hidden_panel ? v->hidden_panel : view_panel_width(v);
    if (!on)
        panel_draw(v->panel, NULL);
    view_size(v);
}

static void search(view *v)
{
    if (!v->window.panel)
        show_panel(v, true);
    if (v->panel)
        panel_search(v->panel);
}

/* Opens the scene again, by its list name if listed, to keep its index in the list. */
static void reload(view *v)
{
    const view_scenes *all = &v->scenes;
    view_open(v, all->at < all->count ? all->name[all->at] : v->loaded->file.path);
}

static void leave(view *v)
{
    if (v->control.captured)
        user_input_capture(&v->control, false);
    else if (v->help)
        v->help = false;
    else
        v->quit = true;
}

void view_act(view *v, action what)
{
    v->lively = 2;
    view_hush(v);
    switch (what) {
    case ACT_MOUSE:      user_input_capture(&v->control, !v->control.captured); break;
    case ACT_CAMERA_FREE:  view_look(v, CAMERA_FREE); break;
    case ACT_CAMERA_ORBIT: view_look(v, CAMERA_ORBIT); break;
    case ACT_CAMERA_TOP:   view_look(v, CAMERA_TOP); break;
    case ACT_CAMERA_BOAT:  view_look(v, CAMERA_BOAT); break;
    case ACT_BEGIN_HERE: view_begin_here(v); break;
    case ACT_DROP:       drop(v); break;
    case ACT_POKE1: case ACT_POKE2: case ACT_POKE3:
    case ACT_POKE4: case ACT_POKE5: case ACT_POKE6:
        poke(v, (uint32_t)(what - ACT_POKE1));
        break;
    case ACT_PAUSE:      pause(v, !v->paused); break;
    case ACT_SLOWER:     shift_clock(v, 1); break;
    case ACT_FASTER:     shift_clock(v, -1); break;
    case ACT_STEP:       pause(v, true); view_step(v); break;
    case ACT_STEP_BACK:  pause(v, true); view_back(v); break;
    case ACT_RESTART:    view_restart(v); view_say(v, "restarted"); break;
    case ACT_NEXT_SCENE: view_step_scene(v, 1); break;
    case ACT_LAST_SCENE: view_step_scene(v, -1); break;
    case ACT_RELOAD:     reload(v); break;
    case ACT_SAVE:       view_save(v); break;
    case ACT_UNDO:       view_undo(v, false); break;
    case ACT_REDO:       view_undo(v, true); break;
    case ACT_PANEL:      show_panel(v, !v->window.panel); break;
    case ACT_SIDE:       v->window.left = !v->window.left; show_panel(v, true); break;
    case ACT_SEARCH:     search(v); break;
    case ACT_FIGURES:    v->sheet = !v->sheet; break;
    case ACT_FORMAT:     next_format(v); break;
    case ACT_SCALE:      next_scale(v); break;
    case ACT_COMPARE:    compare_next(v, false); break;
    case ACT_AGAINST:    compare_next(v, true); break;
    case ACT_LARGER:     resize_letters(v, UI_STEP); break;
    case ACT_SMALLER:    resize_letters(v, -UI_STEP); break;
    case ACT_FULL:       v->full = !v->full; window_full(&v->window, v->full); break;
    case ACT_FILM:       view_film(v, !v->film); break;
    case ACT_TAPE:       tape(v); break;
    case ACT_SHOT:       view_save_shot(v); break;
    case ACT_HELP:       v->help = !v->help; break;
    case ACT_QUIT:       leave(v); break;
    default:             break;
    }
}

bool view_is_active(const view *v, action what)
{
    switch (what) {
    case ACT_PAUSE:      return v->paused;
    case ACT_FILM:       return v->film != NULL;
    case ACT_TAPE:       return v->taping || v->playing;
    case ACT_FIGURES:    return v->sheet;
    case ACT_PANEL:      return v->window.panel > 0;
    case ACT_MOUSE:      return v->control.captured;
    case ACT_COMPARE:    return compare_get_how(v->compare) != COMPARE_OFF;
    case ACT_CAMERA_FREE:  return v->camera_mode.mode == CAMERA_FREE;
    case ACT_CAMERA_ORBIT: return v->camera_mode.mode == CAMERA_ORBIT;
    case ACT_CAMERA_TOP:   return v->camera_mode.mode == CAMERA_TOP;
    case ACT_CAMERA_BOAT:  return v->camera_mode.mode == CAMERA_BOAT;
    case ACT_FULL:       return v->full;
    default:             return false;
    }
}
