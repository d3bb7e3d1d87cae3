/* SPDX-License-Identifier: MIT */
/* The table of parameters.  Every number open to the user has exactly one row here.
 *
 * A row stores the offset of its value in tp_scene; two functions in world/value.c read
 * and write all values.  Rows stand in reading order.  Each feature keeps its rows in its
 * own folder; this file includes the folders' headers and adds the rows of camera, light,
 * grid, floor, wind, surf, clock and quality.  The macro WAVE is expanded once for each
 * of the sixteen waves. */
#include "features/boat/boat.h"
#include "features/drops/drops.h"
#include "features/exposure/exposure.h"
#include "features/foam/foam.h"
#include "features/land/land.h"
#include "features/pool/pool_module.h"
#include "features/reflection/reflection.h"
#include "features/sky/sky.h"
#include "features/spray/spray.h"
#include "features/tank/tank.h"
#include "features/underwater/underwater.h"
#include "features/water/water.h"
#include "world/text.h"
#ifndef TP_MORE_ROWS            /* rows of a program's own modules */
#define TP_MORE_ROWS
#endif

#define WAVE(n) \
    TP_ROW_NUMBER("wave" #n ".amplitude", wave[n].amplitude, "m", 0, 16, 0, \
        "half the height from trough to crest; 0: no wave"), \
    TP_ROW_NUMBER("wave" #n ".length", wave[n].length, "m", 0.25, 2000, 10, \
        "wavelength, from crest to crest"), \
    TP_ROW_NUMBER("wave" #n ".steepness", wave[n].steepness, "", 0, 1, 0.25, \
        "sharpness of crests; 0: a sine; the sum is clamped to 0.95"), \
    TP_ROW_HEADING("wave" #n ".heading", wave[n].heading, 0, \
        "direction of travel, clockwise from -z"), \
    TP_ROW_HEADING("wave" #n ".phase", wave[n].phase, 0, \
        "phase at the origin at tick 0"), \
    TP_ROW_NUMBER("wave" #n ".speed", wave[n].speed, "", 0, 8, 1, \
        "factor of the wave's natural speed; 0: the wave stands still"), \
    TP_ROW_COUNT("wave" #n ".exponent", wave[n].exponent, "", 1, 8, 1, \
        "exponent of the sine; above 1: sharper crests, flatter troughs")

