/* SPDX-License-Identifier: MIT */
/* Rings of drops compared with [A4] [A5] in double precision: the models' vectors, and any
 * rings of the header's ranges at any position and time.  Tolerances are the resolution of
 * the formats, see bounds_of(); the test prints the errors. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "tests/lib/vectors.h"
#include "waves/deep_water.h"

#define LSB    (1 / 65536.0)
#define TAU    6.283185307179586
#define SECOND (60 * 65536.0)           /* in ring time units */
#define SINE   4.8e-6                   /* error of tp_sin, see arithmetic.h */
#define STEEP  7.99                     /* clamp of slopes */

static uint64_t chance;

/* -- the reference ------------------------------------------------------------------- */

typedef struct {
    double height, slope;               /* slope: along the distance */
} ring_height_slope;

static double ref_gain(const tp_ring *r, double a)
{
    const double rise = r->attack * LSB, t = a < rise ? a / rise : 1;
    return r->amplitude * LSB * t * t * (3 - 2 * t) * exp(-a / (r->decay * LSB));
}

/* Height and slope `a` seconds after the ring's start, rho m from its centre. */
static ring_height_slope ref_ring(const tp_ring *r, double a, double rho)
{
    const double length = r->length * LSB, spread = r->spread * LSB;
    const double xi = rho - length / 2 - r->speed * LSB * a;
    if (a <= 0 || fabs(xi) >= length / 2)
        return (ring_height_slope){ 0, 0 };
    const double s = 1 / sqrt(1 + rho / spread), w = (1 + cos(TAU * xi / length)) / 2;
    const double dw = -TAU / 2 / length * sin(TAU * xi / length);
    return (ring_height_slope){ ref_gain(r, a) * s * w,
                         ref_gain(r, a) * (s * dw - s * s * s * w / (2 * spread)) };
}

/* Error bounds of the formats.  Distance: 2^-28 relative by its root and 2^-24 by its
 * format, the rear 2^-25; as a share of the length the sum is the phase error, plus half of
 * 2^-32 turns per metre.  Roots and e^-x are within 2^-28, gains within 2^-24, pi / L
 * within 2^-22 absolute and 2^-22 relative, the sum is rounded to an LSB. */
static ring_height_slope bounds_of(const tp_ring *r, double a, double rho)
{
    const double q22 = 1 / 4194304.0, q24 = 1 / 16777216.0, q28 = 1 / 268435456.0;
    const double length = r->length * LSB, pi_l = TAU / 2 / length;
    const double way = rho * q28 + 2 * q24;
    const double phase = TAU * (way / length + length * q28 / 16);
    const double gain = ref_gain(r, a), e = SINE + phase;
    return (ring_height_slope){
        gain * (e / 2 + 4 * q28) + 4 * q24 + 0.51 * LSB,
        gain * (pi_l * (e + 2 * q22) + e / (r->spread * LSB) + 3 * q22)
            + 4 * q24 * (pi_l + 1 / (r->spread * LSB) + 1) + 0.6 * LSB,
    };
}

static tp_ring any_ring(void)
{
    return (tp_ring){
        .x = chance_fx(&chance, -8000, 8000), .z = chance_fx(&chance, -8000, 8000),
        .start = (int64_t)(random_next(&chance) >> 14),     /* up to nine years */
        .amplitude = chance_scale(&chance, 0.001, 4),
        .length = chance_scale(&chance, 0.02, 64),
        .speed = chance_scale(&chance, 0.01, 64),
        .decay = chance_scale(&chance, 0.05, 1000),
        .spread = chance_scale(&chance, 0.01, 1000),
        .attack = chance_int(&chance, 0, 3) ? chance_fx(&chance, 0, 8) : 0,
    };
}

/* An age at which a part of the ring may be left, ticks x 65536. */
static int64_t any_age(const tp_ring *r)
{
    const double most = 6 * r->decay * LSB, far = 12000.0 * TP_FX_ONE / r->speed;
    return 1 + (int64_t)(chance_double(&chance, 0, fmin(most, far)) * SECOND);
}

/* -- heights and slopes -------------------------------------------------------------- */

typedef struct {
    measure height, slope, normal;
} ring_errors;

static ring_errors errors_of(const char *height, const char *slope, const char *normal)
{
    return (ring_errors){ { .what = height, .unit = "mm" },
                          { .what = slope, .unit = "LSB" },
                          { .what = normal, .unit = "degrees" } };
}

static double held(double slope)
{
    return fmax(-STEEP, fmin(STEEP, slope));
}

