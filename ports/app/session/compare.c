/* SPDX-License-Identifier: MIT */
/* A second frame renderer draws the other picture: of the loaded scene's world, with a copy
 * of the scene that has other values in quality.*.  Or the reference renderer draws the
 * other picture (reference_thread.h).
 *
 * The reference is ports/tools/reference.  Tests judge pictures by the reference; for this
 * view the reference is linked into the program.  It draws the correct picture, by rays
 * that meet the exact surface. */
#include "compare.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/timing.h"
#include "app/scene/scene_plan.h"
#include "image_diff.h"
#include "reference_thread.h"

#define JUDGE_US 250000u        /* us between two plans; a plan takes 10 ms */

const char *const compare_how_name[COMPARE_HOWS] = { "off", "split", "difference" };
const char *const compare_against_name[AGAINSTS] = {
    "exact", "triangles", "rows", "projected", "flat", "quick", "layers", "colour",
    "reference",
};

struct comparison {
    compare_how how;
    compare_against against;
    tp_scene given;             /* copy of the loaded scene's scene when `scene` was made */
    tp_scene scene;             /* scene of the other renderer: differs in quality.* */
    frame_renderer other;
    bool     open, failed;      /* of `other`; failed: no memory, until a change */
    uint64_t judged_at;
    bool     judged, unfit;
    bool     same;              /* both pictures are drawn with the same rungs */
    reference_thread *reference;
    bool     delivered;         /* the reference thread has delivered a complete picture */
    reference_pass pass;        /* pass of the reference's picture in `theirs` */
    uint32_t *ours, *theirs;    /* pixels 0x00RRGGBB */
    picture  shown;
    double   psnr;
    char     note[128];
};

/* -- choice of the other picture ----------------------------------------------------- */

/* Returns the rungs of the other picture, with the mesh that is loaded: those of the loaded
 * scene with triangles, or exact rungs but one. */
static tp_rung_set choose_rungs(compare_against against, const loaded_scene *s)
{
    const tp_rung_set *own = &s->renderer.plan.set;
    tp_rung_set set = { .of = { [TP_KIND_mesh] = own->of[TP_KIND_mesh] } };

    switch (against) {
    case AGAINST_TRIANGLES:
        set = *own;
        set.of[TP_KIND_VISIBILITY] = TP_VISIBILITY_TRIANGLES - 1;
        break;
    case AGAINST_ROWS:
        set.of[TP_KIND_VISIBILITY] = TP_VISIBILITY_ROWS - 1;
        break;
    case AGAINST_PROJECTED:
        set.of[TP_KIND_VISIBILITY] = TP_VISIBILITY_PROJECTED - 1;
        break;
    case AGAINST_FLAT:
        set.of[TP_KIND_VISIBILITY] = TP_VISIBILITY_FLAT - 1;
        break;
    case AGAINST_LAYERS: set.of[TP_KIND_RATE] = TP_RATE_LAYERS - 1; break;
    case AGAINST_COLOUR: set.of[TP_KIND_RATE] = TP_RATE_COLOUR - 1; break;
    default:             break;
    }
    if (against == AGAINST_QUICK || set.of[TP_KIND_RATE])
        set.of[TP_KIND_SHADING] = TP_SHADING_QUICK - 1;
    return set;
}

