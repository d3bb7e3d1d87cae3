/* SPDX-License-Identifier: MIT */
/* Shading of drops: clear balls that show the world upside down. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "mesh/mesh.h"
#include "tests/lib/shading.h"
#include "tidepool/modules.h"

static uint64_t chance;
static uint8_t gloss[TP_GLOSS];
static const tp_solid clear = { .diffuse = 0xffffff, .gloss = gloss };

/* A level camera that looks north, a blue sky over a white horizon, and black water. */
static tp_shade level_view(void)
{
    static uint32_t sky[TP_SKY + 1];
    tp_shade s = {
        .sky = sky, .u0 = 16 * 32 + 8, .v0 = 16 * 100 + 8, .focal = 400 * 16,
        .world = { { TP_Q30_ONE, 0, 0 }, { 0, TP_Q30_ONE, 0 }, { 0, 0, TP_Q30_ONE },
                   0, 16384, 0 },
        .ambient = 256, .fresnel = tp_fresnel_table,
    };
    tp_shade_sky(sky, 0xffffff, 0x0000ff);
    return s;
}

/* Colour of the drop where its normal is tilted up or down from the view by this angle. */
static uint32_t drop_at(const tp_shade *s, const tp_solid *drop, double lean)
{
    test_run r;

    run_any(&r, 0, &chance);
    r.run.x = 0;
    r.run.y = 100;
    for (int i = 0; i < TP_RUN; i++)
        r.n[i] = tp_dir_pack(tp_normalise(0, (int32_t)lround(1e6 * sin(lean)),
                                          (int32_t)lround(1e6 * cos(lean))));
    r.run.mine = drop;
    tp_stage_drop(s, &r.run);
    return r.run.colour[32];
}

/* Elevation of the refracted ray: turned by twice i - r, sin i = 1.333 sin r, towards the
 * middle; rays low on the ball go up. */
static double elevation(double lean)
{
    return -2 * (lean - asin(sin(lean) / 1.333));
}

/* Red is a measure of the elevation: the horizon's share is (1 - sine)^2.  The parabolas
 * are within 0.05 of the true direction, twice 255 of which is the gradient's slope; the
 * Fresnel share of the reflection is below 0.07 here. */
static void the_world_stands_upside_down_in_a_drop(void **state)
{
    (void)state;
    const tp_shade s = level_view();

    for (double lean = 0; lean < 1; lean += 0.05) {
        const double up = sin(elevation(-lean));
        const double want = 255 * (1 - up) * (1 - up);
        assert_true(fabs((drop_at(&s, &clear, -lean) >> 16) - want)
                    <= 255 * 0.1 + 0.07 * 255);
    }
    assert_true((drop_at(&s, &clear, -0.9) >> 16) < 120);           /* sky below */
    assert_true((drop_at(&s, &clear, 0.9) & 0xff) < 120);           /* water above */
    assert_true((drop_at(&s, &clear, 0) >> 16) > 240);              /* the horizon */
}

/* At grazing view a drop reflects everything behind the drop. */
static void its_rim_mirrors(void **state)
{
    (void)state;
    const tp_shade s = level_view();
    const tp_solid dark = { .gloss = gloss };   /* no light passes through */

    assert_true((drop_at(&s, &dark, -0.2) >> 16) < 12);
    assert_true((drop_at(&s, &dark, 1.55) >> 16) > 180);
}

static void it_shines_where_the_light_is_mirrored(void **state)
{
    (void)state;
    tp_shade s = level_view();
    const tp_solid dark = { .specular = 0xffffff, .gloss = gloss };

    s.light_colour = 0xffffff;
    tp_shade_gloss(gloss, 40 * TP_FX_ONE);
    assert_true((drop_at(&s, &dark, 3.14159 / 4) & 0xff) > 220);
    assert_true((drop_at(&s, &dark, 3.14159 / 4 + 0.3) & 0xff) < 120);
    memset(gloss, 0, sizeof gloss);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_world_stands_upside_down_in_a_drop),
        cmocka_unit_test(its_rim_mirrors),
        cmocka_unit_test(it_shines_where_the_light_is_mirrored),
    };
    return cmocka_run_group_tests_name("features/drops stage", tests, NULL, NULL);
}
