/* SPDX-License-Identifier: MIT */
/* Checks the reference's foam against closed forms: place and drift of the cover,
 * bubbles by rank on two scales, light, glint, the window's edge, foam beyond the window,
 * and foam on a wave. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/foam/foam.h"
#include "tests/lib/reference_scenes.h"
#include "tools/reference/foam.h"

enum { CELLS = 32, TICKS = 90 };

#define SOLID (15 / 16.0)       /* largest opacity */
#define WHITE (236 / 256.0)     /* white share of full cover */
#define BAND  0.25              /* opacity of bubbles below full cover */
#define SOFT  (80 / 256.0)      /* width of the threshold, in ranks */

static uint64_t seed;

/* Level water without mirror, under a random field of foam. */
static tp_scene scene_foamy(void)
{
    tp_scene s = scene_level();

    s.camera.pitch = -50 * TP_FX_ONE;
    s.camera.heading = chance_fx(&seed, -180, 180);
    s.camera.x = chance_fx(&seed, -50, 50);
    s.camera.z = chance_fx(&seed, -50, 50);
    s.light.ambient = chance_fx(&seed, 0, 1);
    s.light.elevation = chance_fx(&seed, 5, 90);
    s.light.heading = chance_fx(&seed, -180, 180);
    s.water.reflection = 0;
    s.water.colour = chance_int(&seed, 0, 0xffffff);
    s.foam.cells = CELLS;
    s.foam.cell = chance_scale(&seed, 0.2, 3);
    s.foam.colour = chance_int(&seed, 0, 0xffffff);
    s.foam.map = (tp_scene_map){ .size = chance_scale(&seed, 0.5, 40),
                                 .drift_x = chance_fx(&seed, -2, 2),
                                 .drift_z = chance_fx(&seed, -2, 2) };
    return s;
}

/* Opens a view between two ticks; `cover`: 256 for random cells, or the cover of all
 * cells. */
static void open_foamy(view_of_ref *v, int cover)
{
    v->world = scene_world(&v->scene, &v->assets);
    while (v->world->tick < TICKS)
        tp_world_step(&tp_program_all, v->world, &v->scene, NULL);
    uint8_t *cell = tp_foam_cover(tp_foam_of_world(v->world));
    for (int i = 0; i < CELLS * CELLS; i++)
        cell[i] = (uint8_t)(cover < 256 ? cover : chance_int(&seed, 0, 255));
    v->world->lag = chance_fx(&seed, 0, 1);
    ref_scene_open(&v->ref, &v->scene, &v->assets, v->world, 64, 48, false);
}

static double seconds_of(const view_of_ref *v)
{
    return (TICKS - v->world->lag / 65536.0) / TP_TICKS_PER_SECOND;
}

/* Point where a look meets level water, m. */
static void meet(const view_of_ref *v, sight_angles to, double at[2])
{
    const double far = v->world->eye.y / 65536.0 / tan(-to.elevation);

    at[0] = v->world->eye.x / 65536.0 + far * sin(to.azimuth);
    at[1] = v->world->eye.z / 65536.0 - far * cos(to.azimuth);
}

/* -- cover --------------------------------------------------------------------------- */

/* Distance in cells from the low edge of the window, on one axis. The window begins half
 * its side before the cell of the eye at the last tick; the cells have drifted with the
 * foam's speed. */
static double from_edge(const view_of_ref *v, double at, tp_fx eye, tp_fx speed)
{
    const double cell = v->scene.foam.cell / 65536.0;
    const double drift = speed / 65536.0 * TICKS / TP_TICKS_PER_SECOND;
    const double first = floor((eye / 65536.0 - drift) / cell) - CELLS / 2;

    return (at - speed / 65536.0 * seconds_of(v)) / cell - first;
}

