/* SPDX-License-Identifier: MIT */
/* Coastal waters for tests, each in a block of exactly the required size so that a
 * sanitizer sees any access outside; and the phase of a wave, read from the surface. */
#ifndef TP_TESTS_LIB_COASTAL_WATER_H
#define TP_TESTS_LIB_COASTAL_WATER_H
#include "tests/lib/random.h"
#include "waves/coastal_water.h"

#define TURNS (1 / 4294967296.0)
#define LSB   (1 / 65536.0)

typedef struct {
    tp_wave wave[TP_WAVES];
    uint32_t count;
    tp_coastal_config config;
    tp_deep_water deep;
    tp_coastal_water *coastal;
} coastal_water;

static inline void coastal_build(coastal_water *o)
{
    tp_error err;
    tp_deep_water_init(&o->deep, o->wave, o->count, TP_FX(9.81));
    const size_t bytes = tp_coastal_bytes(&o->config, &o->deep);
    o->coastal = malloc(bytes);
    assert_non_null(o->coastal);
    memset(o->coastal, 0xa5, bytes);
    assert_int_equal(
        tp_coastal_init(o->coastal, &o->config, &o->deep, o->wave, o->count, &err), TP_OK);
}

static inline void coastal_end(coastal_water *o)
{
    free(o->coastal);
}

static inline tp_coastal_config coastal_usual(void)
{
    return (tp_coastal_config){
        .k0 = TP_FX(0.1), .kx = TP_FX(0.11), .ky = TP_FX(0.09), .stretch = TP_FX_ONE,
    };
}

static inline tp_wave coastal_wave(double amplitude, double length, double steepness,
                                   double heading)
{
    return (tp_wave){
        .amplitude = (tp_fx)lround(amplitude * 65536),
        .length = (tp_fx)lround(length * 65536),
        .steepness = (tp_fx)lround(steepness * 65536),
        .heading = (tp_fx)lround(heading * 65536), .speed = TP_FX_ONE,
    };
}

static inline void any_phases(uint64_t *chance, tp_turn phases[TP_WAVES])
{
    for (int i = 0; i < TP_WAVES; i++)
        phases[i] = (tp_turn)random_next(chance);
}

static inline tp_floor shore(double depth, double slope, double heading)
{
    return (tp_floor){ .depth = (tp_fx)lround(depth * 65536),
                       .slope = (tp_fx)lround(slope * 65536),
                       .heading = (tp_fx)lround(heading * 65536) };
}

/* Phase of coastal water with a single sine wave (steepness 0: particles move vertically
 * only), in turns of Phi in [A7]: y = -V cos Phi now and V sin Phi a quarter period
 * later. */
static inline double coastal_phase(const coastal_water *o, tp_fx x, tp_fx z)
{
    const tp_turn now[TP_WAVES] = { 0 }, later[TP_WAVES] = { 0x40000000u };
    const double c = -tp_coastal_displace_no_overhang(o->coastal, now, x, z).position.y;
    const double s = tp_coastal_displace_no_overhang(o->coastal, later, x, z).position.y;
    return atan2(s, c) / (2 * 3.14159265358979323846);
}

/* Returns b - a, reduced to the nearest turn. */
static inline double coastal_turns_from(double a, double b)
{
    return b - a - round(b - a);
}

/* Height map of a straight slope: `depth` at the middle, falling from white to black. */
typedef struct {
    uint16_t *sample;
    tp_grey   picture;
} coastal_picture;

static inline coastal_picture coastal_slope_picture(const tp_floor *slope, uint32_t side,
                                                    double size, tp_floor *map)
{
    coastal_picture p = { .sample = malloc(side * side * sizeof(uint16_t)) };
    const double a = slope->heading * LSB * 3.14159265358979323846 / 180;
    const double half = size * 0.75 * slope->slope * LSB;
    const double middle = -slope->depth * LSB;

    assert_non_null(p.sample);
    for (uint32_t r = 0; r < side; r++) {
        for (uint32_t c = 0; c < side; c++) {
            const double x = (c + 0.5 - side / 2.0) * size / side;
            const double z = (r + 0.5 - side / 2.0) * size / side;
            const double h = slope->slope * LSB * (sin(a) * x - cos(a) * z);
            p.sample[r * side + c] = (uint16_t)lround((h + half) / (2 * half) * 65535);
        }
    }
    p.picture = (tp_grey){ side, side, p.sample };
    *map = (tp_floor){
        .map_size = (tp_fx)lround(size * 65536),
        .map_low = (tp_fx)lround((middle - half) * 65536),
        .map_high = (tp_fx)lround((middle + half) * 65536),
    };
    return p;
}
#endif
