/* SPDX-License-Identifier: MIT */
/* Shades and checks for tests of fast shading, with any sky and any lobe. */
#ifndef TP_TESTS_QUICK_LIGHTS_H
#define TP_TESTS_QUICK_LIGHTS_H
#include "features/water/quick_light.h"
#include "skies.h"

typedef struct {
    test_sky sky;
    struct tp_quick_light quick;
} quick_lights;

/* A sky colour that varies slowly with the direction. */
static inline uint32_t quick_smooth(ref_dir d, void *with)
{
    (void)with;
    return (uint32_t)(128 + 100 * d.x) << 16 | (uint32_t)(128 + 100 * d.y) << 8
         | (uint32_t)(128 + 100 * d.z);
}

/* A random shade for the sky and the lobe; valid as long as `kept` is. */
static inline tp_shade quick_shade(quick_lights *kept, int env, int lobe, uint64_t *state)
{
    tp_shade s = shade_any(state);

    if (env == TP_ENV_DOME)
        sky_dome(&kept->sky, &s, state);
    if (env == TP_ENV_CUBE)
        sky_cube(&kept->sky, &s, quick_smooth, NULL);
    s.env.beyond = 0;
    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    s.env.least = lobe == TP_LOBE_NONE ? 0 : TP_DISC_END;
    const tp_fx shininess = chance_int(state, 10, 200) * TP_FX_ONE;
    if (lobe == TP_LOBE_BLINN)
        tp_shade_shine_blinn(shade_shine, shininess, TP_FX_ONE);
    else
        tp_shade_shine(shade_shine, shininess, TP_FX_ONE);
    s.quick = &kept->quick;
    tp_quick_light_init(&kept->quick, &s, (tp_lobe)lobe, lobe != TP_LOBE_NONE, true);
    return s;
}

/* Slopes as sampled.  If `steep` is large, every eighth slope has the steepest 16-bit
 * value. */
static inline void quick_run(test_run *r, uint32_t *slope, int32_t steep, uint64_t *state)
{
    run_any(r, steep, state);
    for (int i = 0; i < TP_RUN; i++)
        slope[i] = steep > 30000 && i % 8 == 0
                       ? 0x80008000u ^ (uint32_t)chance_int(state, 0, 3) * 0xffff
                       : r->n[i];
}

/* Asserts that both bodies of a stage compute the same colours for a span, with alpha 0. */
static inline void quick_assert_same(stage *plain, stage *packed, const tp_shade *shade,
                                     const tp_run *run)
{
    tp_run one = *run, other = *run;

    plain(shade, &one);
    packed(shade, &other);
    assert_memory_equal(one.colour, other.colour, (size_t)run->count * 4);
    for (int i = 0; i < run->count; i++)
        assert_int_equal(one.colour[i] >> 24, 0);
}

/* Asserts that a span has the same colours whole and in two parts. */
static inline void quick_assert_cut(stage *body, const tp_shade *shade, tp_run whole,
                                    tp_run left, tp_run right)
{
    body(shade, &whole);
    body(shade, &left);
    body(shade, &right);
    assert_memory_equal(whole.colour, left.colour, (size_t)left.count * 4);
    assert_memory_equal(whole.colour + left.count, right.colour, (size_t)right.count * 4);
}
#endif
