/* SPDX-License-Identifier: MIT */
/* Foam of open water seen from above has no disc and no square at the window of its cells.
 *
 * Foam alone is the picture less the picture without foam. Rings of 10 m lie around the eye;
 * their means are taken at six ticks. The bound of the step from a ring to the next is the
 * largest step within the window and three standard errors of a step, by its values at the
 * ticks. Straight from above, where the whole window is in the picture, the mean beyond the
 * window is 0.7 to 1.4 of the mean within, and so is the foam beyond the window's corners
 * over that beyond its sides. Boats make no foam here, because their wakes are in the window
 * alone. There is no glitter, because foam hides it. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include "tests/lib/reference_difference.h"

enum { WIDTH = 320, HEIGHT = 240, TICKS = 6, RINGS = 11, SETTINGS = 6 };

#define RING  10.0              /* m: width of a ring */
#define LEAST 0.7               /* bounds of ratios of means */
#define MOST  1.4
#define UNSEEN 1.5              /* of 255: a difference over 10 m that nobody sees, of the size
                                 * of the rounding of pixels */

/* Foam alone at one tick, of 255: sums over pixels of each ring, and of the sides and the
 * corners just beyond the window. */
typedef struct {
    double sum[RINGS], pixels[RINGS];
    double side, sides, corner, corners;
} ring_sums;

typedef struct {
    const char *name;
    double      radius;         /* of the window, m */
    double      beach;          /* heading of the rise, radians; NAN: no beach */
    ring_sums   at[TICKS];
} foam_rings;

static const char *const names[] = {
    "deep-sea", "storm", "three-swells", "from-above",
};

enum { SCENES = sizeof names / sizeof *names };

static const char *const from_above[] = { "camera.y=200", "camera.pitch=-89" };
static const char *const over_beach[] = { "camera.y=90", "camera.pitch=-89" };
static const char *const oblique[] = { "camera.y=150", "camera.pitch=-60" };

static void open_scene(ref_stand *stand, const char *name, const char *const view[2],
                       bool foam)
{
    const char *const set[SETTINGS] = { view[0], view[1], "spray.count=0", "foam.hull=0",
                                        "water.specular=0", "foam.cells=0" };
    char path[64];

    snprintf(path, sizeof path, "assets/scenes/%s.ini", name);
    assert_int_equal(ref_stand_open(stand, path, set, SETTINGS - foam, 0), 0);
}

/* Adds a pixel's foam at an offset from the eye, m. On a beach that rises at a heading,
 * radians, the distance along the beach counts, over a strip as wide as the radius. */
static void add_pixel(ring_sums *s, double radius, double beach, double dx, double dz,
                      double foam)
{
    const double far = isnan(beach) ? hypot(dx, dz) : fabs(dx * cos(beach) + dz * sin(beach));
    const double most = fmax(fabs(dx), fabs(dz));
    const int ring = (int)(far / RING);

    if (fabs(dx * sin(beach) - dz * cos(beach)) > radius / 2)
        return;
    if (ring < RINGS) {
        s->sum[ring] += foam;
        s->pixels[ring]++;
    }
    if (far < radius || far > 1.5 * radius)
        return;
    if (fmin(fabs(dx), fabs(dz)) < most * tan(0.39269908)) {
        s->side += foam;
        s->sides++;
    } else {
        s->corner += foam;
        s->corners++;
    }
}

/* Adds the pixels that show water both with foam and without. */
static void add_picture(foam_rings *r, uint32_t t, const ref_stand *stand,
                        const drawn_image *with, const drawn_image *bare)
{
    const ref_camera c = ref_scene_camera(&stand->file.scene, stand->world, WIDTH, HEIGHT);

    for (uint32_t i = 0; i < WIDTH * HEIGHT; i++) {
        const double u = (i % WIDTH + 0.5 - c.u0) / c.focal;
        const double v = (c.v0 - i / WIDTH - 0.5) / c.focal;
        const double down = -(c.ahead.y + u * c.right.y + v * c.up.y);
        if (down <= 0.01 || with->kind[i] != REF_WATER || bare->kind[i] != REF_WATER)
            continue;
        const double far = c.eye.y / down;
        const ref_colour a = ref_colour_unpack(with->pixel[i]),
                         b = ref_colour_unpack(bare->pixel[i]);
        add_pixel(&r->at[t], r->radius, r->beach, far * (c.ahead.x + u * c.right.x + v * c.up.x),
                  far * (c.ahead.z + u * c.right.z + v * c.up.z), a.c[1] - b.c[1]);
    }
}

static void step_to(ref_stand *stand, uint32_t tick)
{
    while (stand->world->tick < tick)
        tp_world_step(&tp_program_all, stand->world, &stand->file.scene, NULL);
}

static void look(foam_rings *rings, const char *name, const char *const view[2])
{
    ref_stand stand, plain;

    *rings = (foam_rings){ .name = name };
    open_scene(&stand, name, view, true);
    open_scene(&plain, name, view, false);
    rings->radius = stand.file.scene.foam.cells * (stand.file.scene.foam.cell / 131072.0);
    rings->beach = tp_has_floor(&stand.file.scene)
                 ? stand.file.scene.floor.heading / 65536.0 * 0.0174532925 : (double)NAN;
    for (uint32_t t = 0; t < TICKS; t++) {
        step_to(&stand, 240 + 150 * t);
        step_to(&plain, 240 + 150 * t);
        drawn_image with = drawn_of(&stand, WIDTH, HEIGHT);
        drawn_image bare = drawn_of(&plain, WIDTH, HEIGHT);
        add_picture(rings, t, &stand, &with, &bare);
        drawn_free(&with);
        drawn_free(&bare);
    }
    ref_stand_close(&plain);
    ref_stand_close(&stand);
}

