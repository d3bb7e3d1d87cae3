/* SPDX-License-Identifier: MIT */
/* Searches the pieces that a program needs.  First all cameras are drawn with all pieces,
 * by stages that note when they run.  Then the search leaves out pieces, many at a time,
 * fewer at a time if the result changes, and compares the pictures of a few cameras.  The
 * resulting list is compared on all cameras.  A camera with a different picture joins the
 * few, and the search goes on.  The search ends with a list that is right for all
 * cameras. */
#include "dry_find.h"
#include "fx/fx.h"
#include <stdlib.h>
#include <string.h>
#include "say.h"

#define FEW 12                  /* number of cameras at first */

typedef struct {
    const dry_wish *wish;
    dry_run         run;
    dry_picture    *want;       /* picture of each camera, drawn with all pieces */
    uint32_t       *few;
    uint32_t        n_few;
    piece_set       in;         /* current list */
    piece_set       needed;     /* pieces that are never left out */
    piece_set       moved;      /* last set with the same world steps as all pieces */
    piece_list      list;
    bool            lean;       /* draw with the reduced assets */
    int             code;       /* error that stopped the search */
} search;

/* -- programs ------------------------------------------------------------------------- */

static bool is_plan(size_t i)
{
    return pieces[i].kind == PIECE_DRAW && strcmp(pieces[i].name, "rungs") == 0;
}

static bool plans(const piece_set *set)
{
    for (size_t i = 0; i < piece_count; i++)
        if (is_plan(i) && set->has[i])
            return true;
    return false;
}

/* Returns the program of a set.  A program without the quality plan draws the scene with
 * named rungs. */
static dry_program make_program(search *s, const piece_set *set)
{
    const dry_wish *wish = s->wish;

    pieces_list(&s->list, set, &wish->terms);
    return (dry_program){ &s->list.program, plans(set) ? wish->scene : wish->named,
                          s->lean ? wish->lean : wish->baked };
}

static piece_set everything(const dry_wish *wish)
{
    piece_set all = { .has = { false } };
    for (size_t i = 0; i < piece_count; i++)
        all.has[i] = !wish->without.has[i];
    return all;
}

/* -- comparing ------------------------------------------------------------------------ */

static bool moves_as(const piece_set *a, const piece_set *b)
{
    for (size_t i = 0; i < piece_count; i++)
        if (piece_moves(i) && a->has[i] != b->has[i])
            return false;
    return true;
}

/* True if a program steps the worlds as all pieces do.  Stepping is slow: a set with the
 * same moving pieces as the last set is not stepped again. */
static bool moves_same(search *s, const piece_set *set, const dry_program *by)
{
    if (moves_as(set, &s->moved))
        return true;
    if (!dry_moves_same(&s->run, by))
        return false;
    s->moved = *set;
    return true;
}

/* True if the set gives the right pictures for the few cameras, or for all. */
static bool will_do(search *s, const piece_set *set, bool all, uint32_t *differs)
{
    const dry_program by = make_program(s, set);
    uint32_t first = s->run.cameras;

    if (s->code)
        return false;
    s->code = dry_draw(&s->run, &by, all ? NULL : s->few,
                       all ? s->run.cameras : s->n_few, NULL, s->want, &first);
    if (differs)
        *differs = first;
    return !s->code && first == s->run.cameras && moves_same(s, set, &by);
}

/* -- pieces needed for sure ----------------------------------------------------------- */

/* A piece is needed if the memory shrinks without the piece, even if the piece is rarely
 * visible.  A module's drawing, with no part in the world, is needed only if its module is
 * needed, or if a user acts there: other cameras may then see the drawing. */
static void need_what_takes_memory(search *s)
{
    const dry_wish *wish = s->wish;
    const piece_set all = everything(wish);
    const dry_program by = make_program(s, &all);
    const size_t world = tp_world_bytes(by.program, wish->scene, wish->assets);
    tp_config config = wish->config;

    config.program = by.program;
    config.assets = wish->assets;
    const size_t frame = tp_frame_bytes(&config, wish->scene);

    for (size_t i = 0, module = 0; i < piece_count; i++) {
        piece_set less = all;
        less.has[i] = false;
        if (!all.has[i] || piece_is_stage(i))
            continue;
        if (pieces[i].kind == PIECE_MODULE)
            module = i;
        pieces_list(&s->list, &less, &wish->terms);
        if (piece_moves(i))
            s->needed.has[i] =
                tp_world_bytes(by.program, wish->scene, wish->assets) != world;
        else if (pieces[i].kind == PIECE_DRAWING
                 && (wish->acts || s->needed.has[module]))
            s->needed.has[i] = tp_frame_bytes(&config, wish->scene) != frame;
        s->needed.has[module] |= pieces[i].kind == PIECE_DRAWING && s->needed.has[i];
    }
}