static bool same_rungs(const tp_rung_set *a, const tp_rung_set *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

static void name_rungs(comparison *c, const loaded_scene *s)
{
    const tp_rung_set set = choose_rungs(c->against, s);

    c->same = same_rungs(&set, &s->renderer.plan.set);
    tp_rung_set_apply_some(&c->scene, &set, UINT32_MAX);
}

/* True if the view or a feature of the scene rules the rungs out: exact ones are drawn. */
static bool is_unfit(const loaded_scene *s, compare_against against)
{
    const picture *p = &s->renderer.picture;
    const tp_rung_set set = choose_rungs(against, s);
    tp_view_costs view;

    tp_plan_view(&view, &s->file.scene, scene_plan_assets(s), p->width, p->height);
    return !view.estimate.fits[set.of[TP_KIND_VISIBILITY]]
        || (set.of[TP_KIND_SHADING] && !tp_set_is_fast(&view, &set));
}

static void judge(comparison *c, const loaded_scene *s)
{
    if (c->judged || now_us() - c->judged_at < JUDGE_US)
        return;
    c->unfit = is_unfit(s, c->against);
    c->judged = true;
    c->judged_at = now_us();
}

compare_against compare_usual(const loaded_scene *s)
{
    if (s->renderer.picture.format != TP_FORMAT_XRGB8888
        || s->renderer.plan.price.square > 0)
        return AGAINST_EXACT;
    return is_unfit(s, AGAINST_QUICK) ? AGAINST_REFERENCE : AGAINST_QUICK;
}

/* -- memory -------------------------------------------------------------------------- */

static void discard(comparison *c)
{
    reference_thread_end(c->reference);
    c->reference = NULL;
    if (c->open)
        frame_renderer_close(&c->other);
    c->open = c->failed = c->judged = c->same = c->delivered = false;
}

void compare_forget(comparison *c)
{
    discard(c);
    c->pass = REFERENCE_NONE;
    c->psnr = -1;
}

comparison *compare_begin(void)
{
    comparison *c = calloc(1, sizeof *c);

    if (c)
        c->psnr = -1;
    return c;
}

void compare_end(comparison *c)
{
    if (!c)
        return;
    discard(c);
    free(c->ours);
    free(c->theirs);
    free(c->shown.rows);
    free(c);
}

void compare_set(comparison *c, compare_how how, compare_against against)
{
    if (against != c->against || how == COMPARE_OFF)
        compare_forget(c);
    if (against != c->against) {
        c->unfit = false;
        c->judged_at = 0;
    }
    c->how = how;
    c->against = against;
}

/* Allocates the pictures; false: no memory. */
static bool resize(comparison *c, uint32_t width, uint32_t height)
{
    const size_t bytes = (size_t)width * height * sizeof *c->ours;

    free(c->ours);
    free(c->theirs);
    free(c->shown.rows);
    c->ours = malloc(bytes);
    c->theirs = malloc(bytes);
    c->shown = (picture){ TP_FORMAT_XRGB8888, width, height, (size_t)width * 4,
                          malloc(bytes) };
    if (c->ours && c->theirs && c->shown.rows)
        return true;
    c->shown.width = 0;
    return false;
}

/* Adopts the loaded scene's size and scene.  False: no memory. */
static bool follow(comparison *c, const loaded_scene *s)
{
    const picture *p = &s->renderer.picture;
    const bool sized = c->shown.width == p->width && c->shown.height == p->height;

    if (sized && memcmp(&c->given, &s->file.scene, sizeof c->given) == 0)
        return !c->failed;
    compare_forget(c);
    memcpy(&c->given, &s->file.scene, sizeof c->given);
    memcpy(&c->scene, &s->file.scene, sizeof c->scene);
    c->failed = !sized && !resize(c, p->width, p->height);
    return !c->failed;
}

/* -- drawing the other picture ------------------------------------------------------- */

static bool open_other(comparison *c, const loaded_scene *s)
{
    tp_config config = s->renderer.config;

    config.format = TP_FORMAT_XRGB8888;
    name_rungs(c, s);
    frame_renderer_plan(&c->other, &config, s->renderer.threads);
    c->other.machine = s->renderer.machine;
    c->open = true;
    c->failed = frame_renderer_open(&c->other, &c->scene, &s->assets.names) != 0;
    return !c->failed;
}

static void expand(const picture *p, uint32_t *to)
{
    for (uint32_t y = 0; y < p->height; y++)
        picture_expand_row(p, y, to + (size_t)y * p->width);
}

static bool draw_rung(comparison *c, const loaded_scene *s)
{
    if (!c->open && !open_other(c, s))
        return false;
    judge(c, s);
    frame_renderer_draw(&c->other, s->world);
    expand(&s->renderer.picture, c->ours);
    expand(&c->other.picture, c->theirs);
    return true;
}

/* Finishes a picture once begun, even if the world moves meanwhile.  While the world stands
 * still, further passes add samples.  After the world has moved, the reference starts
 * again. */
static bool draw_reference(comparison *c, const loaded_scene *s)
{
    if (c->reference && reference_thread_has_news(c->reference)) {
        c->pass = reference_thread_take(c->reference, c->ours, c->theirs);
        c->delivered = c->pass >= REFERENCE_1;
    }
    if (c->delivered && !reference_thread_has_same_world(c->reference, s->world)) {
        reference_thread_end(c->reference);
        c->reference = NULL;
    }
    if (!c->reference) {
        c->reference = reference_thread_begin(s, c->pass == REFERENCE_NONE);
        c->delivered = false;
    }
    c->failed = !c->reference;
    return c->pass != REFERENCE_NONE;
}

/* ------------------------------------------------------------------------------------ */

const picture *compare_draw(comparison *c, const loaded_scene *s)
{
    if (c->how == COMPARE_OFF || !follow(c, s))
        return NULL;
    if (!(c->against == AGAINST_REFERENCE ? draw_reference(c, s) : draw_rung(c, s)))
        return NULL;
    c->psnr = c->pass == REFERENCE_COARSE ? -1
            : image_diff_psnr(c->ours, c->theirs, (size_t)c->shown.width * c->shown.height);
    if (c->how == COMPARE_SPLIT)
        image_diff_split(&c->shown, c->ours, c->theirs);
    else
        image_diff_draw(&c->shown, c->ours, c->theirs);
    return &c->shown;
}

/* -- results ------------------------------------------------------------------------- */

compare_how compare_get_how(const comparison *c)
{
    return c->how;
}

compare_against compare_get_against(const comparison *c)
{
    return c->against;
}

double compare_psnr(const comparison *c)
{
    return c->psnr;
}

bool compare_moves(const comparison *c)
{
    return c->how != COMPARE_OFF && c->reference && reference_thread_has_news(c->reference);
}

static const char *const pass_text[] = {
    [REFERENCE_NONE] = "", [REFERENCE_COARSE] = "1 sample per 16 pixels",
    [REFERENCE_1] = "1 sample per pixel", [REFERENCE_4] = "4 samples per pixel",
    [REFERENCE_16] = "16 samples per pixel",
};

/* Writes "1 sample per pixel; 4 samples per pixel: 40%". */
static void note_reference(comparison *c)
{
    uint32_t percent = 0;
    const reference_pass pass_now =
        c->reference ? reference_thread_progress(c->reference, &percent) : REFERENCE_NONE;
    const bool over = pass_now == REFERENCE_NONE || pass_now == c->pass;

    if (c->pass == REFERENCE_NONE && c->reference && over
        && !reference_thread_has_news(c->reference))
        snprintf(c->note, sizeof c->note, "no memory for the reference");
    else if (c->pass == REFERENCE_NONE)
        snprintf(c->note, sizeof c->note, "drawing the reference: %u%%", (unsigned)percent);
    else if (over)
        snprintf(c->note, sizeof c->note, "%s", pass_text[c->pass]);
    else
        snprintf(c->note, sizeof c->note, "%s; %s: %u%%", pass_text[c->pass],
                 pass_text[pass_now], (unsigned)percent);
}

const char *compare_note(comparison *c)
{
    const bool water = c->against >= AGAINST_ROWS && c->against <= AGAINST_FLAT;

    if (c->how == COMPARE_OFF)
        return "";
    if (c->failed)
        return "no memory for the other picture";
    if (c->against == AGAINST_REFERENCE) {
        note_reference(c);
        return c->note;
    }
    if (c->same && c->psnr >= 100)
        return "the scene is drawn with this method: nothing to compare";
    if (!c->unfit)
        return "";
    return water ? "not for this scene: triangles are drawn"
         : "not for this scene: exact shading is drawn";
}