/* Weight of a column or row at a place of the torus. */
static double tent(const view_of_ref *v, double at, tp_fx speed, int i)
{
    const double cell = v->scene.foam.cell / 65536.0;
    const double off = ((at - speed / 65536.0 * seconds_of(v)) / cell - i - 0.5) / CELLS;

    return fmax(0, 1 - fabs(off - round(off)) * CELLS);
}

/* Cover 0..1: the bilinear cover within 3/4 of the window's circle, less to its rim. Still
 * water has no foam beyond. NAN half a cell from the window's edge, where a torus has no
 * neighbours. */
static double cover_at(const view_of_ref *v, const double at[2])
{
    const tp_scene_map *map = &v->scene.foam.map;
    const uint8_t *cell = tp_foam_cover(tp_foam_of_world(v->world));
    const double u = from_edge(v, at[0], v->world->eye.x, map->drift_x);
    const double w = from_edge(v, at[1], v->world->eye.z, map->drift_z);
    const double off = hypot(u - CELLS / 2, w - CELLS / 2) / (CELLS / 2);
    const double edge = fmin(fmin(u, CELLS - u), fmin(w, CELLS - w));
    double sum = 0;

    if (fabs(edge) < 0.501)
        return (double)NAN;
    for (int row = 0; row < CELLS && off < 1; row++)
        for (int col = 0; col < CELLS; col++)
            sum += tent(v, at[0], map->drift_x, col) * tent(v, at[1], map->drift_z, row)
                 * cell[row * CELLS + col] / 255.0;
    return sum * fmin(1, fmax(0, 1 - off * off) / (1 - 0.75 * 0.75));
}

/* Opacity of lace over bubbles. */
static double opacity_of(double cover, double white)
{
    return 1 - (1 - SOLID * white) * (1 - BAND * cover);
}

/* Adds the difference between a colour and foam of an opacity over the lit water. */
static void add(measure *off, const view_of_ref *v, const ref_seen *seen, double cosine,
                double opacity, double glint, int n)
{
    const double lit = lit_of(&v->scene, cosine);

    for (int k = 0; k < 3 && !isnan(opacity); k++)
        measure_add(off, seen->colour.c[k]
                    - fmin(255, between(lit * channel(v->scene.water.colour, k),
                                        (1 + lit) / 2 * channel(v->scene.foam.colour, k),
                                        opacity)
                           + (1 - opacity) * glint * channel(v->scene.light.colour, k)),
                    n, k, 0);
}

/* Foam without a texture is as white as its cover. Drift per tick is rounded to 2^-32 m, so
 * cells of 0.2 m are within 1e-7 of their place. */
static void plain_foam_lies_and_drifts_as_its_cells(void **state)
{
    measure off = { .what = "plain foam", .unit = "of 255" };
    int outside = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        view_of_ref v = { .scene = scene_foamy() };
        double at[2];
        open_foamy(&v, 256);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.1);
        const ref_seen seen = sight_look(&v, to);
        meet(&v, to, at);
        const double cover = cover_at(&v, at);
        outside += cover == 0;
        add(&off, &v, &seen, sin(sight_light(&v).elevation),
            opacity_of(cover, WHITE * cover), 0, n);
        view_close(&v);
    }
    measure_print(&off);
    printf("    %d outside of the window\n", outside);
    assert_true(outside > 20 && outside < 1000 && off.inputs > 3000);
    assert_true(off.worst < 1e-4);
}