/* A scene that may change can show more than it shows now: each module that is on stays
 * with its drawing and all its stages.  Fast stages stay only if they have run: exact
 * stages can replace them. */
static void require_active_modules(search *s)
{
    const dry_wish *wish = s->wish;
    const piece_set all = everything(wish);
    bool on = false, fast = false;

    for (size_t i = 0; i < piece_count && wish->terms.checks; i++) {
        if (pieces[i].kind == PIECE_MODULE) {
            on = all.has[i]
                 && (piece_is_active(i, &all, &wish->terms, wish->scene, wish->assets)
                     || piece_is_active(i, &all, &wish->terms, wish->named, wish->baked));
            fast = strcmp(pieces[i].name, "fast_water") == 0;
        }
        s->needed.has[i] |=
            pieces[i].kind >= PIECE_MODULE && on && !(fast && piece_is_stage(i));
    }
}

/* Pieces needed for every picture, and the plan for each program that chooses rungs at run
 * time. */
static void need_always(search *s)
{
    static const char *const always[] = { "sky", "plain" };

    for (size_t i = 0; i < piece_count; i++) {
        for (size_t k = 0; k < sizeof always / sizeof *always; k++)
            s->needed.has[i] |= pieces[i].kind == PIECE_STAGE
                             && strcmp(pieces[i].name, always[k]) == 0;
        s->needed.has[i] |= s->wish->with.has[i] || (is_plan(i) && s->run.ladder.count > 1);
        s->needed.has[i] &= !s->wish->without.has[i];
    }
}

/* -- leaving out ---------------------------------------------------------------------- */

