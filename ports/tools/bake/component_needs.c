/* SPDX-License-Identifier: MIT */
#include "component_needs.h"
#include <string.h>

/* A component is needed if the memory shrinks without the component, even if the
 * component is rarely visible.  A module's drawing, with no part in the world, is needed
 * only if its module is needed, or if a user acts there: other cameras may then see the
 * drawing. */
static void add_memory_users(component_set *needed,
                             const component_search_request *request)
{
    const component_set all = components_without(&request->without);
    component_list list;
    tp_config config = request->config;

    components_list(&list, &all, &request->terms);
    config.program = &list.program;
    config.assets = request->assets;
    const size_t world = tp_world_bytes(&list.program, request->scene, request->assets);
    const size_t frame = tp_frame_bytes(&config, request->scene);

    for (size_t i = 0, module = 0; i < component_count; i++) {
        component_set less = all;
        less.has[i] = false;
        if (!all.has[i] || component_is_stage(i))
            continue;
        if (components[i].kind == COMPONENT_MODULE)
            module = i;
        components_list(&list, &less, &request->terms);
        if (component_is_in_world(i))
            needed->has[i] =
                tp_world_bytes(&list.program, request->scene, request->assets) != world;
        else if (components[i].kind == COMPONENT_DRAWING
                 && (request->acts || needed->has[module]))
            needed->has[i] = tp_frame_bytes(&config, request->scene) != frame;
        needed->has[module] |=
            components[i].kind == COMPONENT_DRAWING && needed->has[i];
    }
}

/* True if the scene switches the module on, with its own assets or those of the program. */
static bool is_module_active(size_t i, const component_set *all,
                             const component_search_request *request)
{
    return component_is_active(i, all, &request->terms, request->scene, request->assets)
           || component_is_active(i, all, &request->terms, request->scene, request->baked);
}

/* A scene that may change can show more than it shows now: each module that is on stays
 * with its drawing and all its stages.  Fast stages stay only if they have run: exact
 * stages can replace them. */
static void add_active_modules(component_set *needed,
                               const component_search_request *request)
{
    const component_set all = components_without(&request->without);
    bool on = false, fast = false;

    for (size_t i = 0; i < component_count && request->terms.checks; i++) {
        if (components[i].kind == COMPONENT_MODULE) {
            on = all.has[i] && is_module_active(i, &all, request);
            fast = strcmp(components[i].name, "fast_water") == 0;
        }
        needed->has[i] |= components[i].kind >= COMPONENT_MODULE && on
                          && !(fast && component_is_stage(i));
    }
}

/* Parts that the compared pictures do not prove to be needless, and the components that call
 * each.  Parts of cameras: only some cameras need them.  Parts of formats and of kept lines:
 * they draw the same bits for fewer instructions. */
enum { OF_CAMERAS = -1, OF_KEPT_LINES = -2 };

static const struct { const char *part, *callers; int of; } kept[] = {
    { "cells", "triangles", OF_CAMERAS }, { "exact_triangles", "cells", OF_CAMERAS },
    { "exact_waves", "triangles", OF_CAMERAS }, { "exact_corners", "cells", OF_CAMERAS },
    { "row_sides", "rows", OF_CAMERAS },
    { "row_middles", "rows", OF_CAMERAS }, { "flat_roll", "flat", OF_CAMERAS },
    { "samples", "swells", OF_CAMERAS },
    { "tone_rgb565", "exposure", TP_FORMAT_RGB565 },
    { "tone_rgb565be", "exposure", TP_FORMAT_RGB565BE },
    { "kept_lines", "triangles walk", OF_KEPT_LINES },
};

enum { KEPT = sizeof kept / sizeof *kept };

static bool is_part(size_t i, const char *name)
{
    return !component_is_stage(i) && components[i].kind < COMPONENT_MODULE
           && !strcmp(components[i].name, name);
}

/* True if the component is one of the callers, names divided by blanks. */
static bool is_caller(size_t i, const char *callers)
{
    const size_t length = strlen(components[i].name);

    for (const char *at = callers; !component_is_stage(i) && *at; ) {
        const size_t word = strcspn(at, " ");
        if (word == length && !strncmp(at, components[i].name, length))
            return true;
        at += word + (at[word] == ' ');
    }
    return false;
}

/* A user, or a scene that may change, meets more cameras than those that are compared. */
static bool is_kept(size_t k, const component_search_request *request)
{
    switch (kept[k].of) {
    case OF_CAMERAS:    return request->acts || request->terms.checks;
    case OF_KEPT_LINES: return request->terms.streams && request->config.kept_bytes;
    default:            return kept[k].of == (int)request->config.format;
    }
}

static void add_kept_parts(component_set *needed, const component_search_request *request)
{
    for (size_t i = 0; i < component_count; i++)
        for (size_t k = 0; k < KEPT; k++)
            needed->has[i] |= is_kept(k, request) && is_part(i, kept[k].part);
}

void components_drop_uncalled(component_set *in)
{
    for (size_t k = 0; k < KEPT; k++) {
        bool called = false;
        for (size_t i = 0; i < component_count; i++)
            called |= in->has[i] && is_caller(i, kept[k].callers);
        for (size_t i = 0; i < component_count; i++)
            in->has[i] &= called || !is_part(i, kept[k].part);
    }
}

/* Every picture needs plain water; the request names others. */
static void add_required(component_set *needed, const component_search_request *request)
{
    static const char *const always[] = { "plain" };

    for (size_t i = 0; i < component_count; i++) {
        for (size_t k = 0; k < sizeof always / sizeof *always; k++)
            needed->has[i] |= components[i].kind == COMPONENT_STAGE
                              && strcmp(components[i].name, always[k]) == 0;
        needed->has[i] |= request->with.has[i];
        needed->has[i] &= !request->without.has[i];
    }
}

component_set components_needed(const component_search_request *request)
{
    component_set needed = { .has = { false } };

    add_memory_users(&needed, request);
    add_active_modules(&needed, request);
    add_kept_parts(&needed, request);
    add_required(&needed, request);
    return needed;
}
