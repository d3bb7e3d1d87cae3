/* SPDX-License-Identifier: MIT */
/* Models of deep water, rings, slopes from neighbours, light, and coastal water; see
 * models.c. */
#include "features/exposure/exposure.h"
#include "shade/optics.h"
#include "tests/budgets/models.h"

#define TICK 1234

enum { CHEAP, EXACT, SHARP };

/* Waves of three-swells, with a third of the steepness each. */
const tp_wave model_waves[3] = {
    { TP_FX(0.45), TP_FX(22), 0, TP_FX(70), 0, TP_FX_ONE, 1 },
    { TP_FX(0.30), TP_FX(13), 0, TP_FX(115), TP_FX(140), TP_FX_ONE, 1 },
    { TP_FX(0.15), TP_FX(7), 0, TP_FX(20), TP_FX(250), TP_FX_ONE, 1 },
};

void model_sea(tp_fx steepness, int32_t power)
{
    tp_wave wave[3];

    for (int i = 0; i < 3; i++) {
        wave[i] = model_waves[i];
        wave[i].steepness = steepness / 3;
        wave[i].exponent = power > 1 ? power + i : 1;
    }
    tp_deep_water_init(&model.deep, wave, 3, TP_FX(9.81));
    tp_deep_water_phases(&model.deep, TICK, 0, model.phases);
}

/* -- deep water ---------------------------------------------------------------------- */

static void prepare_sea(int kind)
{
    model_sea(kind == CHEAP ? TP_FX(0.05) : TP_FX(0.7), kind == SHARP ? 2 : 1);
    model.bytes = sizeof(tp_swell);
    model_expect(model.deep.crossed == (kind != CHEAP), "normals are of the other form");
    model_expect(model.deep.sharpened == (kind == SHARP), "sharpened, or not");
}

COUNTED(deep)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_surface_point at = tp_deep_water_displace_point(&model.deep, model.phases,
                                               PLACE_X(i, TP_FX(200)),
                                               PLACE_Z(i, TP_FX(200)));
        KEEP(at);
    }
}

COUNTED(above)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_surface_point at = tp_deep_water_sample(&model.deep, model.phases,
                                             PLACE_X(i, TP_FX(200)),
                                             PLACE_Z(i, TP_FX(200)), NULL);
        KEEP(at);
    }
}

/* Four fixed places, like the points of a hull: the rest point of the last tick is the
 * start of the next tick's search. */
static tp_fx last_rest[4][2];

static void prepare_again(int kind)
{
    prepare_sea(kind);
    tp_deep_water_phases(&model.deep, TICK - 1, 0, model.phases);
    for (int i = 0; i < 4; i++) {
        last_rest[i][0] = 7 * i * TP_FX_ONE;
        last_rest[i][1] = 0;
        tp_deep_water_sample(&model.deep, model.phases, 7 * i * TP_FX_ONE, 0, last_rest[i]);
    }
}

COUNTED(again)
{
    for (uint32_t i = 0; i < model.count; i++) {
        for (uint32_t k = 0; i % 4 == 0 && k < model.deep.count; k++)
            model.phases[k] -= (tp_turn)(model.deep.swell[k].turns_tick >> 32);
        const tp_surface_point at = tp_deep_water_sample(&model.deep, model.phases,
                                             (tp_fx)(7 * (i % 4)) * TP_FX_ONE, 0,
                                             last_rest[i % 4]);
        KEEP(at);
    }
}

static void prepare_nothing(int kind)
{
    (void)kind;
}

COUNTED(five)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_fx neighbours[4] = { PLACE_X(i, TP_FX_ONE), PLACE_Z(i, TP_FX_ONE),
                                  PLACE_X(i + 1, TP_FX_ONE), PLACE_Z(i + 1, TP_FX_ONE) };
        const tp_height_slope at = tp_neighbour_height_slope(0, neighbours, TP_FX(0.5));
        KEEP(at);
    }
}

/* -- rings --------------------------------------------------------------------------- */

enum { NEAR, FAR, BEGUN };

static const tp_ring ring = {
    0, 0, 0, TP_FX(0.05), TP_FX(0.8), TP_FX(1.2), TP_FX(2), TP_FX(0.5), TP_FX(0.1),
};
static tp_ring_now ring_now;
static tp_fx beside[64][2];