/* Compares one ring at a point. */
static void compare(const tp_ring *r, int64_t age, tp_fx x, tp_fx z, ring_errors *e)
{
    tp_ring_now at;
    if (!tp_ring_evaluate(r, r->start + age, &at)) {
        assert_true(ref_gain(r, (double)age / SECOND) < 1 / 16777216.0);
        return;
    }
    const double a = (double)age / SECOND;
    const double dx = ((double)x - r->x) * LSB, dz = ((double)z - r->z) * LSB;
    const double rho = hypot(dx, dz);
    const ring_height_slope want = ref_ring(r, a, rho), bound = bounds_of(r, a, rho);
    const tp_height_slope got = tp_ring_height_slope(&at, 1, x, z);
    const double slope = rho > 0 ? held(want.slope) / rho : 0;
    const double height = got.height * LSB - want.height;
    const double tilt = fmax(fabs(got.slope_x * LSB - slope * dx),
                             fabs(got.slope_z * LSB - slope * dz));

    measure_add(&e->height, height * 1000, age, x, z);
    measure_add(&e->slope, tilt / LSB, age, x, z);
    assert_true(fabs(height) <= bound.height);
    assert_true(tilt <= bound.slope);
}

/* Points within the ring's band, and slightly beside. */
static void any_ring_follows_the_models(void **state)
{
    (void)state;
    ring_errors e = errors_of("any height", "any slope", "");

    for (int n = 0; n < 3000; n++) {
        const tp_ring r = any_ring();
        const int64_t age = any_age(&r);
        const double rear = r.speed * LSB * (double)age / SECOND;
        for (int k = 0; k < 20; k++) {
            const double rho = rear + chance_double(&chance, -0.1, 1.1) * r.length * LSB;
            const double round = chance_double(&chance, 0, TAU);
            compare(&r, age, r.x + (tp_fx)lround(rho * cos(round) / LSB),
                    r.z + (tp_fx)lround(rho * sin(round) / LSB), &e);
        }
    }
    measure_print(&e.height);
    measure_print(&e.slope);
}

/* Reads the vectors' rings from comments: centre, start, A, L, c, tau, rho0, attack. */
static uint32_t read_rings(FILE *file, tp_ring ring[8])
{
    char     line[512];
    uint32_t count = 0;
    double   n[9];

    while (count < 8 && fgets(line, sizeof line, file) != NULL && line[0] == '#') {
        int which;
        if (sscanf(line, "# ring %d: cx=%lf cz=%lf t0=%lf A=%lf L=%lf c=%lf tau=%lf "
                   "p0=%lf tr=%lf", &which, &n[0], &n[1], &n[2], &n[3], &n[4], &n[5],
                   &n[6], &n[7], &n[8]) != 10)
            continue;
        ring[count++] = (tp_ring){
            .x = (tp_fx)lround(n[0] / LSB), .z = (tp_fx)lround(n[1] / LSB),
            .start = llround(n[2] * SECOND), .amplitude = (tp_fx)lround(n[3] / LSB),
            .length = (tp_fx)lround(n[4] / LSB), .speed = (tp_fx)lround(n[5] / LSB),
            .decay = (tp_fx)lround(n[6] / LSB), .spread = (tp_fx)lround(n[7] / LSB),
            .attack = (tp_fx)lround(n[8] / LSB),
        };
    }
    return count;
}

/* Angle between two normals, in degrees. */
static double angle(const double a[3], const double b[3])
{
    const double c[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                          a[0] * b[1] - a[1] * b[0] };
    return atan2(sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]),
                 a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 360 / TAU;
}

static uint32_t rings_at(const tp_ring *ring, uint32_t count, int64_t now,
                         tp_ring_now *at)
{
    uint32_t shown = 0;
    for (uint32_t i = 0; i < count; i++)
        shown += tp_ring_evaluate(&ring[i], now, &at[shown]);
    return shown;
}

static void rows_of_the_models_agree(void **state)
{
    (void)state;
    FILE *const file = fopen("tests/vectors/droplet_waves.csv", "r");
    assert_non_null(file);
    ring_errors e = errors_of("rows, height", "", "rows, normal");
    tp_ring ring[8];
    tp_ring_now at[8];
    const uint32_t count = read_rings(file, ring);
    double v[12];

    assert_int_equal(count, 5);
    while (csv_row(file, v, 12) == 12) {
        const uint32_t shown = rings_at(ring, count, llround(v[2] * SECOND), at);
        const tp_height_slope got = tp_ring_height_slope(
            at, shown, (tp_fx)lround(v[0] / LSB), (tp_fx)lround(v[1] / LSB));
        const double normal[3] = { -got.slope_x * LSB, 1, -got.slope_z * LSB };
        measure_add(&e.height, (got.height * LSB - v[3]) * 1000, 0, 0, 0);
        measure_add(&e.normal, angle(normal, &v[6]), 0, 0, 0);
    }
    fclose(file);
    measure_print(&e.height);
    measure_print(&e.normal);
    assert_int_equal(e.height.inputs, 200);
    assert_true(e.height.worst < 0.25);
    assert_true(e.normal.worst < 0.05);
}

