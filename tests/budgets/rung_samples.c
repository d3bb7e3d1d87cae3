/* SPDX-License-Identifier: MIT */
/* Samples of the rungs that the plan prices, from views of a shipped scene at random:
 * cameras, sizes of the picture, heights of the sea, directions of the light.
 *
 *     rung_samples SCENE SEED VIEWS errors
 *         draws each rung of each kind, at ticks 60, 180 and 300, and prints the mean
 *         square of its difference from the exact picture, or from the rung that it needs:
 *             error KIND RUNG SEA SHARE SQUARE
 *         SQUARE is 0 only if both pictures are alike
 *     rung_samples SCENE SEED VIEWS bases|rungs|mixed|sets
 *         prints pictures to count on the board, and what the plan says of them:
 *             picture KIND RUNG WIDTHxHEIGHT TICK NAME=VALUE...
 *             parts SHADED RENDERER WATER -[,KIND;RUNG;MASK]... COST... ; PREDICTED
 *             costs SHADED COST... ; PREDICTED
 *         parts: the exact rungs' costs; WATER: pixels; MASK: bits of the parts that the
 *         rung changes; costs: those of the set, predicted
 *         bases: the exact picture, and that of fast shading; rungs: these, and each rung
 *         alone; mixed: sets at random; sets: some steps of the walk
 *     rung_samples SCENE 0 0 again <PICTURES
 *         reads lines "picture" as printed above, and prints them with the parts and the
 *         prediction that the plan has now: pictures counted before need no new count
 *     rung_samples SCENE SEED 0 faces
 *         prints the plan's cost of the boat in the scene's own view
 *     rung_samples SCENE SEED VIEWS walk
 *         draws the steps of the walk, and prints the errors
 *             walk STEP SEA COST PREDICTED MEASURED
 *         predicted and measured in levels, rms */
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/scene/loaded_scene.h"
#include "tests/lib/frames.h"
#include "tests/lib/picture_difference.h"
#include "tests/lib/random.h"
#include "quality/processor_prices.h"
#include "quality/rung_prices.h"
#include "world/text.h"

enum { MOST = 480 * 320, TICK = 60, WORDS = 24, BYTES = 64, LINE = 4096 };

static uint64_t chance;

/* A view of the scene: settings besides the scene's own, and the size of the picture. */
typedef struct {
    char     word[WORDS][BYTES];
    int      words;
    uint32_t width, height, tick;
} sample_view;

/* -- views --------------------------------------------------------------------------- */

static void add(sample_view *v, const char *name, double value)
{
    snprintf(v->word[v->words++], BYTES, "%s=%.4f", name, value);
}

static double of(tp_fx x)
{
    return x / 65536.0;
}

static sample_view view_any(const tp_scene *s)
{
    static const uint16_t sizes[][2] = { { 320, 240 }, { 160, 120 }, { 480, 320 } };
    const uint16_t *size = sizes[chance_int(&chance, 0, 2)];
    sample_view v = { .words = 0, .width = size[0], .height = size[1], .tick = TICK };
    const double sea = chance_double(&chance, 0.6, 1.3);

    add(&v, "camera.heading", of(s->camera.heading) + chance_double(&chance, -40, 40));
    add(&v, "camera.pitch",
        fmax(-80, fmin(20, of(s->camera.pitch) + chance_double(&chance, -10, 8))));
    add(&v, "camera.x", of(s->camera.x) + chance_double(&chance, -3, 3));
    add(&v, "camera.z", of(s->camera.z) + chance_double(&chance, -3, 3));
    add(&v, "camera.y", of(s->camera.y) * chance_double(&chance, 0.7, 1.6));
    add(&v, "light.heading", of(s->light.heading) + chance_double(&chance, -60, 60));
    add(&v, "light.elevation", chance_double(&chance, 8, 75));
    for (int i = 0; i < TP_WAVES; i++) {
        char name[32];
        snprintf(name, sizeof name, "wave%d.amplitude", i);
        if (s->wave[i].amplitude > 0)
            add(&v, name, of(s->wave[i].amplitude) * sea);
    }
    return v;
}

