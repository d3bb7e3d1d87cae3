/* SPDX-License-Identifier: MIT */
/* Searches the components that a program needs.  First all cameras are drawn with all
 * components, by stages that note when they run.  Then the search leaves out components,
 * many at a time, fewer at a time if the result changes, and compares the pictures of a
 * few cameras.  The resulting list is compared on all cameras.  A camera with a different
 * picture joins the few, and the search goes on.  The search ends with a list that is
 * right for all cameras. */
#include "component_search.h"
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "fixed/arithmetic.h"

#define FEW 12                  /* number of cameras at first */

typedef struct {
    const component_search_request *wish;
    dry_run         run;
    dry_run_picture *want;          /* picture of each camera, drawn with all components */
    uint32_t       *few;
    uint32_t        n_few;
    component_set   in;             /* current list */
    component_set   needed;         /* components that are never left out */
    component_set   moved;          /* last set that steps worlds as all components do */
    component_list  list;
    bool            lean;           /* draw with the reduced assets */
    int             code;           /* error that stopped the search */
} component_search;

/* -- programs ------------------------------------------------------------------------ */

static bool is_plan(size_t i)
{
    return components[i].kind == COMPONENT_DRAW && strcmp(components[i].name, "rungs") == 0;
}

static bool plans(const component_set *set)
{
    for (size_t i = 0; i < component_count; i++)
        if (is_plan(i) && set->has[i])
            return true;
    return false;
}

/* Returns the program of a set.  A program without the quality plan draws the scene with
 * named rungs. */
static dry_run_program make_program(component_search *s, const component_set *set)
{
    const component_search_request *wish = s->wish;

    components_list(&s->list, set, &wish->terms);
    return (dry_run_program){ &s->list.program, plans(set) ? wish->scene : wish->named,
                              s->lean ? wish->lean : wish->baked };
}

static component_set everything(const component_search_request *wish)
{
    component_set all = { .has = { false } };
    for (size_t i = 0; i < component_count; i++)
        all.has[i] = !wish->without.has[i];
    return all;
}

/* -- comparing ----------------------------------------------------------------------- */

static bool moves_as(const component_set *a, const component_set *b)
{
    for (size_t i = 0; i < component_count; i++)
        if (component_is_in_world(i) && a->has[i] != b->has[i])
            return false;
    return true;
}

/* True if a program steps the worlds as all components do.  Stepping is slow: a set with
 * the same moving components as the last set is not stepped again. */
static bool moves_same(component_search *s, const component_set *set,
                       const dry_run_program *by)
{
    if (moves_as(set, &s->moved))
        return true;
    if (!dry_run_moves_same(&s->run, by))
        return false;
    s->moved = *set;
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
    return !s->code && first == s->run.cameras && moves_same(s, set, &by);
}

/* -- components needed for sure ------------------------------------------------------ */

/* A component is needed if the memory shrinks without the component, even if the
 * component is rarely visible.  A module's drawing, with no part in the world, is needed
 * only if its module is needed, or if a user acts there: other cameras may then see the
 * drawing. */
static void need_what_takes_memory(component_search *s)
{
    const component_search_request *wish = s->wish;
    const component_set all = everything(wish);
    const dry_run_program by = make_program(s, &all);
    const size_t world = tp_world_bytes(by.program, wish->scene, wish->assets);
    tp_config config = wish->config;

    config.program = by.program;
    config.assets = wish->assets;
    const size_t frame = tp_frame_bytes(&config, wish->scene);

    for (size_t i = 0, module = 0; i < component_count; i++) {
        component_set less = all;
        less.has[i] = false;
        if (!all.has[i] || component_is_stage(i))
            continue;
        if (components[i].kind == COMPONENT_MODULE)
            module = i;
        components_list(&s->list, &less, &wish->terms);
        if (component_is_in_world(i))
            s->needed.has[i] =
                tp_world_bytes(by.program, wish->scene, wish->assets) != world;
        else if (components[i].kind == COMPONENT_DRAWING
                 && (wish->acts || s->needed.has[module]))
            s->needed.has[i] = tp_frame_bytes(&config, wish->scene) != frame;
        s->needed.has[module] |=
            components[i].kind == COMPONENT_DRAWING && s->needed.has[i];
    }
}

/* A scene that may change can show more than it shows now: each module that is on stays
 * with its drawing and all its stages.  Fast stages stay only if they have run: exact
 * stages can replace them. */
static void require_active_modules(component_search *s)
{
    const component_search_request *wish = s->wish;
    const component_set all = everything(wish);
    bool on = false, fast = false;

    for (size_t i = 0; i < component_count && wish->terms.checks; i++) {
        if (components[i].kind == COMPONENT_MODULE) {
            on = all.has[i]
                 && (component_is_active(i, &all, &wish->terms, wish->scene, wish->assets)
                     || component_is_active(i, &all, &wish->terms, wish->named,
                                            wish->baked));
            fast = strcmp(components[i].name, "fast_water") == 0;
        }
        s->needed.has[i] |= components[i].kind >= COMPONENT_MODULE && on
                            && !(fast && component_is_stage(i));
    }
}

/* Components needed for every picture, and the plan for each program that chooses rungs
 * at run time. */
