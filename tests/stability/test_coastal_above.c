/* SPDX-License-Identifier: MIT */
/* The surface above a point over a floor [E1]: the error of the search where the sum of
 * steepnesses is near 1.  In shallow water the sum is always near 1: orbits grow in length
 * up to the clamp at 0.95 [B13].  Twelve plain steps had errors up to 1.4 m there.
 *
 *     TP_SOAK=1       twenty times as many coastal waters */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/coastal_water.h"
#include "view/surface.h"

static uint64_t chance;

static int times(int usual)
{
    return getenv("TP_SOAK") != NULL ? 20 * usual : usual;
}

static tp_floor floor_of(double depth, double slope, double up)
{
    return (tp_floor){ .depth = (tp_fx)lround(depth * 65536),
                       .slope = (tp_fx)lround(slope * 65536),
                       .heading = (tp_fx)lround(up * 65536) };
}

typedef struct {
    double worst, squares;      /* m, m^2 */
    int    places;
} search_errors;

static coastal_water sea_over(const tp_floor *floor, double steepness)
{
    coastal_water o = { .count = (uint32_t)chance_int(&chance, 1, 6),
                        .config = coastal_usual() };

    for (uint32_t i = 0; i < o.count; i++) {
        const double length = chance_scale(&chance, 2, 80) * LSB;
        o.wave[i] = coastal_wave(length / 40, length, steepness / o.count,
                                 chance_double(&chance, 0, 360));
    }
    o.config.floor = *floor;
    coastal_build(&o);
    return o;
}

static void search_one(const coastal_water *o, search_errors *s)
{
    const tp_fx x = chance_fx(&chance, -60, 60), z = chance_fx(&chance, -60, 60);
    tp_fx rest[2] = { x, z };
    tp_turn phases[TP_WAVES];
    const tp_surface surface = {
        .by = &tp_program_all.water,
        .deep = &o->deep,
        .phases = phases,
        .coastal = o->coastal,
    };

    for (int i = 0; i < TP_WAVES; i++)
        phases[i] = (tp_turn)random_next(&chance);
    const tp_surface_point p = tp_surface_sample(&surface, x, z, rest);
    const double off = hypot(p.position.x - x, p.position.z - z) * LSB;
    assert_true(off <= 0.001);
    assert_true(abs(p.position.y) <= tp_coastal_max_height(o->coastal));
    s->places++;
    s->squares += off * off;
    s->worst = fmax(s->worst, off);
}

static void search_all(const char *where, const tp_floor *floor, double steepness)
{
    search_errors s = { 0, 0, 0 };

    for (int n = 0; n < times(150); n++) {
        coastal_water o = sea_over(floor, steepness);
        for (int k = 0; k < 20; k++)
            search_one(&o, &s);
        coastal_end(&o);
    }
    printf("# %-12s %.2f %12.5f %9.5f\n", where, steepness, s.worst,
           sqrt(s.squares / s.places));
}

static void a_place_is_found_within_a_millimetre_whatever_the_floor(void **state)
{
    (void)state;
    static const double steepness[] = { 0.3, 0.5, 0.7, 0.9, 0.95 };
    const tp_floor deep = floor_of(200, 0, 0), level = floor_of(4, 0, 0);
    const tp_floor slope = floor_of(4, 0.05, 90);

    printf("# floor  steepness  worst miss, m       rms\n");
    for (int i = 0; i < 5; i++)
        search_all("200 m", &deep, steepness[i]);
    for (int i = 0; i < 5; i++)
        search_all("4 m", &level, steepness[i]);
    for (int i = 0; i < 5; i++)
        search_all("1 in 20", &slope, steepness[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_place_is_found_within_a_millimetre_whatever_the_floor),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("stability of places", tests, NULL, NULL);
}