/* Opens a scene with a view's settings and those of a set, and steps it. */
static bool open_view(loaded_scene *s, const char *path, const sample_view *v,
                      const tp_rung_set *set)
{
    const char *settings[WORDS + TP_RUNG_KINDS];
    options o = { .command = "rung_samples", .scene = path, .rung = "exact", .quiet = true,
                  .settings = settings, .width = v->width, .height = v->height };

    for (int i = 0; i < v->words; i++)
        settings[o.n_settings++] = v->word[i];
    char mesh[32];
    if (set && set->of[TP_KIND_mesh]) {         /* the mesh takes effect at loading */
        snprintf(mesh, sizeof mesh, "quality.mesh=%s",
                 set->of[TP_KIND_mesh] == 1 ? "middle" : "low");
        settings[o.n_settings++] = mesh;
    }
    if (loaded_scene_load(s, &o) != EXIT_DONE)
        return false;
    if (loaded_scene_make_world(s) != EXIT_DONE)
        exit(EXIT_INPUT);
    while (s->world->tick < v->tick)
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
    return true;
}

static void draw(const loaded_scene *s, const sample_view *v, const tp_rung_set *set,
                 uint32_t *pixels)
{
    const tp_config config = { .width = v->width, .height = v->height, .tile_height = 16 };
    tp_scene scene = s->file.scene;

    tp_rung_set_apply(&scene, set);
    test_frame f = frame_of(&scene, &s->assets.names, &config);
    frame_draw_picture(&f, s->world, pixels);
    frame_free(&f);
}

/* -- errors of rungs ----------------------------------------------------------------- */

static double square_of(const uint32_t *a, const uint32_t *b, size_t pixels)
{
    return (double)picture_square_sum(a, b, pixels) / 3 / (double)pixels;
}

/* Returns the set with the rungs that a kind needs, the base of the kind's error. */
static tp_rung_set base_of(const tp_view_costs *c, int kind)
{
    const tp_rung_effect *e = &tp_rung_effects[kind];
    tp_rung_set base = { .of = { 0 } };

    if (e->needs_rung)
        base.of[e->needs_kind] = e->needs_rung;
    if (e->needs_rung && e->needs_kind == TP_KIND_SHADING && c->clear)
        base.of[TP_KIND_refraction] = 1;
    return base;
}

static tp_view_costs costs_of(const loaded_scene *s, const sample_view *v)
{
    tp_scene scene = s->file.scene;
    const tp_plan_input in = { tp_program_all.modules, &scene, &s->assets.names, v->width,
                               v->height };

    tp_view_costs view;

    tp_view_costs_make(&view, &tp_prices_measured, &in);
    return view;
}

static bool concerns(const tp_view_costs *c, int kind, int rung)
{
    const tp_rung_effect *e = &tp_rung_effects[kind];
    const bool fast = kind == TP_KIND_SHADING
                   || (e->needs_rung && e->needs_kind == TP_KIND_SHADING);

    if (kind == TP_KIND_VISIBILITY)
        return c->estimate.fits[rung];
    if (kind == TP_KIND_rows && !c->estimate.fits[1])
        return false;
    return c->share[e->share] > 0 && (!fast || c->fast);
}

