/* SPDX-License-Identifier: MIT */
/* Random deep water in the core's formats and in double precision, side by side, and bounds
 * for the difference that the formats allow.  Bounds are computed for each point, see
 * phase_error(). */
#ifndef TP_TESTS_LIB_DEEP_WATER_H
#define TP_TESTS_LIB_DEEP_WATER_H
#include "tests/lib/measure.h"
#include "tests/lib/random.h"
#include "tools/reference/deep_water.h"
#include "waves/deep_water.h"

#define TEN_YEARS (3652ull * 24 * 3600 * TP_TICKS_PER_SECOND)
#define LSB       (1 / 65536.0)
#define SINE      4.8e-6        /* error of tp_sin, and of its rounding to Q24 */

typedef struct {
    tp_wave wave[TP_WAVES];
    int     count;
    tp_fx   gravity;
    tp_deep_water  deep;
    ref_deep_water ref;
    tp_turn phases[TP_WAVES];
    double  ref_phases[TP_WAVES];
    uint64_t tick;
} deep_water;

static inline void deep_water_settle(deep_water *o)
{
    tp_deep_water_init(&o->deep, o->wave, (uint32_t)o->count, o->gravity);
    o->ref = ref_deep_water_make(o->wave, o->count, o->gravity);
    assert_int_equal(o->deep.count, o->ref.count);
    tp_deep_water_phases(&o->deep, o->tick, 0, o->phases);
    ref_phases(&o->ref, o->tick, o->ref_phases);
}

/* One to `most` random waves from the whole ranges of the parameter table. */
static inline deep_water deep_water_any(uint64_t *chance, int most)
{
    deep_water o = { .count = chance_int(chance, 1, most) };

    for (int i = 0; i < o.count; i++)
        o.wave[i] = chance_wave(chance);
    o.gravity = chance_scale(chance, 0.1, 100);
    o.tick = random_next(chance) % TEN_YEARS;
    deep_water_settle(&o);
    return o;
}

/* Waves as usual scenes have them: 1 m or longer, at most as high as a seventh of the
 * length. */
static inline deep_water deep_water_usual(uint64_t *chance, int most, double steepness)
{
    deep_water o = { .count = chance_int(chance, 1, most), .gravity = TP_FX(9.81) };

    for (int i = 0; i < o.count; i++) {
        o.wave[i] = chance_wave(chance);
        o.wave[i].length = chance_scale(chance, 1, 200);
        o.wave[i].amplitude = chance_scale(chance, 0.001, 2);
        if (o.wave[i].amplitude > o.wave[i].length / 14)
            o.wave[i].amplitude = o.wave[i].length / 14;
        o.wave[i].steepness = (tp_fx)(steepness / o.count / LSB);
        o.wave[i].speed = TP_FX_ONE;
    }
    o.tick = random_next(chance) % TEN_YEARS;
    deep_water_settle(&o);
    return o;
}

/* Gives the waves random powers of [A3]. */
static inline void deep_water_sharpen(uint64_t *chance, deep_water *o)
{
    for (int i = 0; i < o->count; i++)
        o->wave[i].exponent = chance_int(chance, 0, 8);
    deep_water_settle(o);
}

/* Bound of a wave's phase error, in radians.  Wave numbers in turns per metre are rounded
 * to Q0.32; directions have 28 bits (rotations, arithmetic.h) and a heading of 2^-31 turn;
 * phases are truncated to 2^-32 turn four times; the clock errs by 2^-62 turn per tick
 * (speed up to 8). */
static inline double phase_error(const deep_water *o, int i, double x0, double z0)
{
    const double e32 = 1 / 4294967296.0, way = fabs(x0) + fabs(z0);
    const double direction = 7e-9 + 2 * PI * 2 * e32;
    return 2 * PI * (way * e32 + 4 * e32 + (double)o->tick * e32 / 1073741824.0)
         + o->ref.wave[i].k * way * direction;
}

/* Sensitivity of f and f' of [A3] to sine, cosine and phase: f = 2 b^n changes at most by
 * n, f' = n b^(n-1) cos at most by n + n(n-1)/2. */
static inline double rise_most(const ref_wave *w)
{
    return w->power;
}

static inline double turn_most(const ref_wave *w)
{
    return w->power * (w->power + 1) / 2.0;
}

/* Bound of the height error: each wave's profile, A rounded to 16.16, the sum rounded. */
static inline double height_error(const deep_water *o, double x0, double z0)
{
    double sum = LSB;
    for (int i = 0; i < o->ref.count; i++) {
        const ref_wave *w = &o->ref.wave[i];
        sum += w->amplitude * rise_most(w) * (SINE + phase_error(o, i, x0, z0)) + LSB;
    }
    return sum;
}