/* Leaves out of s->in as many of the listed pieces as the few cameras allow. */
static void remove_unneeded(search *s, const uint32_t *which, uint32_t count)
{
    piece_set less = s->in;

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

/* Leaves out pieces until nothing changes.  If two pieces can replace each other, leaving
 * out either may make a third piece needless. */
static void leave_out_all(search *s, const piece_set *of)
{
    uint32_t which[PIECES_MOST] = { 0 }, count, before;

    do {
        count = before = 0;
        for (size_t i = 0; i < piece_count; i++) {
            before += s->in.has[i];
            if (s->in.has[i] && of->has[i] && !s->needed.has[i])
                which[count++] = (uint32_t)i;
        }
        remove_unneeded(s, which, count);
        for (size_t i = 0; i < piece_count; i++)
            before -= s->in.has[i];
    } while (before > 0 && !s->code);
}

/* Adds a camera to the few.  All pieces come back, and the pieces that are needless for the
 * new camera too are left out again.  False: the picture is wrong even with all pieces. */
static bool add_camera(search *s, uint32_t camera)
{
    const piece_set all = everything(s->wish);
    piece_set out = { .has = { false } };

    s->few[s->n_few++] = camera;
    if (!will_do(s, &all, false, NULL))
        return false;
    for (size_t i = 0; i < piece_count; i++)
        out.has[i] = all.has[i] && !s->in.has[i];
    s->in = all;
    leave_out_all(s, &out);
    return true;
}

static int refuse(const search *s, uint32_t camera)
{
    const dry_camera *c = &s->run.camera[camera];
    char place[3][16];

    if (s->code)
        return s->code;
    if (camera == s->run.cameras)
        return fail(EXIT_CHECK, "tidepool bake: the program's world does not move as"
                    " with every module");
    if (c->own)
        return fail(EXIT_CHECK, "tidepool bake: the scene's own camera sees another picture"
                    " than with every module");
    tp_fx_write(c->eye.x, place[0]);
    tp_fx_write(c->eye.y, place[1]);
    tp_fx_write(c->eye.z, place[2]);
    return fail(EXIT_CHECK, "tidepool bake: from %s %s %s the program draws another picture"
                " than with every module", place[0], place[1], place[2]);
}

/* Leaves out the stages that did not run, then other pieces.  False: no list is right for
 * all cameras; *differs: the first camera with a wrong picture. */
static bool narrow(search *s, uint32_t *differs)
{
    piece_set idle = { .has = { false } }, parts = { .has = { false } };

    for (size_t i = 0; i < piece_count; i++) {
        idle.has[i] = piece_is_stage(i) && !pieces_ran(i);
        parts.has[i] = !piece_is_stage(i);
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
static void tidy(piece_set *in)
{
    bool drawn = false;

    for (size_t i = 0; i < piece_count; i++) {
        if (pieces[i].kind == PIECE_MODULE || pieces[i].kind == PIECE_DRAWING)
            drawn = pieces[i].kind == PIECE_DRAWING && in->has[i];
        in->has[i] &= pieces[i].kind != PIECE_MODULE_STAGE || drawn;
    }
}

static int find(search *s)
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

/* -- missing pieces ------------------------------------------------------------------- */

static bool has_any(const piece_set *set)
{
    for (size_t i = 0; i < piece_count; i++)
        if (set->has[i])
            return true;
    return false;
}

/* Finds each piece of `without` that alone would change a picture or the world. */
static int find_lacks(search *s, piece_set *lacks)
{
    const dry_wish *wish = s->wish;
    dry_picture *whole = calloc(s->run.cameras, sizeof *whole);
    dry_program by = { &s->list.program, wish->scene, wish->assets };
    piece_set    all = { .has = { false } };
    uint32_t     differs;
    int code = whole ? EXIT_DONE : fail_memory(s->run.cameras * sizeof *whole);

    for (size_t i = 0; i < piece_count; i++)
        all.has[i] = true;
    pieces_list(&s->list, &all, &wish->terms);
    const size_t world = tp_world_bytes(by.program, wish->scene, wish->assets);
    if (!code)
        code = dry_draw(&s->run, &by, NULL, s->run.cameras, whole, NULL, NULL);
    for (size_t i = 0; i < piece_count && !code; i++) {
        piece_set less = all;
        less.has[i] = false;
        if (!wish->without.has[i])
            continue;
        pieces_list(&s->list, &less, &wish->terms);
        code = dry_draw(&s->run, &by, NULL, s->run.cameras, NULL, whole, &differs);
        lacks->has[i] = differs < s->run.cameras
                        || tp_world_bytes(by.program, wish->scene, wish->assets) != world;
    }
    free(whole);
    return code;
}

static piece_set refused_modules(const dry_wish *wish, const piece_set *in)
{
    piece_set refused = { .has = { false } };

    for (size_t i = 0; i < piece_count; i++)
        refused.has[i] = wish->terms.checks && pieces[i].kind == PIECE_MODULE
                         && !in->has[i] && !wish->without.has[i];
    return refused;
}

/* -- the search ----------------------------------------------------------------------- */

static int open_search(search *s, const dry_wish *wish)
{
    const piece_set all = everything(wish);
    piece_list *const list = &s->list;

    *s = (search){ .wish = wish };
    s->moved = all;
    pieces_list(list, &all, &wish->terms);
    int code =
        dry_open(&s->run, &(dry_program){ &list->program, wish->scene, wish->assets },
                 &wish->config, wish->acts);
    if (code)
        return code;
    s->want = calloc(s->run.cameras, sizeof *s->want);
    s->few = calloc(2 * s->run.cameras + FEW + 2, sizeof *s->few);
    if (!s->want || !s->few)
        return fail_memory(s->run.cameras * sizeof *s->want);
    pieces_watch(list, &all, &wish->terms);
    pieces_forget();
    return dry_draw(&s->run, &(dry_program){ &list->program, wish->scene, wish->assets },
                    NULL, s->run.cameras, s->want, NULL, NULL);
}

static void close_search(search *s)
{
    dry_close(&s->run);
    free(s->want);
    free(s->few);
}

int dry_find(dry_found *found, const dry_wish *wish)
{
    search s;
    piece_set lacks = { .has = { false } };
    int code = open_search(&s, wish);

    if (!code)
        code = find(&s);
    if (!code && has_any(&wish->without))
        code = find_lacks(&s, &lacks);
    tidy(&s.in);
    *found = (dry_found){ .in = s.in,
                          .lacks = lacks,
                          .refused = refused_modules(wish, &s.in),
                          .lean = s.lean,
                          .planned = plans(&s.in),
                          .pictures = s.run.cameras };
    close_search(&s);
    return code;
}