/* The window of a pool reaches to the walls: the cover does not fade. */
static void foam_of_a_pool_ends_at_its_walls(void **state)
{
    measure off = { .what = "foam of a pool", .unit = "of 255" };
    int inside = 0;

    (void)state;
    for (int n = 0; n < 600; n++) {
        view_of_ref v = { .scene = scene_foamy() };
        double at[2];
        v.scene.foam.cell = TP_FX(0.25);
        v.scene.foam.map.drift_x = v.scene.foam.map.drift_z = 0;
        v.scene.pool.cols = v.scene.pool.rows = CELLS;
        v.scene.pool.cell = TP_FX(0.25);
        v.scene.camera.x = chance_fx(&seed, -4, 4);
        v.scene.camera.z = chance_fx(&seed, -4, 4);
        open_foamy(&v, 255);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.1);
        const ref_seen seen = sight_look(&v, to);
        meet(&v, to, at);
        const bool wet = fmax(fabs(at[0]), fabs(at[1])) < CELLS / 2 * 0.25;
        inside += wet;
        add(&off, &v, &seen, sin(sight_light(&v).elevation),
            wet ? opacity_of(1, WHITE) : 0, 0, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(inside > 60 && inside < 540);
    assert_true(off.worst < 1e-8);
}

/* -- bubbles ------------------------------------------------------------------------- */

/* Share of texels darker than a green, with half of the equal texels. */
static double rank_of(const noise_picture *p, int green)
{
    double darker = 0;

    for (int i = 0; i < NOISE * NOISE; i++) {
        const double own = channel((int32_t)p->pixel[i], 1);
        darker += own < green ? 1 : own <= green ? 0.5 : 0;
    }
    return darker / (NOISE * NOISE);
}

/* White share of a rank: a ramp over SOFT ranks. The ramp begins at rank 1 for no cover and
 * ends below rank 1 / 8 for full cover. */
static double white_of(double cover, double rank)
{
    const double foot = 1 - WHITE * cover * (1 + SOFT);
    return isnan(cover) ? cover
                        : fmax(0, fmin(fmin(1, 4 * cover), (rank - foot) / SOFT));
}

/* Rank of the texture at a place, with repeats of `size` map sizes. */
static double rank_seen(const view_of_ref *v, const noise_picture *p, const double at[2],
                        double size)
{
    const tp_scene_map *map = &v->scene.foam.map;
    const double green =
        tents_of(p, (at[0] * 65536 - map->drift_x * seconds_of(v)) / map->size / size,
                 (at[1] * 65536 - map->drift_z * seconds_of(v)) / map->size / size, 1);

    return between(rank_of(p, (int)green), rank_of(p, (int)green + 1), green - (int)green);
}

static void bubbles_turn_white_by_rank(void **state)
{
    measure off = { .what = "bubbles", .unit = "of 255" };
    int lace = 0;

    (void)state;
    for (int n = 0; n < 2000; n++) {
        static noise_picture p;
        view_of_ref v = { .scene = scene_foamy() };
        double at[2];
        v.assets.foam = noise_of(&p, &seed);
        open_foamy(&v, 256);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.2);
        const ref_seen seen = sight_look(&v, to);
        meet(&v, to, at);
        const double flat = cover_at(&v, at);
        const double patch = rank_seen(&v, &p, at, 4) - 0.5;
        const double cover = flat + 1.6 * patch * flat * (1 - flat);
        const double white = white_of(cover, rank_seen(&v, &p, at, 1));
        lace += white > 0.01 && white < 0.99;
        add(&off, &v, &seen, sin(sight_light(&v).elevation), opacity_of(cover, white), 0,
            n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(lace > 200);
    assert_true(off.worst < 1e-3);      /* a cell's place within 1e-7, over SOFT */
}

/* Small levels of the texture show the cover itself: white is the cover plus the rank above
 * the mean's rank. */
static void far_foam_is_its_cover(void **state)
{
    measure off = { .what = "far foam", .unit = "of 1" };

    (void)state;
    for (int n = 0; n < 10000; n++) {
        const double cover = chance_double(&seed, 0, 1), rank = chance_double(&seed, -1, 1);
        const double want = fmin(fmin(1, 4 * cover), WHITE * cover + rank);
        measure_add(&off, ref_foam_white(cover, rank, chance_int(&seed, 5, 9))
                          - fmax(0, want), n, 0, 0);
        measure_add(&off, ref_foam_white(cover, rank, 0) - white_of(cover, rank + 0.5), n,
                    1, 0);
    }
    measure_print(&off);
    assert_true(off.worst < 1e-12);
}

/* -- light and waves ----------------------------------------------------------------- */

/* Foam has no glint, and hides the glint under it by its opacity. */
static void foam_hides_the_glint(void **state)
{
    measure off = { .what = "glint under foam", .unit = "of 255" };
    double most = 0;

    (void)state;
    for (int n = 0; n < 1000; n++) {
        view_of_ref v = { .scene = scene_foamy() };
        v.scene.foam.cell = 40 * TP_FX_ONE;     /* the edge is out of the picture */
        v.scene.light.elevation = chance_fx(&seed, 30, 70);
        v.scene.light.heading = v.scene.camera.heading;
        v.scene.light.colour = chance_int(&seed, 0, 0xffffff);
        v.scene.water.specular = chance_fx(&seed, 0.1, 1);
        v.scene.water.shininess = chance_int(&seed, 1, 60) * TP_FX_ONE;
        const int cover = chance_int(&seed, 0, 255);
        open_foamy(&v, cover);
        const sight_angles to = sight_any(&v, &seed, -PI / 2, -0.4);
        const ref_seen seen = sight_look(&v, to);
        const sight_angles mirrored = { to.azimuth, -to.elevation };
        const double glint = v.scene.water.specular / 65536.0
                           * pow(fmax(0, sight_cos(mirrored, sight_light(&v))),
                                 v.scene.water.shininess / 65536);
        most = fmax(most, glint);
        add(&off, &v, &seen, sin(sight_light(&v).elevation),
            opacity_of(cover / 255.0, WHITE * cover / 255),
            glint, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(most > 0.5);
    assert_true(off.worst < 1e-8);
}

/* A trochoid along x, by [A7]: foam lies at the rest position of the point that a look
 * meets, and has the light of the slope there. */
static void foam_moves_with_the_waves(void **state)
{
    measure off = { .what = "foam on a wave", .unit = "of 255" };
    double most = 0;

    (void)state;
    for (int n = 0; n < 1000; n++) {
        view_of_ref v = { .scene = scene_foamy() };
        v.scene.wave[0].amplitude = TP_FX(0.6);
        v.scene.wave[0].length = 12 * TP_FX_ONE;
        v.scene.wave[0].steepness = TP_FX(0.25);
        v.scene.wave[0].heading = 90 * TP_FX_ONE;
        v.scene.wave[0].phase = chance_fx(&seed, 0, 360);
        v.scene.wave[0].speed = 0;
        v.scene.camera.pitch = -80 * TP_FX_ONE;
        v.scene.camera.fov = 100 * TP_FX_ONE;
        v.scene.foam.crest = 0;
        v.scene.foam.cell = chance_scale(&seed, 0.4, 3);
        open_foamy(&v, 256);
        const double eye[3] = { v.world->eye.x / 65536.0, v.world->eye.y / 65536.0,
                                v.world->eye.z / 65536.0 };
        const double k = 2 * PI / 12, rest[2] = { eye[0] + chance_double(&seed, -1, 1),
                                                  eye[2] + chance_double(&seed, -1, 1) };
        const double th = k * rest[0] + v.scene.wave[0].phase / 65536.0 * PI / 180;
        const double a = v.scene.wave[0].amplitude / 65536.0, shift = 0.25 / k * cos(th);
        const double slope = k * a * cos(th) / (1 - 0.25 * sin(th));
        const double dx = rest[0] + shift - eye[0], dz = rest[1] - eye[2];
        const sight_angles to = { atan2(dx, -dz),
                                  -atan2(eye[1] - a * sin(th), hypot(dx, dz)) };
        const sight_angles normal = { slope > 0 ? -PI / 2 : PI / 2,
                                      atan2(1, fabs(slope)) };
        const ref_seen seen = sight_look(&v, to);
        most = fmax(most, fabs(shift));
        add(&off, &v, &seen, sight_cos(normal, sight_light(&v)),
            opacity_of(cover_at(&v, rest), WHITE * cover_at(&v, rest)), 0, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(most > 0.4);
    assert_true(off.worst < 1e-4);      /* as plain foam */
}

/* Foam beyond the window of cells on a trochoid: old foam on the wave's back, the rest of the
 * field's mean by the fourth power of the slope, and 216 of 255 at most. */
static void foam_beyond_the_window_lies_on_slopes(void **state)
{
    measure off = { .what = "far foam on a wave", .unit = "of 255" };
    int none = 0, most = 0;

    (void)state;
    for (int n = 0; n < 1000; n++) {
        view_of_ref v = { .scene = scene_foamy() };
        v.scene.wave[0].amplitude = TP_FX(0.6);
        v.scene.wave[0].length = 12 * TP_FX_ONE;
        v.scene.wave[0].steepness = 0;
        v.scene.wave[0].heading = 90 * TP_FX_ONE;
        v.scene.wave[0].phase = chance_fx(&seed, 0, 360);
        v.scene.wave[0].speed = 0;
        v.scene.camera.pitch = -80 * TP_FX_ONE;
        v.scene.camera.fov = 100 * TP_FX_ONE;
        v.scene.foam.crest = 0;
        v.scene.foam.cell = TP_FX(0.01);        /* the window is a third of a metre wide */
        open_foamy(&v, 0);
        const int cover = chance_int(&seed, 0, 120);
        for (int q = 0; q < TP_FOAM_TICKS; q++)
            tp_foam_of_world(v.world)->sum[q] =
                (uint32_t)cover * CELLS * CELLS / TP_FOAM_TICKS;
        ref_scene_close(&v.ref);
        ref_scene_open(&v.ref, &v.scene, &v.assets, v.world, 64, 48, false);
        const double eye[3] = { v.world->eye.x / 65536.0, v.world->eye.y / 65536.0,
                                v.world->eye.z / 65536.0 };
        const double k = 2 * PI / 12, rest[2] = { eye[0] + chance_double(&seed, 0.3, 1),
                                                  eye[2] + chance_double(&seed, 0.3, 1) };
        const double th = k * rest[0] + v.scene.wave[0].phase / 65536.0 * PI / 180;
        const double a = v.scene.wave[0].amplitude / 65536.0, slope = k * a * cos(th);
        const double dx = rest[0] - eye[0], dz = rest[1] - eye[2];
        const sight_angles to = { atan2(dx, -dz),
                                  -atan2(eye[1] - a * sin(th), hypot(dx, dz)) };
        const sight_angles normal = { slope > 0 ? -PI / 2 : PI / 2,
                                      atan2(1, fabs(slope)) };
        const double old = cover * fmin(0.5, cover / 32.0), fresh = 1.375 * cover - old / 2;
        const double share = slope > 0 ? old + fresh * 4 * pow(slope / (k * a), 4) : 0;
        const double far = fmin(216, share) / 255;
        none += slope < 0;
        most += share > 216;
        const ref_seen seen = sight_look(&v, to);
        add(&off, &v, &seen, sight_cos(normal, sight_light(&v)),
            opacity_of(far, WHITE * far), 0, n);
        view_close(&v);
    }
    measure_print(&off);
    assert_true(none > 50 && most > 20);
    assert_true(off.worst < 0.02);      /* amplitude and mean are rounded to 2^-16 */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(plain_foam_lies_and_drifts_as_its_cells),
        cmocka_unit_test(foam_of_a_pool_ends_at_its_walls),
        cmocka_unit_test(bubbles_turn_white_by_rank),
        cmocka_unit_test(far_foam_is_its_cover),
        cmocka_unit_test(foam_hides_the_glint),
        cmocka_unit_test(foam_moves_with_the_waves),
        cmocka_unit_test(foam_beyond_the_window_lies_on_slopes),
    };
    seed = random_seed();
    return cmocka_run_group_tests(tests, NULL, NULL);
}