/* A ring two seconds old: the band from 2.4 m to 3.2 m, and places on the band all
 * around. */
static void prepare_ring(int kind)
{
    (void)kind;
    model.bytes = sizeof(tp_ring) + sizeof(tp_ring_now);
    model_expect(tp_ring_evaluate(&ring, 120 * TP_FX_ONE, &ring_now), "no ring");
    for (uint32_t i = 0; i < 64; i++) {
        const tp_fx far = TP_FX(2.8) + PLACE_X(i, TP_FX(0.35));
        beside[i][0] = tp_q30_mul(far, tp_sin(i << 26));
        beside[i][1] = tp_q30_mul(far, tp_cos(i << 26));
    }
}

COUNTED(ring_near)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_height_slope at = tp_ring_height_slope(&ring_now, 1, beside[i % 64][0],
                                            beside[i % 64][1]);
        KEEP(at);
        model_expect(at.height != 0, "a place beside the ring");
    }
}

COUNTED(ring_far)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_height_slope at = tp_ring_height_slope(&ring_now, 1,
                                            TP_FX(30) + PLACE_X(i, TP_FX(20)),
                                            PLACE_Z(i, TP_FX(20)));
        KEEP(at);
        model_expect(at.height == 0, "a place on the ring");
    }
}

COUNTED(ring_begin)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const bool there = tp_ring_evaluate(&ring, (int64_t)(i + 1) * TP_FX_ONE, &ring_now);
        KEEP(there);
    }
}

/* -- light --------------------------------------------------------------------------- */

static tp_dir3 ways[64];

static void prepare_light(int kind)
{
    (void)kind;
    for (uint32_t i = 0; i < 64; i++)
        ways[i] = tp_normalise(PLACE_X(i, TP_FX_ONE), -TP_FX_ONE / 2,
                               PLACE_Z(i, TP_FX_ONE));
}

static const tp_dir3 light_up = { 0, TP_Q30_ONE, 0 };

COUNTED(fresnel)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_q30 share = tp_fresnel(-ways[i % 64].y);
        KEEP(share);
    }
}

COUNTED(reflect)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_dir3 way = tp_reflect(ways[i % 64], light_up);
        KEEP(way);
    }
}

COUNTED(refract)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const tp_dir3 way = tp_refract(ways[i % 64], light_up);
        const tp_floor_offset on = tp_refract_offset(way, TP_FX(2));
        KEEP(on);
    }
}

COUNTED(exposure)
{
    tp_fx now = TP_FX_ONE;

    for (uint32_t i = 0; i < model.count; i++) {
        now = tp_exposure_step(now, TP_FX(0.3) + PLACE_X(i, TP_FX(0.2)), TP_FX(0.05));
        KEEP(now);
    }
}

const model_row model_seas[] = {
    { "sea-cheap", "point", "a wave", prepare_sea, counted_deep, CHEAP, 512 },
    { "sea-exact", "point", "a wave", prepare_sea, counted_deep, EXACT, 512 },
    { "sea-sharp", "point", "a wave", prepare_sea, counted_deep, SHARP, 512 },
    { "sea-above", "point", "a wave", prepare_sea, counted_above, EXACT, 256 },
    { "sea-above-again", "point", "a wave", prepare_again, counted_again, EXACT, 256 },
    { "five-heights", "point", "", prepare_nothing, counted_five, 0, 256 },
    { "ring-near", "point", "a ring", prepare_ring, counted_ring_near, NEAR, 256 },
    { "ring-far", "point", "a ring", prepare_ring, counted_ring_far, FAR, 256 },
    { "ring-picture", "ring", "a ring", prepare_ring, counted_ring_begin, BEGUN, 256 },
    { "fresnel", "ray", "", prepare_light, counted_fresnel, 0, 256 },
    { "reflect", "ray", "", prepare_light, counted_reflect, 0, 256 },
    { "refract", "ray", "", prepare_light, counted_refract, 0, 256 },
    { "exposure", "tick", "", prepare_nothing, counted_exposure, 0, 256 },
    { 0 },
};