static void print_errors(const loaded_scene *s, const char *path, const sample_view *v)
{
    static uint32_t exact[MOST], before[MOST], after[MOST];
    const size_t pixels = (size_t)v->width * v->height;
    const tp_view_costs c = costs_of(s, v);
    const tp_rung_set none = { .of = { 0 } };

    draw(s, v, &none, exact);
    for (int k = 0; k < TP_RUNG_KINDS; k++)
        for (uint8_t r = 1; r < tp_rung_kind_count(k); r++) {
            tp_rung_set set = base_of(&c, k);
            loaded_scene other;
            if (!concerns(&c, k, r))
                continue;
            draw(s, v, &set, before);
            set.of[k] = r;
            if (k == TP_KIND_SHADING)
                set.of[TP_KIND_refraction] = c.clear;
            if (k == TP_KIND_mesh && open_view(&other, path, v, &set)) {
                draw(&other, v, &set, after);
                loaded_scene_close(&other);
            } else {
                draw(s, v, &set, after);
            }
            const double more = square_of(exact, after, pixels)
                              - square_of(exact, before, pixels);
            const bool alike = memcmp(before, after, pixels * sizeof *after) == 0;
            printf("error %s %d %d %.6f %.8f\n", tp_rung_kind_row(k), r, c.estimate.sea,
                   of(c.share[tp_rung_effects[k].share]), alike ? 0 : fmax(more, 1e-6));
        }
}

/* -- pictures to count --------------------------------------------------------------- */

/* Prints the rungs that take effect, "KIND;RUNG,", or "-". */
static void print_names(const tp_view_costs *c, const tp_rung_set *set)
{
    printf("-");
    for (int k = 0; k < TP_RUNG_KINDS; k++)
        if (set->of[k] && tp_rung_effects[k].parts && tp_rung_takes_effect(c, set, k))
            printf(",%s;%d;%" PRIu64, tp_rung_kind_row(k), set->of[k],
                   tp_rung_effects[k].parts);
}

/* Prints the predicted costs of the set's parts. */
static void print_costs(const tp_view_costs *c, const tp_rung_set *set)
{
    uint64_t cost[TP_PART_COUNT], sum = 0;

    tp_set_part_costs(c, set, cost);
    printf("costs %d", tp_set_shaded(c, set));
    for (int p = 0; p < TP_PART_COUNT; p++) {
        printf(" %" PRIu64, cost[p]);
        sum += cost[p];
    }
    printf(" ; %" PRIu64 "\n", sum);
}

static void print_picture(const loaded_scene *s, const sample_view *v, int kind, int rung,
                          const tp_rung_set *set)
{
    const tp_view_costs c = costs_of(s, v);
    tp_scene scene = s->file.scene;
    char text[TP_NAME_BYTES + 1];

    tp_rung_set_apply(&scene, set);
    printf("picture %s %d %ux%u %d", kind < 0 ? "-" : tp_rung_kind_row(kind), rung,
           (unsigned)v->width, (unsigned)v->height, TICK);
    for (int i = 0; i < v->words; i++)
        printf(" %s", v->word[i]);
    for (int k = 0; k < TP_RUNG_KINDS; k++) {
        const char *name = tp_rung_kind_row(k);
        const tp_param *row = tp_param_find(name, strlen(name));
        tp_param_text(&scene, row, text, sizeof text);
        if (k != TP_KIND_mesh)
            printf(" %s=%s", name, text);
    }
    const int drawn = tp_set_renderer(&c, set);
    printf("\nparts %d %d %u ", tp_set_shaded(&c, set), drawn, (unsigned)c.water);
    print_names(&c, set);
    for (int p = 0; p < TP_PART_COUNT; p++)
        printf(" %" PRIu64, p < TP_PARTS_SEEN ? c.seen[drawn][p] : c.part[p]);
    const tp_set_price price = tp_set_price_estimate(&c, set);
    printf(" ; %" PRIu64 "\n", price.cost);
    print_costs(&c, set);
}

/* The exact picture, and that of fast shading alone. */
static void print_bases(const loaded_scene *s, const sample_view *v)
{
    const tp_view_costs c = costs_of(s, v);
    tp_rung_set set = { .of = { 0 } };

    print_picture(s, v, -1, 0, &set);
    set.of[TP_KIND_SHADING] = 1;
    set.of[TP_KIND_refraction] = c.clear;
    if (c.fast)
        print_picture(s, v, -1, 1, &set);
}