/* -- shape of a ring ----------------------------------------------------------------- */

/* Along a radius: zero up to the rear, a rise to one crest, a fall, then zero. */
static void a_ring_has_exactly_one_crest(void **state)
{
    (void)state;
    for (int n = 0; n < 300; n++) {
        tp_ring r = any_ring();
        tp_ring_now at;
        r.amplitude = chance_scale(&chance, 0.05, 4);
        const int64_t age = any_age(&r);
        if (!tp_ring_evaluate(&r, r.start + age, &at))
            continue;
        const double rear = r.speed * LSB * (double)age / SECOND;
        tp_fx last = 0;
        bool  falling = false;
        for (int k = -20; k < 220; k++) {
            const double rho = rear + k * r.length * LSB / 200;
            if (rho < 0)
                continue;
            const tp_fx x = r.x + (tp_fx)lround(rho / LSB);
            const tp_fx y = tp_ring_height_slope(&at, 1, x, r.z).height;
            assert_true(y >= 0);
            if (k <= 0 || k >= 201)
                assert_in_range(y, 0, 1);
            falling |= y < last - 1;        /* a flat crest may round up and down */
            assert_true(!falling || y <= last + 1);
            last = y;
        }
    }
}

static void its_centre_lies_still_from_the_first_moment(void **state)
{
    (void)state;
    for (int n = 0; n < 5000; n++) {
        const tp_ring r = any_ring();
        tp_ring_now at;
        const int64_t age = n % 2 ? any_age(&r) : 1 + n % 7;
        if (!tp_ring_evaluate(&r, r.start + age, &at))
            continue;
        const tp_height_slope middle = tp_ring_height_slope(&at, 1, r.x, r.z);
        assert_int_equal(middle.height, 0);
        assert_int_equal(middle.slope_x, 0);
        assert_int_equal(middle.slope_z, 0);
    }
}

/* A shift of start and moment by the same fraction of a tick changes no bit. */
static void a_ring_starts_between_ticks(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const tp_ring r = any_ring();
        tp_ring later = r;
        tp_ring_now a, b;
        const int64_t shift = chance_int(&chance, 1, 65535), age = any_age(&r);
        later.start += shift;
        assert_false(tp_ring_evaluate(&later, later.start, &b));
        assert_false(tp_ring_evaluate(&later, r.start, &b));
        const bool there = tp_ring_evaluate(&r, r.start + age, &a);
        assert_int_equal(tp_ring_evaluate(&later, later.start + age, &b), there);
        if (there)
            assert_memory_equal(&a, &b, sizeof a);
    }
}

/* The height shortly before and after `attack`, and directly at the start. */
static void it_rises_without_a_jump(void **state)
{
    (void)state;
    tp_ring r = { .amplitude = TP_FX(0.1), .length = TP_FX_ONE, .speed = TP_FX_ONE,
                  .decay = TP_FX(2), .spread = TP_FX_ONE, .attack = TP_FX(0.1) };
    int32_t last = 0;
    tp_ring_now at;

    for (int64_t age = 1; age < 6 * 65536; age += 4096) {
        const int32_t gain = tp_ring_evaluate(&r, age, &at) ? at.gain_q24 : 0;
        assert_in_range(gain, last, last + (int)(1.6 / 96 * 0.1 * 16777216));
        last = gain;
    }
    r.attack = 0;
    assert_true(tp_ring_evaluate(&r, 1, &at));
    assert_in_range(at.gain_q24, r.amplitude * 256 - 64, r.amplitude * 256);
}

/* -- many rings ---------------------------------------------------------------------- */

static void rings_add_up(void **state)
{
    (void)state;
    enum { MANY = 40 };
    for (int n = 0; n < 200; n++) {
        tp_ring_now at[MANY];
        const int64_t now = 1 << 24;
        uint32_t count = 0;
        for (int i = 0; i < MANY; i++) {
            tp_ring r = any_ring();
            r.x = chance_fx(&chance, -5, 5);
            r.z = chance_fx(&chance, -5, 5);
            r.length = chance_scale(&chance, 1, 64);
            r.start = now - chance_int(&chance, 0, 600 * 65536);
            count += tp_ring_evaluate(&r, now, &at[count]);
        }
        const tp_fx x = chance_fx(&chance, -10, 10), z = chance_fx(&chance, -10, 10);
        const tp_height_slope all = tp_ring_height_slope(at, count, x, z);
        int64_t height = 0, slope_x = 0, slope_z = 0;
        for (uint32_t i = 0; i < count; i++) {
            const tp_height_slope one = tp_ring_height_slope(&at[i], 1, x, z);
            height += one.height;
            slope_x += one.slope_x;
            slope_z += one.slope_z;
        }
        assert_true(llabs(all.height - height) <= MANY / 2 + 1);
        assert_true(llabs(all.slope_x - slope_x) <= MANY / 2 + 1);
        assert_true(llabs(all.slope_z - slope_z) <= MANY / 2 + 1);
    }
}

