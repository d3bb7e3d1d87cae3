/* SPDX-License-Identifier: MIT */
/* Quick light: its plain and packed bodies have the same bits, however runs are cut, and
 * it is not far from what the exact stages make of the same slopes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "shade/quick_light_m4.h"
#include "shade/quick_light_plain.h"
#include "skies.h"

static uint64_t chance;
static test_sky sky;
static struct tp_quick_light quick;

typedef struct {
    stage *plain, *packed;
    int    env, lobe;
} bodies;

#define X(name, env, lobe) \
    static void plain_##name(const tp_shade *shade, tp_run *run) \
    { plain_light(shade, run, env, lobe); } \
    static void packed_##name(const tp_shade *shade, tp_run *run) \
    { packed_light(shade, run, env, lobe); }
TP_QUICK_LIGHT_STAGES(X)
#undef X

static const bodies all[] = {
#define X(name, env, lobe) { plain_##name, packed_##name, env, lobe },
    TP_QUICK_LIGHT_STAGES(X)
#undef X
};
enum { ALL = sizeof all / sizeof *all };

/* A sky that changes slowly. */
static uint32_t smooth(ref_dir d, void *with)
{
    (void)with;
    return (uint32_t)(128 + 100 * d.x) << 16 | (uint32_t)(128 + 100 * d.y) << 8
         | (uint32_t)(128 + 100 * d.z);
}

static tp_shade shade_for(const bodies *b)
{
    tp_shade s = shade_any(&chance);

    if (b->env == TP_ENV_DOME)
        sky_dome(&sky, &s, &chance);
    if (b->env == TP_ENV_CUBE)
        sky_cube(&sky, &s, smooth, NULL);
    s.env.beyond = 0;
    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    s.env.least = b->lobe == TP_LOBE_NONE ? 0 : TP_DISC_END;
    const tp_fx shininess = chance_int(&chance, 10, 200) * TP_FX_ONE;
    if (b->lobe == TP_LOBE_BLINN)
        tp_shade_shine_blinn(&s, shininess, TP_FX_ONE);
    else
        tp_shade_shine(&s, shininess, TP_FX_ONE);
    s.quick = &quick;
    tp_quick_light_init(&quick, &s, (tp_lobe)b->lobe, b->lobe != TP_LOBE_NONE, true);
    return s;
}

/* The slopes as sampled; every eighth as steep as 16 bits go. */
static void run_of(test_run *r, int32_t steep)
{
    run_any(r, steep, &chance);
    for (int i = 0; i < TP_RUN; i++)
        r->run.slope[i] = steep > 30000 && i % 8 == 0
                              ? 0x80008000u ^ (uint32_t)chance_int(&chance, 0, 3) * 0xffff
                              : r->n[i];
}

static void both_bodies_have_the_same_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 4000; n++) {
        const bodies *b = &all[n % ALL];
        const tp_shade s = shade_for(b);
        test_run r;
        run_of(&r, n / ALL % 2 ? 32000 : 3000);
        const int32_t from = chance_int(&chance, 0, TP_RUN - 1);
        tp_run plain = run_part(&r.run, from, chance_int(&chance, from + 1, TP_RUN));
        memmove(plain.slope, r.run.slope + from, (size_t)plain.count * 4);
        tp_run packed = plain;
        b->plain(&s, &plain);
        b->packed(&s, &packed);
        assert_memory_equal(plain.colour, packed.colour, (size_t)plain.count * 4);
        for (int i = 0; i < plain.count; i++)
            assert_int_equal(plain.colour[i] >> 24, 0);
    }
}

static void where_a_run_is_cut_does_not_show(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const bodies *b = &all[n % ALL];
        const tp_shade s = shade_for(b);
        test_run r;
        run_of(&r, 4000);
        const int32_t cut = chance_int(&chance, 1, TP_RUN - 1);
        tp_run whole = r.run, left = run_part(&r.run, 0, cut);
        tp_run right = run_part(&r.run, cut, TP_RUN);
        memmove(left.slope, r.run.slope, (size_t)cut * 4);
        memmove(right.slope, r.run.slope + cut, (size_t)(TP_RUN - cut) * 4);
        b->packed(&s, &whole);
        b->packed(&s, &left);
        b->packed(&s, &right);
        assert_memory_equal(whole.colour, left.colour, (size_t)cut * 4);
        assert_memory_equal(whole.colour + cut, right.colour, (size_t)(TP_RUN - cut) * 4);
    }
}

