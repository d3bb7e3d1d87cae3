/* SPDX-License-Identifier: MIT */
/* Searches the components that a program needs.  First all cameras are drawn with all
 * components, by stages that note when they run.  Then the search leaves out components,
 * many at a time, fewer at a time if the result changes, and compares the pictures of a
 * few cameras, at first one, and the worlds of a few moments.  The resulting list is
 * compared on all cameras and moments.  A camera with a different picture joins the few, and
 * the search goes on; if a later world differs, the search begins again with all moments.
 * The search ends with a list that is right for all cameras and moments. */
#include "component_search.h"
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "component_needs.h"
#include "fixed/arithmetic.h"

#define MOMENTS_FEW 3           /* two seconds without a user */

typedef struct {
    const component_search_request *request;
    dry_run         run;
    dry_run_picture *want;          /* picture of each camera, drawn with all components */
    uint32_t       *few;            /* cameras compared at each step of the search */
    uint32_t        n_few;
    component_set   in;             /* current list */
    component_set   needed;         /* components that are never left out */
    component_set   moved;          /* last set that steps worlds as all components do, ... */
    uint32_t        moved_for;      /* ... through so many moments */
    uint32_t        moments;        /* moments compared at each step of the search */
    component_list  list;
    bool            shared;         /* the run is that of request->worlds */
    bool            lean;           /* draw with the reduced assets */
    int             code;           /* error that stopped the search */
} component_search;

/* -- programs ------------------------------------------------------------------------ */

static dry_run_program make_program(component_search *s, const component_set *set)
{
    const component_search_request *request = s->request;

    components_list(&s->list, set, &request->terms);
    return (dry_run_program){ &s->list.program, request->scene,
                              s->lean ? request->lean : request->baked };
}

/* -- comparing ----------------------------------------------------------------------- */

static bool moves_as(const component_set *a, const component_set *b)
{
    for (size_t i = 0; i < component_count; i++)
        if (component_is_in_world(i) && a->has[i] != b->has[i])
            return false;
    return true;
}

static bool has_moving(const component_set *set, const component_set *moving)
{
    for (size_t i = 0; i < component_count; i++)
        if (moving->has[i] && !set->has[i])
            return false;
    return true;
}

/* True if a program steps the worlds as all components do through the first moments.
 * Stepping is slow: a set with the same moving components as the last set is not stepped
 * again. */
static bool moves_same(component_search *s, const component_set *set,
                       const dry_run_program *by, uint32_t moments)
{
    if (s->shared)
        return has_moving(set, &s->request->worlds->moving);
    if (s->moved_for >= moments && moves_as(set, &s->moved))
        return true;
    if (!dry_run_moves_same(&s->run, by, moments))
        return false;
    s->moved = *set;
    s->moved_for = moments;
    return true;
}

/* True if the set gives the right pictures for the few cameras, or for all. */
static bool will_do(component_search *s, const component_set *set, bool all,
                    uint32_t *differs)
{
    const dry_run_program by = make_program(s, set);
    uint32_t first = s->run.cameras;

    if (s->code)
        return false;
    s->code = dry_run_draw(&s->run, &by, all ? NULL : s->few,
                           all ? s->run.cameras : s->n_few, NULL, s->want, &first);
    if (differs)
        *differs = first;
    return !s->code && first == s->run.cameras
           && moves_same(s, set, &by, all ? s->run.moments : s->moments);
}

/* -- leaving out --------------------------------------------------------------------- */

/* Leaves out of s->in as many of the listed components as the few cameras allow. */
static void remove_unneeded(component_search *s, const uint32_t *which, uint32_t count)
{
    component_set less = s->in;

    if (count == 0 || s->code)
        return;
    for (uint32_t i = 0; i < count; i++)
        less.has[which[i]] = false;
    if (will_do(s, &less, false, NULL)) {
        s->in = less;
    } else if (count > 1) {
        remove_unneeded(s, which, count / 2);
        remove_unneeded(s, which + count / 2, count - count / 2);
    }
}

/* Leaves out components until nothing changes.  If two components can replace each other,
 * leaving out either may make a third component needless. */
