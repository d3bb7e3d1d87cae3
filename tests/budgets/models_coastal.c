/* SPDX-License-Identifier: MIT */
/* Models of coastal water: waves over a floor and in wind, and one wave at a depth; see
 * models.c. */
#include "tests/budgets/models.h"
#include "waves/coastal_water.h"

enum { SWELL, WIND, SLOPE, MAP, BREAKING, MAP_SIDE = 64 };

static uint16_t heights[MAP_SIDE * MAP_SIDE];
static const tp_grey map = { MAP_SIDE, MAP_SIDE, heights };

/* Slope with a shoal in the middle. */
static void draw_map(void)
{
    for (int z = 0; z < MAP_SIDE; z++)
        for (int x = 0; x < MAP_SIDE; x++) {
            const int dx = x - MAP_SIDE / 2, dz = z - MAP_SIDE / 2;
            const int shoal = 400 - dx * dx - dz * dz;
            const int lift = 32 * (shoal > 0 ? shoal : 0);
            heights[z * MAP_SIDE + x] = (uint16_t)(256 * x + lift);
        }
}

static tp_coastal_config config_of(int kind)
{
    tp_coastal_config c = {
        .wind = kind == WIND ? TP_FX(0.1) : 0, .wind_heading = TP_FX(80),
        .k0 = TP_FX(0.1), .kx = TP_FX(0.11), .ky = TP_FX(0.09), .stretch = TP_FX_ONE,
    };

    if (kind == SLOPE || kind == BREAKING)
        c.floor = (tp_floor){ .depth = kind == SLOPE ? TP_FX(8) : TP_FX(1.1),
                              .slope = TP_FX(0.03), .heading = TP_FX(80) };
    if (kind == MAP)
        c.floor = (tp_floor){ .map = &map, .map_size = TP_FX(400),
                              .map_low = TP_FX(-16), .map_high = TP_FX(-3) };
    return c;
}

static tp_coastal_water *const coastal = (tp_coastal_water *)(void *)&model.block;
static tp_fx half;                  /* half width of the places, m */

static void prepare_coastal(int kind)
{
    const tp_coastal_config config = config_of(kind);
    tp_wave wave[3];

    for (int i = 0; i < 3; i++) {
        wave[i] = model_waves[i];
        wave[i].steepness = TP_FX(0.2);
        wave[i].heading = TP_FX(60) + 20 * i * TP_FX_ONE;
    }
    draw_map();
    tp_deep_water_init(&model.deep, wave, 3, TP_FX(9.81));
    tp_deep_water_phases(&model.deep, 1234, 0, model.phases);
    model.bytes = (uint32_t)tp_coastal_bytes(&config, &model.deep);
    model_expect(model.bytes <= sizeof model.block, "coastal water is too large");
    model_expect(!tp_coastal_init(coastal, &config, &model.deep, wave, 3, NULL),
                 "no coastal water");
    half = kind == BREAKING ? TP_FX(15) : TP_FX(150);
}

/* Points of coastal water. Breaking: at least one wave of a place is above the breaking
 * gate, whether or not its crest is there. */
COUNTED(coastal)
{
    uint32_t breaking = 0;

    for (uint32_t i = 0; i < model.count; i++) {
        const tp_coastal_point at = tp_coastal_displace_point(
            coastal, model.phases, PLACE_X(i, half), PLACE_Z(i, half));
        KEEP(at);
        model_expect(at.depth > 0, "a place on land");
        breaking += at.breaking > 0;
    }
    if (half == TP_FX(15))
        model_expect(3 * breaking > model.count, "too little breaks");
    else
        model_expect(breaking == 0, "something breaks");
}

/* -- one wave at a depth ------------------------------------------------------------- */

enum { ECKART, FENTON, NEWTON, THREE };
static int64_t (*number)(int64_t k_inf_q32, tp_fx depth);
static int64_t deep[64];

static void prepare_number(int kind)
{
    static int64_t (*const method[])(int64_t, tp_fx) = {
        tp_depth_wave_number_eckart, tp_depth_wave_number_fenton, tp_depth_wave_number,
        tp_depth_wave_number_exact,
    };

    number = method[kind];
    for (int i = 0; i < 64; i++)
        deep[i] = tp_depth_wave_number_deep((4 + 3 * i) * TP_FX_ONE);
}

COUNTED(number)
{
    for (uint32_t i = 0; i < model.count; i++) {
        const int64_t k = number(deep[i % 64], TP_FX(10) + PLACE_X(i, TP_FX(9.5)));
        KEEP(k);
    }
}

const model_row model_oceans[] = {
    { "coastal-wind", "point", "3 waves", prepare_coastal, counted_coastal, WIND, 256 },
    { "coastal-slope", "point", "3 waves", prepare_coastal, counted_coastal, SLOPE, 256 },
    { "coastal-map", "point", "3 waves", prepare_coastal, counted_coastal, MAP, 256 },
    { "coastal-breaking", "point", "3 waves", prepare_coastal, counted_coastal, BREAKING,
      256 },
    { "depth-eckart", "depth", "", prepare_number, counted_number, ECKART, 256 },
    { "depth-fenton", "depth", "", prepare_number, counted_number, FENTON, 256 },
    { "depth-newton", "depth", "", prepare_number, counted_number, NEWTON, 256 },
    { "depth-exact", "depth", "", prepare_number, counted_number, THREE, 256 },
    { 0 },
};