/* Bound of the error in x or z: QA is Q k A L / 2 pi, L has a relative error of 2.5e-7, and
 * two roundings. */
static inline double place_error(const deep_water *o, double x0, double z0)
{
    double sum = LSB;
    for (int i = 0; i < o->ref.count; i++) {
        const ref_wave *w = &o->ref.wave[i];
        sum += w->q / w->k * (SINE + 2.5e-7 + phase_error(o, i, x0, z0)) + 1.5 * LSB;
    }
    return sum;
}

/* Bound of the angle error of the normal, in radians.  h is the sum of k A f' with A off by
 * half an LSB and L by 2.5e-7 relative, J the sum of q sin th with q off by 2e-8; N
 * consists of products of both.  Slopes have an error of one LSB and are clamped to
 * 7.99. */
static inline double normal_error(const deep_water *o, const ref_point *p, double x0,
                                  double z0)
{
    double h = 1 / 16777216.0, j = 1 / 268435456.0;

    for (int i = 0; i < o->ref.count; i++) {
        const ref_wave *w = &o->ref.wave[i];
        const double e = SINE + phase_error(o, i, x0, z0), ka = w->k * w->amplitude;
        h += ka * (turn_most(w) * e + 2.5e-7) + 2.5 * w->k * LSB / 2;
        j += w->q * e + 2e-8;
    }
    const double tilt = fabs(p->hx) + fabs(p->hz);
    const double size = fabs(p->jxx) + fabs(p->jxz) + fabs(p->jzz);
    const double n = 2 * (h * size + j * tilt + h * j) + 2 * j * size + j * j;
    const double length = sqrt(p->nx * p->nx + p->ny * p->ny + p->nz * p->nz);
    return asin(fmin(1, n / length)) + 2 * LSB;
}

/* Angle between two normals given as slopes, in radians. */
static inline double slope_angle(double ax, double az, double bx, double bz)
{
    const double cx = az - bz, cy = bx * az - bz * ax, cz = bx - ax;
    return atan2(sqrt(cx * cx + cy * cy + cz * cz), 1 + ax * bx + az * bz);
}

/* Angle between the slopes' normal and the reference normal, whose slopes are clamped
 * likewise. */
static inline double normal_angle(const ref_point *p, const tp_surface_point *got)
{
    const double most = 7.99;
    return slope_angle(fmax(-most, fmin(most, -p->nx / p->ny)),
                       fmax(-most, fmin(most, -p->nz / p->ny)),
                       got->slope_x * LSB, got->slope_z * LSB);
}

typedef struct {
    measure height, place, normal;
} errors;

static inline errors errors_of(const char *height, const char *place, const char *normal)
{
    return (errors){ { .what = height, .unit = "mm" }, { .what = place, .unit = "mm" },
                     { .what = normal, .unit = "degrees" } };
}

static inline void errors_print(const errors *e)
{
    measure_print(&e->height);
    measure_print(&e->place);
    measure_print(&e->normal);
}

/* Compares the point with rest position (x, z) with the reference, within the bounds
 * above. */
static inline void deep_water_compare(const deep_water *o, tp_fx x, tp_fx z, errors *e)
{
    const double x0 = x * LSB, z0 = z * LSB;
    ref_point want = ref_at_rest(&o->ref, o->ref_phases, x0, z0);
    const tp_surface_point got = tp_deep_water_displace_point(&o->deep, o->phases, x, z);
    const double height = got.position.y * LSB - want.y;
    const double place = fmax(fabs(got.position.x * LSB - want.x),
                              fabs(got.position.z * LSB - want.z));
    if (!o->deep.crossed)
        want = ref_uncrossed(want);
    const double angle = normal_angle(&want, &got);

    measure_add(&e->height, height * 1000, (int64_t)o->tick, x, z);
    measure_add(&e->place, place * 1000, (int64_t)o->tick, x, z);
    measure_add(&e->normal, angle * 180 / PI, (int64_t)o->tick, x, z);
    assert_true(fabs(height) <= height_error(o, x0, z0));
    assert_true(place <= place_error(o, x0, z0));
    assert_true(angle <= normal_error(o, &want, x0, z0));
    assert_true(fabs(got.position.y * LSB) <= o->deep.height * LSB + 2 * LSB);
    assert_true(fabs(got.position.x * LSB - x0)
                <= o->deep.max_displacement * LSB + 2 * LSB);
    assert_true(fabs(got.position.z * LSB - z0)
                <= o->deep.max_displacement * LSB + 2 * LSB);
}
#endif