static void leave_out_all(component_search *s, const component_set *of)
{
    uint32_t which[COMPONENTS_MOST] = { 0 }, count, before;

    do {
        count = before = 0;
        for (size_t i = 0; i < component_count; i++) {
            before += s->in.has[i];
            if (s->in.has[i] && of->has[i] && !s->needed.has[i])
                which[count++] = (uint32_t)i;
        }
        remove_unneeded(s, which, count);
        for (size_t i = 0; i < component_count; i++)
            before -= s->in.has[i];
    } while (before > 0 && !s->code);
}

/* Adds a camera to the few compared cameras.  All components come back; then the search
 * leaves out again the components that the new camera does not need either.  Returns false
 * if the program is wrong even with all components, or after an error (s->code). */
static bool add_camera(component_search *s, uint32_t camera)
{
    const component_set all = components_without(&s->request->without);
    component_set out = { .has = { false } };

    s->few[s->n_few++] = camera;
    if (!will_do(s, &all, false, NULL))
        return false;
    for (size_t i = 0; i < component_count; i++)
        out.has[i] = all.has[i] && !s->in.has[i];
    s->in = all;
    leave_out_all(s, &out);
    return true;
}

static int refuse(const component_search *s, uint32_t camera)
{
    const dry_run_camera *c = &s->run.camera[camera];
    char place[3][16];

    if (s->code)
        return s->code;
    if (camera == s->run.cameras)
        return log_fail(EXIT_CHECK, "tidepool bake: the program's world does not move as"
                                    " with every module");
    if (c->own)
        return log_fail(EXIT_CHECK,
                        "tidepool bake: the scene's own camera sees another picture"
                        " than with every module");
    tp_fx_write(c->eye.x, place[0]);
    tp_fx_write(c->eye.y, place[1]);
    tp_fx_write(c->eye.z, place[2]);
    return log_fail(EXIT_CHECK,
                    "tidepool bake: from %s %s %s the program draws another picture"
                    " than with every module",
                    place[0], place[1], place[2]);
}

/* Leaves out the stages that did not run, then other components. */
static void leave_out_most(component_search *s)
{
    component_set idle = { .has = { false } }, parts = { .has = { false } };

    for (size_t i = 0; i < component_count; i++) {
        idle.has[i] = component_is_stage(i) && !components_have_run(i);
        parts.has[i] = !component_is_stage(i);
    }
    s->in = components_without(&s->request->without);
    leave_out_all(s, &idle);
    leave_out_all(s, &parts);
}

/* Finds a list that is right for all cameras and moments.  False: there is none; *differs:
 * the first camera with a wrong picture. */
static bool narrow(component_search *s, uint32_t *differs)
{
    leave_out_most(s);
    for (*differs = s->run.cameras; !will_do(s, &s->in, true, differs); ) {
        const bool moves = *differs == s->run.cameras;      /* a world differs */
        if (s->code || (moves && s->moments == s->run.moments)
            || (!moves && !add_camera(s, *differs)))
            return false;
        if (moves) {
            s->moments = s->run.moments;
            leave_out_most(s);
        }
    }
    return true;
}

/* Removes the stages of drawings that are left out, and parts without a caller. */
static void tidy(component_set *in)
{
    components_drop_uncalled(in);
    bool drawn = false;

    for (size_t i = 0; i < component_count; i++) {
        if (components[i].kind == COMPONENT_MODULE
            || components[i].kind == COMPONENT_DRAWING)
            drawn = components[i].kind == COMPONENT_DRAWING && in->has[i];
        in->has[i] &= components[i].kind != COMPONENT_MODULE_STAGE || drawn;
    }
}

/* True if worlds of the reduced assets begin the same: a meter reads the first layer. */
static bool lean_worlds_begin_same(component_search *s)
{
    const component_set all = components_without(&s->request->without);
    const dry_run_program by = make_program(s, &all);

    return dry_run_moves_same(&s->run, &by, 1);
}

static int find(component_search *s)
{
    uint32_t differs;

    s->moments = MOMENTS_FEW < s->run.moments ? MOMENTS_FEW : s->run.moments;
    s->needed = components_needed(s->request);
    s->few[s->n_few++] = 0;
    s->lean = s->request->lean != NULL;
    s->lean = s->lean && lean_worlds_begin_same(s);
    if (narrow(s, &differs))
        return EXIT_DONE;
    if (!s->lean || s->code)
        return refuse(s, differs);
    s->lean = false;
    return narrow(s, &differs) ? EXIT_DONE : refuse(s, differs);
}

/* -- missing components -------------------------------------------------------------- */