/* -- the bounds ---------------------------------------------------------------------- */

static double ring_mean(const ring_sums *s, int ring)
{
    return s->sum[ring] / fmax(s->pixels[ring], 1);
}

/* Mean step from a ring to the next over the ticks, and its standard error. */
static double ring_step(const foam_rings *r, int ring, double *error)
{
    double sum = 0, square = 0;

    for (int t = 0; t < TICKS; t++) {
        const double step = ring_mean(&r->at[t], ring + 1) - ring_mean(&r->at[t], ring);
        sum += step / TICKS;
        square += step * step / TICKS;
    }
    *error = sqrt(fmax(square - sum * sum, 0) / (TICKS - 1));
    return fabs(sum);
}

static bool has_pixels(const foam_rings *r, int ring)
{
    return r->at[0].pixels[ring] > 200;
}

/* The first ring that is not whole within the window's full weight, 3/4 of the radius. */
static int first_outer_ring(const foam_rings *r)
{
    return (int)(0.75 * r->radius / RING);
}

static bool has_even_steps(const foam_rings *r)
{
    const int outer = first_outer_ring(r);
    double within = 0, error, error_within = 0;
    bool even = true;

    for (int i = 0; i + 1 < outer; i++)
        if (has_pixels(r, i)) {
            within = fmax(within, ring_step(r, i, &error));
            error_within = fmax(error_within, error);
        }
    for (int i = outer > 0 ? outer - 1 : 0; i + 1 < RINGS; i++) {
        if (!has_pixels(r, i) || !has_pixels(r, i + 1))
            continue;
        const double step = ring_step(r, i, &error);
        const double bound = fmax(within + 3 * fmax(error, error_within), UNSEEN);
        if (step > bound) {
            print_error("%s: step %.2f from %g m on, bound %.2f\n", r->name, step, RING * i,
                        bound);
            even = false;
        }
    }
    return even;
}

/* Mean of the rings wholly within the window, or wholly beyond. */
static double mean_of(const foam_rings *r, bool beyond)
{
    double sum = 0, pixels = 1e-9;

    for (int t = 0; t < TICKS; t++)
        for (int i = 0; i < RINGS; i++)
            if (beyond ? i * RING >= r->radius : i < first_outer_ring(r)) {
                sum += r->at[t].sum[i];
                pixels += r->at[t].pixels[i];
            }
    return sum / pixels;
}

/* True if the ratio of two means is within its bounds, or the difference is unseen. */
static bool is_alike(const char *name, const char *of, double a, double b)
{
    if ((a >= LEAST * b && a <= MOST * b) || fabs(a - b) < UNSEEN)
        return true;
    print_error("%s: %s %.2f\n", name, of, a / b);
    return false;
}

static void print_rings(const foam_rings *r)
{
    printf("    %-13s", r->name);
    for (int i = 0; i < RINGS; i++) {
        double sum = 0;
        for (int t = 0; t < TICKS; t++)
            sum += ring_mean(&r->at[t], i) / TICKS;
        printf(" %5.1f%s", sum, i + 1 == (int)(r->radius / RING) ? " |" : "");
    }
    printf("  within %5.2f beyond %5.2f\n", mean_of(r, false), mean_of(r, true));
}

/* The ratios hold for whole windows only: a slanted view has a part of the window. */
static bool is_even(const foam_rings *r, bool whole)
{
    double side = 0, sides = 0, corner = 0, corners = 0;

    print_rings(r);
    for (int t = 0; t < TICKS; t++) {
        side += r->at[t].side;
        sides += r->at[t].sides;
        corner += r->at[t].corner;
        corners += r->at[t].corners;
    }
    return (!whole || (is_alike(r->name, "beyond the window over within", mean_of(r, true),
                                mean_of(r, false))
                       && is_alike(r->name, "corners over sides", corner / corners,
                                   side / sides)))
        && mean_of(r, false) > 0.5 && has_even_steps(r);
}

static void check_view(const char *const view[2])
{
    int uneven = 0;

    for (int i = 0; i < SCENES; i++) {
        static foam_rings rings;
        look(&rings, names[i], view);
        uneven += !is_even(&rings, view == from_above);
    }
    assert_int_equal(uneven, 0);
}

static void foam_has_no_disc_from_above(void **state)
{
    (void)state;
    check_view(from_above);
}

static void foam_goes_on_along_a_beach(void **state)
{
    static foam_rings rings;

    (void)state;
    look(&rings, "shore-break", over_beach);
    print_rings(&rings);
    assert_true(is_alike(rings.name, "beyond the window over within", mean_of(&rings, true),
                         mean_of(&rings, false)));
    assert_true(mean_of(&rings, false) > 5 && has_even_steps(&rings));
}

static void foam_has_no_disc_at_a_slant(void **state)
{
    (void)state;
    check_view(oblique);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(foam_has_no_disc_from_above),
        cmocka_unit_test(foam_has_no_disc_at_a_slant),
        cmocka_unit_test(foam_goes_on_along_a_beach),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