static void print_rungs(const loaded_scene *s, const sample_view *v)
{
    const tp_view_costs c = costs_of(s, v);
    tp_rung_set set = { .of = { 0 } };

    print_bases(s, v);
    for (int k = 0; k < TP_RUNG_KINDS; k++)
        for (uint8_t r = 1; r < tp_rung_kind_count(k); r++) {
            set = base_of(&c, k);
            set.of[k] = r;
            if (k == TP_KIND_SHADING)
                set.of[TP_KIND_refraction] = c.clear;
            if (concerns(&c, k, r) && k != TP_KIND_mesh && k != TP_KIND_SHADING)
                print_picture(s, v, k, r, &set);
        }
}

/* Sets at random, half of all kinds exact. */
static void print_mixed(const loaded_scene *s, const sample_view *v)
{
    const tp_view_costs c = costs_of(s, v);

    for (int n = 0; n < 6; n++) {
        tp_rung_set set = { .of = { 0 } };
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            if (k != TP_KIND_mesh && chance_int(&chance, 0, 1))
                set.of[k] =
                    (uint8_t)chance_int(&chance, 0, (int)tp_rung_kind_count(k) - 1);
        if (!c.estimate.fits[set.of[TP_KIND_VISIBILITY]])
            set.of[TP_KIND_VISIBILITY] = 0;
        if (c.clear && set.of[TP_KIND_SHADING])
            set.of[TP_KIND_refraction] = 1;     /* fast shading needs it */
        print_picture(s, v, -3, n, &set);
    }
}

/* -- walks --------------------------------------------------------------------------- */

static tp_set_walk walk_of(const tp_view_costs *c, const tp_scene *scene)
{
    tp_set_walk walk;
    uint32_t open;
    tp_scene plain = *scene;

    memset(&plain.quality.visibility, 0,
           sizeof plain.quality - offsetof(tp_scene_quality, visibility));
    const tp_rung_set from = tp_rung_set_named(&plain, true, &open);
    tp_set_walk_make(&walk, c, from, open & ~(1u << TP_KIND_mesh));
    return walk;
}

static void print_sets(const loaded_scene *s, const sample_view *v)
{
    const tp_view_costs c = costs_of(s, v);
    const tp_set_walk walk = walk_of(&c, &s->file.scene);

    for (uint32_t i = 0; i < 4; i++) {
        const uint32_t at = i * (walk.count - 1) / 3;
        print_picture(s, v, -2, (int)at, &walk.set[at]);
    }
}

static void print_walk(const loaded_scene *s, const sample_view *v)
{
    static uint32_t exact[MOST], drawn[MOST];
    const size_t pixels = (size_t)v->width * v->height;
    const tp_view_costs c = costs_of(s, v);
    const tp_set_walk walk = walk_of(&c, &s->file.scene);

    for (uint32_t i = 0; i < walk.count; i++) {
        draw(s, v, &walk.set[i], i ? drawn : exact);
        printf("walk %u %d %" PRIu64 " %.3f %.3f\n", (unsigned)i, c.estimate.sea,
               walk.price[i].cost, sqrt((double)walk.price[i].square / 65536),
               i ? sqrt(square_of(exact, drawn, pixels)) : 0);
    }
}

/* -- pictures counted before --------------------------------------------------------- */

/* Returns the kind that a setting "NAME=VALUE" names, or -1. */
static int kind_of(const char *setting)
{
    const size_t bytes = strcspn(setting, "=");

    for (int k = 0; k < TP_RUNG_KINDS; k++)
        if (strlen(tp_rung_kind_row(k)) == bytes
            && strncmp(tp_rung_kind_row(k), setting, bytes) == 0)
            return k;
    return -1;
}

/* Sets the rung that a setting names; `scene` is the scene without the set. */
static void read_rung(const tp_scene *scene, int kind, const char *value, tp_rung_set *set)
{
    const char *name = tp_rung_kind_row(kind);
    char text[TP_NAME_BYTES + 1];

    for (uint8_t r = 0; r < tp_rung_kind_count(kind); r++) {
        tp_rung_set one = { .of = { 0 } };
        tp_scene named = *scene;
        one.of[kind] = r;
        tp_rung_set_apply(&named, &one);
        tp_param_text(&named, tp_param_find(name, strlen(name)), text, sizeof text);
        if (strcmp(text, value) == 0) {
            set->of[kind] = r;
            return;
        }
    }
    fprintf(stderr, "rung_samples: %s has no rung %s\n", name, value);
    exit(EXIT_INPUT);
}

