/* SPDX-License-Identifier: MIT */
/* The list of scenes, and opening a scene. */
#define _POSIX_C_SOURCE 200809L
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "app/scene/scene_save.h"
#include "view.h"

/* -- lists --------------------------------------------------------------------------- */

static bool make_room(char ***list, uint32_t count)
{
    char **more = realloc(*list, (count + 1) * sizeof *more);
    *list = more ? more : *list;
    return more;
}

static void add_scene(view *v, const char *folder, const char *name, const char *given)
{
    view_scenes *all = &v->scenes;
    const uint32_t n = all->count;
    char *path = path_join(folder, name, ".ini");
    scene_file file = { 0 };
    const bool room = make_room(&all->name, n) && make_room(&all->shows, n)
                   && make_room(&all->path, n);
    if (!room || !path || (given && scene_file_open(&file, path))) {
        free(path);
        scene_file_close(&file);
        return;
    }
    const char *text = given ? file.scene.description : "an INI file in this folder";
    const char *word = given ? given : path;
    all->shows[n] = path_copy(text, strlen(text));
    all->name[n] = path_copy(word, strlen(word));
    all->path[n] = path;
    all->count += all->shows[n] && all->name[n];
    scene_file_close(&file);
}

static void add_folder(view *v, const char *folder, bool shipped)
{
    size_t count;
    char **names = path_scene_names(folder, &count);
    for (size_t i = 0; i < count; i++)
        add_scene(v, folder, names[i], shipped ? names[i] : NULL);
    path_free_names(names, count);
}

/* Adds PNG files under the names used in shipped scene files: "../textures/foam.png". */
static void add_pictures(view *v, const char *scenes, const char *folder)
{
    size_t count;
    char *path = path_join(scenes, folder, "");
    char **names = path ? path_names(path, ".png", &count) : NULL;
    for (size_t i = 0; names && i < count; i++) {
        char **more = realloc(v->pictures, (v->picture_count + 1) * sizeof *more);
        if (!more)
            break;
        v->pictures = more;
        more[v->picture_count] = path_join(folder, names[i], ".png");
        v->picture_count += more[v->picture_count] != NULL;
    }
    if (names)
        path_free_names(names, count);
    free(path);
}

void view_list(view *v)
{
    char *folder = path_of_scenes();
    if (folder) {
        add_folder(v, folder, true);
        add_pictures(v, folder, "../textures");
        add_pictures(v, folder, "../skies");
        free(folder);
    }
    add_folder(v, ".", false);
}

void view_unlist(view *v)
{
    for (uint32_t i = 0; i < v->scenes.count; i++) {
        free(v->scenes.name[i]);
        free(v->scenes.shows[i]);
        free(v->scenes.path[i]);
    }
    free(v->scenes.name);
    free(v->scenes.shows);
    free(v->scenes.path);
    path_free_names(v->pictures, v->picture_count);
    v->scenes = (view_scenes){ 0 };
    v->pictures = NULL;
    v->picture_count = 0;
}

/* -- opening ------------------------------------------------------------------------- */

/* Sets `at` by comparing files, because --resume gives a path for a scene listed by
 * name. */
static void select_listed_scene(view *v, const char *path)
{
    view_scenes *all = &v->scenes;
    all->at = 0;
    while (all->at < all->count && !path_same_file(all->path[all->at], path))
        all->at++;
}

void view_refit(view *v, bool opened)
{
    if (opened)
        frame_governor_begin(&v->governor, v->loaded);
    compare_forget(v->compare);
    v->stale = true;
}

/* Loads a scene.  The settings of the command line apply to the first scene only. */
static loaded_scene *load(view *v, const char *scene)
{
    options wanted = *v->options;
    loaded_scene *next = calloc(1, sizeof *next);
    wanted.scene = scene;
    if (v->loaded)
        wanted.n_settings = 0;
    if (!next) {
        log_fail_memory(sizeof *next);
        return NULL;
    }
    if (loaded_scene_open(next, &wanted) == EXIT_DONE)
        return next;
    loaded_scene_close(next);
    free(next);
    return NULL;
}

bool view_open(view *v, const char *scene)
{
    scene_file filed;
    loaded_scene *next = load(v, scene), *before = v->loaded;
    if (!next)
        return false;
    if (before) {
        view_film(v, false);
        view_untape(v);
        compare_forget(v->compare);     /* the comparison reads the old loaded scene */
    }
    v->loaded = next;
    v->filed = next->file.scene;
    if (scene_file_open(&filed, scene) == EXIT_DONE)
        v->filed = filed.scene;
    scene_file_close(&filed);
    v->picture = 0;
    v->base = 0;
    v->next_input = (tp_input){ 0 };
    v->pokes = (poke_queue){ 0 };
    v->changed = false;
    rewind_forget(v->history);
    undo_edits_clear(&v->edits);
    v->camera_mode = (camera_mode){ .mode = CAMERA_FREE };
    select_listed_scene(v, next->file.path);
    if (before)                         /* only now: `scene` may point into it */
        loaded_scene_close(before);
    free(before);
    free(v->saved_as);
    v->saved_as = scene_save_name(&next->file);
    view_refit(v, true);
    return true;
}

void view_step_scene(view *v, int by)
{
    const uint32_t count = v->scenes.count;
    if (count == 0)
        return;
    const uint32_t at = v->scenes.at < count ? v->scenes.at : by > 0 ? count - 1 : 0;
    const uint32_t to = (at + count + (uint32_t)by) % count;
    if (view_open(v, v->scenes.name[to]))
        view_say(v, "%s: %s", v->scenes.name[to], v->scenes.shows[to]);
    v->scenes.at = to;
}