static bool has_any(const component_set *set)
{
    for (size_t i = 0; i < component_count; i++)
        if (set->has[i])
            return true;
    return false;
}

/* Finds each component of `without` that alone would change a picture or the world. */
static int find_lacks(component_search *s, component_set *lacks)
{
    const component_search_request *request = s->request;
    dry_run_picture *whole = calloc(s->run.cameras, sizeof *whole);
    dry_run_program by = { &s->list.program, request->scene, request->assets };
    component_set    all = { .has = { false } };
    uint32_t     differs;
    int code = whole ? EXIT_DONE : log_fail_memory(s->run.cameras * sizeof *whole);

    for (size_t i = 0; i < component_count; i++)
        all.has[i] = true;
    components_list(&s->list, &all, &request->terms);
    const size_t world = tp_world_bytes(by.program, request->scene, request->assets);
    if (!code)
        code = dry_run_draw(&s->run, &by, NULL, s->run.cameras, whole, NULL, NULL);
    for (size_t i = 0; i < component_count && !code; i++) {
        component_set less = all;
        less.has[i] = false;
        if (!request->without.has[i])
            continue;
        components_list(&s->list, &less, &request->terms);
        code = dry_run_draw(&s->run, &by, NULL, s->run.cameras, NULL, whole, &differs);
        lacks->has[i] =
            differs < s->run.cameras
            || tp_world_bytes(by.program, request->scene, request->assets) != world;
    }
    free(whole);
    return code;
}

static component_set refused_modules(const component_search_request *request,
                                     const component_set *in)
{
    component_set refused = { .has = { false } };

    for (size_t i = 0; i < component_count; i++)
        refused.has[i] = request->terms.checks && components[i].kind == COMPONENT_MODULE
                         && !in->has[i] && !request->without.has[i];
    return refused;
}

/* -- the search ---------------------------------------------------------------------- */

/* Takes known worlds if the scene's begin as they do. */
static int open_run(component_search *s)
{
    const component_search_request *request = s->request;
    const dry_run_program by = { &s->list.program, request->scene, request->assets };

    s->shared = request->worlds && request->worlds->known
                && dry_run_moves_same(&request->worlds->run, &by, 1);
    if (!s->shared)
        return dry_run_open(&s->run, &by, &request->config, request->acts);
    s->run = request->worlds->run;
    return EXIT_DONE;
}

static int open_search(component_search *s, const component_search_request *request)
{
    const component_set all = components_without(&request->without);
    component_list *const list = &s->list;

    *s = (component_search){ .request = request };
    s->moved = all;
    s->moved_for = UINT32_MAX;
    components_list(list, &all, &request->terms);
    int code = open_run(s);
    if (code)
        return code;
    s->want = calloc(s->run.cameras, sizeof *s->want);
    s->few = calloc(2 * s->run.cameras + 3, sizeof *s->few);
    if (!s->want || !s->few)
        return log_fail_memory(s->run.cameras * sizeof *s->want);
    components_list_traced(list, &all, &request->terms);
    components_forget();
    return dry_run_draw(
        &s->run, &(dry_run_program){ &list->program, request->scene, request->assets },
        NULL, s->run.cameras, s->want, NULL, NULL);
}

/* Keeps the run for later searches if they are to take it, else closes it. */
static void close_run(component_search *s, bool found)
{
    component_search_worlds *worlds = s->request->worlds;

    if (s->shared)
        return;
    if (!worlds || worlds->known || !found) {
        dry_run_close(&s->run);
        return;
    }
    *worlds = (component_search_worlds){ .known = true, .run = s->run };
    for (size_t i = 0; i < component_count; i++)
        worlds->moving.has[i] = s->in.has[i] && component_moves(i);
}

static void close_search(component_search *s, bool found)
{
    close_run(s, found);
    free(s->want);
    free(s->few);
}

int component_search_run(component_search_result *found,
                         const component_search_request *request)
{
    component_search s;
    component_set lacks = { .has = { false } };
    int code = open_search(&s, request);

    if (!code)
        code = find(&s);
    if (!code && has_any(&request->without))
        code = find_lacks(&s, &lacks);
    tidy(&s.in);
    *found = (component_search_result){ .in = s.in,
                                        .lacks = lacks,
                                        .refused = refused_modules(request, &s.in),
                                        .lean = s.lean,
                                        .pictures = s.run.cameras };
    close_search(&s, !code);
    return code;
}