/* Reads a line of print_picture(): the view, and the settings of the set in `rungs`. */
static int read_picture(char *line, sample_view *v, char **rungs)
{
    int count = 0, word = 0;
    unsigned width, height;

    *v = (sample_view){ .words = 0 };
    for (char *w = strtok(line, " \n"); w; w = strtok(NULL, " \n"), word++) {
        if (word == 3 && sscanf(w, "%ux%u", &width, &height) == 2) {
            v->width = width;
            v->height = height;
        }
        if (word < 5)
            continue;
        if (kind_of(w) >= 0 && count < TP_RUNG_KINDS)
            rungs[count++] = w;
        else if (v->words < WORDS)
            snprintf(v->word[v->words++], BYTES, "%s", w);
    }
    return count;
}

static void print_again(const char *path)
{
    static char line[LINE], copy[LINE];

    while (fgets(line, sizeof line, stdin)) {
        char *rungs[TP_RUNG_KINDS], kind[BYTES];
        int rung;
        sample_view v;
        loaded_scene s;
        tp_rung_set set = { .of = { 0 } };
        strcpy(copy, line);
        const int count = read_picture(copy, &v, rungs);
        v.tick = TICK;
        if (sscanf(line, "picture %63s %d", kind, &rung) != 2
            || !open_view(&s, path, &v, NULL))
            exit(EXIT_INPUT);
        for (int i = 0; i < count; i++) {
            char *value = strchr(rungs[i], '=') + 1;
            read_rung(&s.file.scene, kind_of(rungs[i]), value, &set);
        }
        print_picture(&s, &v, strcmp(kind, "-") == 0 ? -1 : kind_of(kind), rung, &set);
        loaded_scene_close(&s);
    }
}

int main(int count, char **words)
{
    loaded_scene s;

    if (count != 5) {
        fprintf(stderr, "usage: rung_samples SCENE.ini SEED VIEWS "
                        "errors|bases|rungs|mixed|sets|walk|again|faces\n");
        return EXIT_USAGE;
    }
    static const uint32_t ticks[] = { TICK, 180, 300 };
    const bool drawn = words[4][0] == 'e' || words[4][0] == 'w';
    const sample_view own = { .words = 0, .width = 320, .height = 240, .tick = TICK };
    chance = strtoull(words[2], NULL, 10) * 2654435761u + 88172645463325252u;
    if (!open_view(&s, words[1], &own, NULL))
        return EXIT_INPUT;
    const tp_scene scene = s.file.scene;
    if (words[4][0] == 'a')
        print_again(words[1]);
    if (words[4][0] == 'f') {
        const tp_view_costs c = costs_of(&s, &own);
        const uint64_t *part = c.part;
        printf("%" PRIu64 "\n", part[TP_PART_faces] + part[TP_PART_solids]
                                     + part[TP_PART_mirror]);
    }
    loaded_scene_close(&s);
    for (int n = atoi(words[3]); n > 0; n--) {
        sample_view v = view_any(&scene);
        v.tick = drawn ? ticks[n % 3] : TICK;
        if (!open_view(&s, words[1], &v, NULL)) {
            n++;
            continue;
        }
        switch (words[4][0]) {
        case 'e': print_errors(&s, words[1], &v); break;
        case 'b': print_bases(&s, &v); break;
        case 'r': print_rungs(&s, &v); break;
        case 'm': print_mixed(&s, &v); break;
        case 's': print_sets(&s, &v); break;
        default:  print_walk(&s, &v); break;
        }
        loaded_scene_close(&s);
        fflush(stdout);
    }
    return EXIT_DONE;
}
