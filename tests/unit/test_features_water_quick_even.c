/* SPDX-License-Identifier: MIT */
/* Fast light at half rate: the plain and the packed bodies give the same bits for any cuts
 * of spans at 16 columns, and even columns equal those of the full rate. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/water/fast_glints_m4.h"
#include "features/water/fast_light_plain.h"
#include "tests/lib/shading.h"

static uint64_t chance;
static quick_lights lights;

typedef struct {
    stage *plain, *packed, *whole, *half;
    int    env, lobe;
} even_bodies;

/* All stages after the layers. */
#define X(name, env, lobe) \
    static void plain_##name(const tp_shade *shade, tp_run *run) \
    { \
        plain_light_even_columns(shade, run, env); \
        if (lobe == TP_LOBE_NONE) \
            tp_quick_odd_fill(run); \
        else \
            plain_glint(shade, run, lobe); \
    } \
    static void packed_##name(const tp_shade *shade, tp_run *run) \
    { \
        packed_light_even_columns(shade, run, env); \
        if (lobe == TP_LOBE_NONE) \
            tp_quick_odd_fill(run); \
        else \
            packed_glint(shade, run, lobe); \
    }
TP_QUICK_LIGHT_STAGES(X)
#undef X

static const even_bodies all[] = {
#define X(name, env, lobe) \
    { plain_##name, packed_##name, tp_stage_quick_##name, tp_stage_quick_##name##_half, \
      env, lobe },
    TP_QUICK_LIGHT_STAGES(X)
#undef X
};
enum { ALL = sizeof all / sizeof *all };

/* A span for the n-th body, before the light. */
typedef struct {
    const even_bodies *by;
    tp_shade shade;
    uint32_t slope[TP_RUN];
    test_run r;
} unlit;

static void unlit_make(unlit *u, int n, int32_t steep)
{
    u->by = &all[n % ALL];
    lights.beyond = n / ALL / 2 % 2 ? 0 : 1024;
    u->shade = quick_rough_shade(&lights, u->by->env, u->by->lobe,
                                 chance_int(&chance, 0, 1) ? TP_QUICK_LEVELS : 1, &chance);
    quick_run(&u->r, u->slope, steep, &chance);
}

/* Columns [from, end) with slopes, and the layers' colours of every second column. */
static tp_run part_of(const unlit *u, int32_t from, int32_t end)
{
    const uint32_t *colour = u->r.run.colour;
    tp_run part = run_part(&u->r.run, from, end);
    const int32_t odd = part.x & 1;

    memcpy(part.slope, u->slope + from, (size_t)part.count * 4);
    part.even[0] = colour[from];
    for (int32_t k = 1; 2 * k - odd < part.count; k++)
        part.even[k] = colour[from + 2 * k - odd];
    return part;
}

static void both_bodies_have_the_same_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 4000; n++) {
        unlit u;
        unlit_make(&u, n, n / ALL % 2 ? 32000 : 3000);
        const int32_t from = n % 3 ? chance_int(&chance, 0, TP_RUN - 1) : 0;
        const int32_t end = n % 3 == 1 ? TP_RUN : chance_int(&chance, from + 1, TP_RUN);
        const tp_run run = part_of(&u, from, end);
        quick_assert_same(u.by->plain, u.by->packed, &u.shade, &run);
    }
}

/* Tiles begin and end at multiples of 16. */
static void where_tiles_begin_does_not_show(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        unlit u;
        unlit_make(&u, n, 4000);
        const int32_t from = chance_int(&chance, 0, 15),
                      cut = 16 * chance_int(&chance, 1, 3);
        quick_assert_cut(u.by->packed, &u.shade, part_of(&u, from, TP_RUN),
                         part_of(&u, from, cut), part_of(&u, cut, TP_RUN));
    }
}

/* Bodies with Blinn's lobe or without lobe, whose view has the same steps. */
static void even_columns_are_those_of_the_whole_rate(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        unlit u;
        unlit_make(&u, n, 4000);
        tp_run half = part_of(&u, 0, TP_RUN), whole = half;
        if (u.by->lobe == TP_LOBE_PHONG)
            continue;
        u.by->plain(&u.shade, &half);
        u.by->whole(&u.shade, &whole);
        for (int i = 0; i < TP_RUN; i += 2)
            assert_int_equal(half.colour[i], whole.colour[i]);
    }
}

/* quality.light=fast: glints too are those of the whole rate, and tiles do not show. */
static void half_light_is_the_whole_light_of_even_columns(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        unlit u;
        unlit_make(&u, n, n / ALL % 2 ? 32000 : 4000);
        const int32_t from = chance_int(&chance, 0, 15),
                      cut = 16 * chance_int(&chance, 1, 3);
        tp_run half = part_of(&u, from, TP_RUN), whole = half;
        quick_assert_cut(u.by->half, &u.shade, half, part_of(&u, from, cut),
                         part_of(&u, cut, TP_RUN));
        u.by->half(&u.shade, &half);
        u.by->whole(&u.shade, &whole);
        for (int i = half.x & 1; i < half.count; i += 2)
            assert_int_equal(half.colour[i], whole.colour[i]);
    }
}

/* A channel with diffuse light: of 0..256, with 255/256 added before the cut. */
static uint32_t diffuse_channel(uint32_t colour, int shift, uint32_t lit)
{
    return ((colour >> shift & 0xff) * lit + 255) >> 8 << shift;
}

static void diffuse_light_is_that_of_each_column(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        unlit u;
        unlit_make(&u, n, n % 2 ? 32000 : 4000);
        const int32_t from = chance_int(&chance, 0, 15),
                      cut = 16 * chance_int(&chance, 1, 3);
        const tp_quick_sun sun = tp_quick_sun_make(&u.shade);
        tp_run half = part_of(&u, from, TP_RUN), whole = half;
        quick_assert_cut(tp_stage_quick_diffuse_half, &u.shade, half,
                         part_of(&u, from, cut), part_of(&u, cut, TP_RUN));
        tp_stage_quick_diffuse_half(&u.shade, &half);
        tp_stage_quick_diffuse(&u.shade, &whole);
        for (int i = 0; i < half.count; i++) {
            const uint32_t c = u.r.run.colour[from + i];
            const int32_t l = tp_smlad(u.slope[from + i], sun.back, sun.y);
            const uint32_t lit =
                (uint32_t)(sun.ambient + sun.direct * tp_usat(l, 18, 8)) >> 8;
            assert_int_equal(whole.colour[i], diffuse_channel(c, 16, lit)
                                                  | diffuse_channel(c, 8, lit)
                                                  | diffuse_channel(c, 0, lit));
            if ((half.x + i) % 2 == 0)
                assert_int_equal(half.colour[i], whole.colour[i]);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_bodies_have_the_same_bits),
        cmocka_unit_test(where_tiles_begin_does_not_show),
        cmocka_unit_test(even_columns_are_those_of_the_whole_rate),
        cmocka_unit_test(half_light_is_the_whole_light_of_even_columns),
        cmocka_unit_test(diffuse_light_is_that_of_each_column),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("features/water quick even", tests, NULL, NULL);
}