static const tp_param rows[] = {
    TP_ROW_NAME("scene.title", title, TEXT, "title of the preview's window"),
    TP_ROW_NAME("scene.description", description, TEXT,
        "description of the scene for `tidepool scenes`, one line"),

    TP_ROW_NUMBER("camera.x", camera.x, "m", -8000, 8000, 0,
        "position, to the right of the origin"),
    TP_ROW_NUMBER("camera.y", camera.y, "m", -100, 2000, 4,
        "height above the level of still water"),
    TP_ROW_NUMBER("camera.z", camera.z, "m", -8000, 8000, 0,
        "position, from the origin towards the viewer"),
    TP_ROW_HEADING("camera.heading", camera.heading, 0,
        "direction of view, clockwise from -z"),
    TP_ROW_NUMBER("camera.pitch", camera.pitch, "degrees", -89, 89, -6,
        "direction of view, above the horizon"),
    TP_ROW_NUMBER("camera.fov", camera.fov, "degrees", 20, 100, 60,
        "angle of view from the bottom to the top of the picture"),
    TP_ROW_NUMBER("camera.near", camera.near, "m", 0.05, 10, 0.25,
        "nearer objects are clipped"),
    TP_ROW_CHOICE("camera.follow", camera.follow, "none|boat", TP_FOLLOW_BOAT,
        TP_FOLLOW_NONE,
        "position and angles are relative to the world or to the boat's deck"),

    TP_ROW_HEADING("light.heading", light.heading, 45,
        "direction of the sun, clockwise from -z"),
    TP_ROW_NUMBER("light.elevation", light.elevation, "degrees", 1, 90, 35,
        "elevation of the sun above the horizon"),
    TP_ROW_COLOUR("light.colour", light.colour, 0xfff4e0,
        "colour of the sun and of the light on solids"),
    TP_ROW_NUMBER("light.ambient", light.ambient, "", 0, 1, 0.35,
        "share of ambient light, from all sides"),
    TP_ROW_CHOICE("light.model", light.model, "phong|blinn", TP_LIGHT_BLINN,
        TP_LIGHT_PHONG, "reflection model of the glitter"),
    TP_ROW_NUMBER("light.turn", light.turn, "degrees/s", -90, 90, 0,
        "angular speed of the sun's heading"),

    TP_SKY_COLOUR_ROWS,
    TP_HAZE_ROWS,
    TP_SKY_LIGHT_ROWS,
    TP_EXPOSURE_ROWS,
    TP_WATER_ROWS,

    TP_ROW_NUMBER("water.gravity", water.gravity, "m/s^2", 0.1, 100, 9.81,
        "sets the natural speed of waves"),

    TP_BUMPS_ROWS,
    TP_UNDERWATER_ROWS,
    TP_CAUSTICS_ROWS,
    TP_LAYERS_ROWS,
    TP_RIPPLE_ROWS,
    TP_REFLECTION_ROWS,

    TP_ROW_COUNT("grid.vertices", grid.vertices, "points", 0, 65536, 0,
        "vertices of the water's grid; 0: 1400, with a pool 6000, a tank 10000"),

    WAVE(0),  WAVE(1),  WAVE(2),  WAVE(3),  WAVE(4),  WAVE(5),  WAVE(6),  WAVE(7),
    WAVE(8),  WAVE(9),  WAVE(10), WAVE(11), WAVE(12), WAVE(13), WAVE(14), WAVE(15),

    TP_ROW_NUMBER("floor.depth", floor.depth, "m", 0, 8000, 0,
        "depth of still water at the origin; 0 without a map: no floor"),
    TP_ROW_NUMBER("floor.slope", floor.slope, "", 0, 1, 0,
        "rise of the floor per metre"),
    TP_ROW_HEADING("floor.heading", floor.heading, 0,
        "direction in which the floor rises, clockwise from -z"),
    TP_ROW_NAME("floor.map", floor.map, GREY,
        "PNG of the floor's heights; empty: a plane slope"),
    TP_ROW_NUMBER("floor.map_x", floor.map_x, "m", -8000, 8000, 0,
        "centre of the map, to the right of the origin"),
    TP_ROW_NUMBER("floor.map_z", floor.map_z, "m", -8000, 8000, 0,
        "centre of the map, from the origin towards the viewer"),
    TP_ROW_NUMBER("floor.map_size", floor.map_size, "m", 1, 8000, 200,
        "width of the map"),
    TP_ROW_NUMBER("floor.map_low", floor.map_low, "m", -8000, 100, -10,
        "height of black in the map"),
    TP_ROW_NUMBER("floor.map_high", floor.map_high, "m", -8000, 100, 2,
        "height of white in the map"),

    TP_LAND_ROWS,

    TP_ROW_NUMBER("wind.strength", wind.strength, "rad/m", 0, 1, 0,
        "lean of crests in the wind's direction, per metre of height"),
    TP_ROW_HEADING("wind.heading", wind.heading, 0,
        "direction in which the wind blows, clockwise from -z"),

    TP_ROW_NUMBER("surf.tilt_decay", surf.tilt_decay, "1/m", 0, 4, 0.1,
        "decay with depth of the tilt of orbits towards the floor"),
    TP_ROW_NUMBER("surf.widening_decay", surf.widening_decay, "1/m", 0.001, 4, 0.11,
        "decay with depth of the widening of orbits"),
    TP_ROW_NUMBER("surf.flattening_decay", surf.flattening_decay, "1/m", 0.001, 4, 0.09,
        "decay with depth of the flattening of orbits"),
    TP_ROW_NUMBER("surf.stretch", surf.stretch, "", 0, 2, 1,
        "stretch of breaking crests; 1: as their breaker type demands"),
    TP_ROW_NUMBER("surf.irregular", surf.irregular, "", 0, 1, 0.3,
        "irregularity of breaking crests, by noise"),

    TP_POOL_ROWS,
    TP_TANK_ROWS,
    TP_FOAM_ROWS,
    TP_SPRAY_ROWS,
    TP_DROPS_ROWS,
    TP_BOAT_ROWS,

    TP_ROW_NUMBER("clock.scale", clock.scale, "", 0.125, 4, 1,
        "speed of time; below 1: slow motion"),

    TP_ROW_NUMBER("quality.error_px", quality.error_px, "px", 0, 64, 0.5,
        "largest error of outlines by omitted waves"),
    TP_ROW_NUMBER("quality.error_colour", quality.error_colour, "levels", 0, 255, 2,
        "largest error that planned rungs may add, rms of 255"),
    TP_ROW_CHOICE("quality.visibility", quality.visibility,
        "auto|triangles|rows|projected|flat|walk", TP_VISIBILITY_WALK, TP_VISIBILITY_AUTO,
        "method that finds the water's surface in each pixel"),
    TP_ROW_CHOICE("quality.shading", quality.shading, "auto|exact|quick",
        TP_SHADING_QUICK, TP_SHADING_AUTO,
        "shading of water: exact, or fast with slopes and nearest texels"),
    TP_ROW_CHOICE("quality.rate", quality.rate, "auto|full|layers|colour",
        TP_RATE_COLOUR, TP_RATE_AUTO,
        "computed for every second pixel only: nothing, the layers, the colour"),
#define X(name, words, last, help) \
    TP_ROW_CHOICE("quality." #name, quality.name, words, last, \
                  TP_RUNG_AUTO, help),
    TP_EFFECT_LIST(X)
#undef X
#define X(name) "|" #name
    TP_ROW_CHOICE("quality.board", quality.board, "none" TP_BOARD_LIST(X), TP_BOARDS - 1,
        TP_BOARD_none, "board for which rungs are chosen, with quality.frame_ms"),
#undef X
    TP_ROW_NUMBER("quality.frame_ms", quality.frame_ms, "ms", 0, 10000, 0,
        "time of a frame: on the board (0: 100), or held here by steps (0: off)"),

    TP_MORE_ROWS
};

enum { ROWS = sizeof rows / sizeof rows[0] };

_Static_assert(TP_WAVES == 16, "a wave more or less is a row of WAVE more or less");

const tp_param *tp_params(uint32_t *count)
{
    *count = ROWS;
    return rows;
}

const tp_param *tp_param_find(const char *name, size_t bytes)
{
    for (uint32_t i = 0; i < ROWS; i++)
        if (tp_string_view_equals((tp_string_view){ name, bytes }, rows[i].name))
            return &rows[i];
    return NULL;
}