/* -- against the exact stages -------------------------------------------------------- */

static void exact(const bodies *b, const tp_shade *s, tp_run *run)
{
    for (int i = 0; i < run->count; i++) {
        run->sx[i] = (int16_t)(run->n[i] >> 16);
        run->sz[i] = (int16_t)(run->n[i] & 0xffff);
    }
    tp_stage_view(s, run);
    if (b->lobe == TP_LOBE_BLINN)
        tp_stage_light_blinn_rippled(s, run);
    else
        tp_stage_light_rippled(s, run);
    if (b->env == TP_ENV_DOME)
        tp_stage_reflect_dome(s, run);
    else if (b->env == TP_ENV_CUBE)
        tp_stage_reflect_cube(s, run);
    else
        tp_stage_reflect_gradient(s, run);
    tp_stage_fresnel(s, run);
    if (b->lobe != TP_LOBE_NONE)
        tp_stage_glint(s, run);
}

/* Water seen from above. */
static bool is_seen(const tp_run *run, int i)
{
    return run->vy[i] > 800;
}

static double compare(const bodies *b, const char *what, int32_t steep, bool shiny)
{
    tally off = { .what = what };

    for (int n = 0; n < 3000; n++) {
        tp_shade s = shade_for(b);
        if (!shiny) {
            memset(s.shine, 0, sizeof s.shine);
            tp_quick_light_init(&quick, &s, (tp_lobe)b->lobe, false, true);
        }
        test_run r;
        run_of(&r, steep);
        tp_run fast = r.run;
        exact(b, &s, &r.run);
        b->plain(&s, &fast);
        for (int i = 0; i < TP_RUN; i++)
            if (is_seen(&r.run, i))
                tally_add(&off, fast.colour[i], ref_colour_of(r.run.colour[i]));
    }
    tally_print(&off);
    return tally_rms(&off);
}

static const bodies *with(int env, int lobe)
{
    for (int i = 0; i < ALL; i++)
        if (all[i].env == env && all[i].lobe == lobe)
            return &all[i];
    fail();
    return NULL;
}

static void matt_water_and_a_gradient_keep_their_colours(void **state)
{
    (void)state;
    const bodies *b = with(TP_ENV_GRADIENT, TP_LOBE_NONE);
    assert_true(compare(b, "slopes of 0.1", 410, false) < 1.5);
    assert_true(compare(b, "slopes of 0.3", 1229, false) < 4);
    assert_true(compare(b, "slopes of 0.6", 2458, false) < 9);
}

static void domes_and_cubes_keep_their_colours(void **state)
{
    (void)state;
    const bodies *dome = with(TP_ENV_DOME, TP_LOBE_PHONG);
    const bodies *cube = with(TP_ENV_CUBE, TP_LOBE_NONE);
    assert_true(compare(dome, "dome, 0.1", 410, false) < 2);
    assert_true(compare(dome, "dome, 0.3", 1229, false) < 4.5);
    assert_true(compare(cube, "cube, 0.1", 410, false) < 1.5);
    assert_true(compare(cube, "cube, 0.3", 1229, false) < 4);
}

static void glints_lie_where_they_lay(void **state)
{
    (void)state;
    const bodies *phong = with(TP_ENV_GRADIENT, TP_LOBE_PHONG);
    const bodies *blinn = with(TP_ENV_GRADIENT, TP_LOBE_BLINN);
    assert_true(compare(phong, "Phong, 0.1", 410, true) < 3);
    assert_true(compare(phong, "Phong, 0.3", 1229, true) < 5);
    assert_true(compare(blinn, "Blinn, 0.1", 410, true) < 4);
    assert_true(compare(blinn, "Blinn, 0.3", 1229, true) < 12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_bodies_have_the_same_bits),
        cmocka_unit_test(where_a_run_is_cut_does_not_show),
        cmocka_unit_test(matt_water_and_a_gradient_keep_their_colours),
        cmocka_unit_test(domes_and_cubes_keep_their_colours),
        cmocka_unit_test(glints_lie_where_they_lay),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("shade_quick_light", tests, NULL, NULL);
}