/* Rings of any size and age at any position of the format, for the sanitizers. */
static void no_place_is_out_of_range(void **state)
{
    (void)state;
    const tp_height_slope none = tp_ring_height_slope(NULL, 0, 0, 0);
    assert_int_equal(none.height, 0);

    for (int n = 0; n < 20000; n++) {
        tp_ring r = any_ring();
        tp_ring_now at;
        r.x = (tp_fx)(uint32_t)random_next(&chance);
        r.z = (tp_fx)(uint32_t)random_next(&chance);
        if (!tp_ring_evaluate(&r, r.start + any_age(&r), &at))
            continue;
        const tp_fx x = (tp_fx)(uint32_t)random_next(&chance);
        const tp_fx near = (tp_fx)tp_clamp((int32_t)(r.x / 2 + (at.outer - 1) / 2),
                                           TP_FX_MIN / 2, TP_FX_MAX / 2) * 2;
        const tp_height_slope a = tp_ring_height_slope(&at, 1, x, r.z);
        const tp_height_slope b = tp_ring_height_slope(&at, 1, near, r.z);
        assert_in_range(a.height, 0, 4 * TP_FX_ONE);
        assert_in_range(b.height, 0, 4 * TP_FX_ONE);
        assert_true(tp_abs(a.slope_x) <= TP_FX(STEEP));
        assert_true(tp_abs(b.slope_x) <= TP_FX(STEEP));
    }
}

/* -- end of a ring ------------------------------------------------------------------- */

static double height_left(const tp_ring *r, int64_t age)
{
    const double a = (double)age / SECOND, rc = r->length * LSB / 2 + r->speed * LSB * a;
    const double s = 1 / sqrt(1 + rc / (r->spread * LSB));
    return r->amplitude * LSB * exp(-a / (r->decay * LSB)) * s;
}

static void a_ring_is_spent_when_it_is_low_or_far(void **state)
{
    (void)state;
    int low = 0, far = 0;

    for (int n = 0; n < 20000; n++) {
        const tp_ring r = any_ring();
        const tp_fx beyond = chance_scale(&chance, 1, 8000);
        const int64_t age = 1 + (int64_t)(chance_double(&chance, 0, 25) * r.decay * 60);
        const double left = height_left(&r, age) / LSB;
        const double rear = r.speed * LSB * (double)age / SECOND;
        const double over = rear / (beyond * LSB);
        const double front = (rear + r.length * LSB) / 16384;
        const bool spent = tp_ring_is_spent(&r, r.start + age, beyond);
        if (fabs(left - 1) < 0.01 || fabs(over - 1) < 1e-4 || fabs(front - 1) < 1e-4)
            continue;
        assert_int_equal(spent, left < 1 || over > 1 || front > 1);
        low += left < 1;
        far += over > 1;
    }
    assert_true(low > 1000 && far > 1000);
}

static void once_spent_it_stays_so(void **state)
{
    (void)state;
    for (int n = 0; n < 500; n++) {
        const tp_ring r = any_ring();
        bool spent = false;
        for (int64_t age = -65536; age < (int64_t)1 << 48; age += age / 4 + 65536) {
            const bool now = tp_ring_is_spent(&r, r.start + age, TP_FX(1000));
            assert_true(now || !spent);
            assert_true(age > 0 || !now);
            spent = now;
        }
        assert_true(spent);
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_ring_follows_the_models),
        cmocka_unit_test(rows_of_the_models_agree),
        cmocka_unit_test(a_ring_has_exactly_one_crest),
        cmocka_unit_test(its_centre_lies_still_from_the_first_moment),
        cmocka_unit_test(a_ring_starts_between_ticks),
        cmocka_unit_test(it_rises_without_a_jump),
        cmocka_unit_test(rings_add_up),
        cmocka_unit_test(no_place_is_out_of_range),
        cmocka_unit_test(a_ring_is_spent_when_it_is_low_or_far),
        cmocka_unit_test(once_spent_it_stays_so),
    };
    return cmocka_run_group_tests_name("waves/ring", tests, NULL, NULL);
}