static void need_always(component_search *s)
{
    static const char *const always[] = { "sky", "plain" };

    for (size_t i = 0; i < component_count; i++) {
        for (size_t k = 0; k < sizeof always / sizeof *always; k++)
            s->needed.has[i] |= components[i].kind == COMPONENT_STAGE
                                && strcmp(components[i].name, always[k]) == 0;
        s->needed.has[i] |= s->wish->with.has[i] || (is_plan(i) && s->run.ladder.count > 1);
        s->needed.has[i] &= !s->wish->without.has[i];
    }
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

/* Adds a camera to the few.  All components come back, and the components that are
 * needless for the new camera too are left out again.  False: the picture is wrong even
 * with all components. */
static bool add_camera(component_search *s, uint32_t camera)
{
    const component_set all = everything(s->wish);
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

/* Leaves out the stages that did not run, then other components.  False: no list is right
 * for all cameras; *differs: the first camera with a wrong picture. */
static bool narrow(component_search *s, uint32_t *differs)
{
    component_set idle = { .has = { false } }, parts = { .has = { false } };

    for (size_t i = 0; i < component_count; i++) {
        idle.has[i] = component_is_stage(i) && !components_have_run(i);
        parts.has[i] = !component_is_stage(i);
    }
    s->in = everything(s->wish);
    leave_out_all(s, &idle);
    leave_out_all(s, &parts);
    for (*differs = s->run.cameras; !will_do(s, &s->in, true, differs); )
        if (s->code || *differs == s->run.cameras || !add_camera(s, *differs))
            return false;
    return true;
}

/* Removes the stages of drawings that are left out. */
static void tidy(component_set *in)
{
    bool drawn = false;

    for (size_t i = 0; i < component_count; i++) {
        if (components[i].kind == COMPONENT_MODULE
            || components[i].kind == COMPONENT_DRAWING)
            drawn = components[i].kind == COMPONENT_DRAWING && in->has[i];
        in->has[i] &= components[i].kind != COMPONENT_MODULE_STAGE || drawn;
    }
}

static int find(component_search *s)
{
    uint32_t differs;

    need_what_takes_memory(s);
    require_active_modules(s);
    need_always(s);
    for (uint32_t i = 0; i < FEW; i++)
        s->few[s->n_few++] = i * (s->run.cameras / FEW + 1) % s->run.cameras;
    s->lean = s->wish->lean != NULL;
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
    const component_search_request *wish = s->wish;
    dry_run_picture *whole = calloc(s->run.cameras, sizeof *whole);
    dry_run_program by = { &s->list.program, wish->scene, wish->assets };
    component_set    all = { .has = { false } };
    uint32_t     differs;
    int code = whole ? EXIT_DONE : log_fail_memory(s->run.cameras * sizeof *whole);

    for (size_t i = 0; i < component_count; i++)
        all.has[i] = true;
    components_list(&s->list, &all, &wish->terms);
    const size_t world = tp_world_bytes(by.program, wish->scene, wish->assets);
    if (!code)
        code = dry_run_draw(&s->run, &by, NULL, s->run.cameras, whole, NULL, NULL);
    for (size_t i = 0; i < component_count && !code; i++) {
        component_set less = all;
        less.has[i] = false;
        if (!wish->without.has[i])
            continue;
        components_list(&s->list, &less, &wish->terms);
        code = dry_run_draw(&s->run, &by, NULL, s->run.cameras, NULL, whole, &differs);
        lacks->has[i] = differs < s->run.cameras
                        || tp_world_bytes(by.program, wish->scene, wish->assets) != world;
    }
    free(whole);
    return code;
}

static component_set refused_modules(const component_search_request *wish,
                                     const component_set *in)
{
    component_set refused = { .has = { false } };

    for (size_t i = 0; i < component_count; i++)
        refused.has[i] = wish->terms.checks && components[i].kind == COMPONENT_MODULE
                         && !in->has[i] && !wish->without.has[i];
    return refused;
}

/* -- the search ---------------------------------------------------------------------- */

static int open_search(component_search *s, const component_search_request *wish)
{
    const component_set all = everything(wish);
    component_list *const list = &s->list;

    *s = (component_search){ .wish = wish };
    s->moved = all;
    components_list(list, &all, &wish->terms);
    int code = dry_run_open(
        &s->run, &(dry_run_program){ &list->program, wish->scene, wish->assets },
        &wish->config, wish->acts);
    if (code)
        return code;
    s->want = calloc(s->run.cameras, sizeof *s->want);
    s->few = calloc(2 * s->run.cameras + FEW + 2, sizeof *s->few);
    if (!s->want || !s->few)
        return log_fail_memory(s->run.cameras * sizeof *s->want);
    components_list_traced(list, &all, &wish->terms);
    components_forget();
    return dry_run_draw(&s->run,
                        &(dry_run_program){ &list->program, wish->scene, wish->assets },
                        NULL, s->run.cameras, s->want, NULL, NULL);
}

static void close_search(component_search *s)
{
    dry_run_close(&s->run);
    free(s->want);
    free(s->few);
}

int component_search_run(component_search_result *found,
                         const component_search_request *wish)
{
    component_search s;
    component_set lacks = { .has = { false } };
    int code = open_search(&s, wish);

    if (!code)
        code = find(&s);
    if (!code && has_any(&wish->without))
        code = find_lacks(&s, &lacks);
    tidy(&s.in);
    *found = (component_search_result){ .in = s.in,
                                        .lacks = lacks,
                                        .refused = refused_modules(wish, &s.in),
                                        .lean = s.lean,
                                        .planned = plans(&s.in),
                                        .pictures = s.run.cameras };
    close_search(&s);
    return code;
}
