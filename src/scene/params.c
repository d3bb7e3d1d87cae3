/* SPDX-License-Identifier: MIT */
/* The table of parameters: every number that a person may change, once.
 *
 * A row knows where its value lies in tp_scene, so one function reads and one writes all
 * of them (value.c).  Rows stand in the order in which people should read them; the
 * sixteen waves are one macro, written out sixteen times, and so are both pools. */
#include "scene/piece.h"
#include "tidepool/plan.h"
#include "tidepool/scene.h"

#define AT(member) (uint32_t)offsetof(tp_scene, member)

#define NUMBER(name, member, unit, low, high, normal, help) \
    { name, unit, help, TP_PARAM_FX, TP_FX(low), TP_FX(high), TP_FX(normal), "", \
      AT(member) }
#define COUNT(name, member, unit, low, high, normal, help) \
    { name, unit, help, TP_PARAM_INT, low, high, normal, "", AT(member) }
#define SWITCH(name, member, normal, help) \
    { name, "", help, TP_PARAM_BOOL, 0, 1, normal, "", AT(member) }
#define COLOUR(name, member, normal, help) \
    { name, "", help, TP_PARAM_COLOUR, 0, 0xffffff, normal, "", AT(member) }
#define CHOICE(name, member, words, last, normal, help) \
    { name, words, help, TP_PARAM_CHOICE, 0, last, normal, "", AT(member) }
#define NAME(name, member, kind, help) \
    { name, "", help, TP_PARAM_##kind, 0, 0, 0, "", AT(member) }

/* 90 whole turns: 16.16 ends before 91.02. */
#define HEADING(name, member, normal, help) \
    NUMBER(name, member, "degrees", -32400, 32400, normal, help)

#define WAVE(n) \
    NUMBER("wave" #n ".amplitude", wave[n].amplitude, "m", 0, 16, 0, \
           "half the height from trough to crest; 0: no such wave"), \
    NUMBER("wave" #n ".length", wave[n].length, "m", 0.25, 2000, 10, \
           "from crest to crest"), \
    NUMBER("wave" #n ".steepness", wave[n].steepness, "", 0, 1, 0.25, \
           "sharpness of the crests; 0: a plain sine; their sum is held below 0.95"), \
    HEADING("wave" #n ".heading", wave[n].heading, 0, \
           "where the wave travels to, clockwise from -z"), \
    HEADING("wave" #n ".phase", wave[n].phase, 0, \
           "of the wave at the origin when the clock starts"), \
    NUMBER("wave" #n ".speed", wave[n].speed, "", 0, 8, 1, \
           "of its natural speed; 0: it stands still"), \
    COUNT("wave" #n ".power", wave[n].power, "", 1, 8, 1, \
          "1: a sine; more raise its crests and flatten its troughs")

#define POOL(name, part) \
    COUNT(name ".cols", part.cols, "cells", 0, 512, 0, \
          "along x, 16 or more; 0: no such pool"), \
    COUNT(name ".rows", part.rows, "cells", 16, 512, 64, "along z"), \
    CHOICE(name ".cells", part.cells, "8|16|32", TP_CELLS_32, TP_CELLS_16, \
           "bits of a cell: 8 save memory, 32 keep volume and detail"), \
    CHOICE(name ".edges", part.edges, "wall|sponge|tile", TP_EDGES_TILE, TP_EDGES_WALL, \
           "reflect waves, swallow them, or go on at the other side for ever"), \
    NUMBER(name ".courant", part.courant, "", 0.05, 0.8, 0.484, \
           "cells that a wave goes in a tick, 0.49 at the most"), \
    COUNT(name ".damping", part.damping, "", 4, 10, 6, \
          "m: a tick takes 2^-m of the motion; less comes to rest sooner"), \
    COUNT(name ".sponge", part.sponge, "cells", 4, 64, 16, "width of a sponge edge"), \
    NUMBER(name ".range", part.range, "m", 0.01, 64, 1, \
           "highest water of 8- and 16-bit cells"), \
    NUMBER(name ".cell", part.cell, "m", 0.01, 50, 0.25, "side of a cell"), \
    NUMBER(name ".x", part.x, "m", -8000, 8000, 0, "of its centre, to the right"), \
    NUMBER(name ".z", part.z, "m", -8000, 8000, 0, "of its centre, towards the viewer"), \
    NUMBER(name ".feed_low", part.feed_low, "m", 0, 16, 0, \
           "rms height under which it is fed with hats; 0: never"), \
    NUMBER(name ".feed_high", part.feed_high, "m", 0, 16, 0, \
           "rms height above which it is not"), \
    NUMBER(name ".feed", part.feed, "m", 0, 16, 0.1, "height of such a hat"), \
    NUMBER(name ".poke_every", part.poke_every, "s", 0, 600, 0, \
           "between hats at random places; 0: none"), \
    NUMBER(name ".poke", part.poke, "m", -16, 16, 0.2, "height of such a hat"), \
    NUMBER(name ".poke_size", part.poke_size, "m", 0.01, 50, 0.5, "its width, sigma"), \
    NUMBER(name ".paddle", part.paddle, "m", 0, 16, 0, \
           "height of waves that a paddle makes at its north edge; 0: none"), \
    NUMBER(name ".paddle_period", part.paddle_period, "s", 0.1, 60, 2, "of such waves"), \
    NAME(name ".mask", part.mask, GREY, "PNG laid over it, dark is wall; empty: none")

#define MAP(name, part, normal, help) \
    NAME(name ".texture", part.texture, TEXTURE, help), \
    NUMBER(name ".size", part.size, "m", 0.1, 1000, normal, \
           "side of the square that one repeat covers"), \
    NUMBER(name ".drift_x", part.drift_x, "m/s", -20, 20, 0, "along x"), \
    NUMBER(name ".drift_z", part.drift_z, "m/s", -20, 20, 0, "along z")

#define LAYER(n, help) \
    MAP("layer" #n, layer[n].map, 8, help), \
    NUMBER("layer" #n ".saturation", layer[n].saturation, "", 0, 4, 1, \
           "0: greys; 1: the PNG's own colours"), \
    NUMBER("layer" #n ".clamp", layer[n].clamp, "", 0, 0.95, 0, \
           "darker texels are black, brighter ones spread over the whole range"), \
    COLOUR("layer" #n ".colour", layer[n].colour, 0xffffff, "multiplies the layer")

#define FACE(name, part, help) NAME("sky." name, sky.part, TEXTURE, help)

static const tp_param rows[] = {
    NAME("scene.title", title, TEXT, "what the preview's window is called"),
    NAME("scene.shows", shows, TEXT, "one line for `tidepool scenes`"),

    NUMBER("camera.x", camera.x, "m", -8000, 8000, 0, "to the right of the origin"),
    NUMBER("camera.y", camera.y, "m", -100, 2000, 4, "above the level of still water"),
    NUMBER("camera.z", camera.z, "m", -8000, 8000, 0, "towards the viewer"),
    HEADING("camera.heading", camera.heading, 0, "clockwise from -z"),
    NUMBER("camera.pitch", camera.pitch, "degrees", -89, 89, -6, "above the horizon"),
    NUMBER("camera.fov", camera.fov, "degrees", 20, 100, 60,
           "angle of view from the bottom to the top of the picture"),
    NUMBER("camera.near", camera.near, "m", 0.05, 10, 0.25, "nearer things are cut away"),
    CHOICE("camera.follow", camera.follow, "none|boat", TP_FOLLOW_BOAT, TP_FOLLOW_NONE,
           "place and angles are of the world, or of the boat's deck"),

    HEADING("light.heading", light.heading, 45,
            "where the sun stands, clockwise from -z"),
    NUMBER("light.elevation", light.elevation, "degrees", 1, 90, 35,
           "of the sun above the horizon"),
    COLOUR("light.colour", light.colour, 0xfff4e0, "of the sun"),
    NUMBER("light.ambient", light.ambient, "", 0, 1, 0.35,
           "share of light from all sides"),
    CHOICE("light.model", light.model, "phong|blinn", TP_LIGHT_BLINN, TP_LIGHT_PHONG,
           "how the glitter is reckoned"),
    NUMBER("light.turn", light.turn, "degrees/s", -90, 90, 0, "that the sun goes round"),

    CHOICE("sky.kind", sky.kind, "gradient|day|dusk|night|cube", TP_SKY_CUBE,
           TP_SKY_GRADIENT, "two colours, a generated sky, or six pictures"),
    COLOUR("sky.horizon", sky.horizon, 0xc8d8e4,
           "of a gradient's or day's sky at the horizon"),
    COLOUR("sky.zenith", sky.zenith, 0x3a6ea5, "of a gradient's or day's sky overhead"),
    NUMBER("sky.haze", sky.haze, "m", 0, 32000, 2000,
           "distance at which half of a colour has gone into the horizon"),

    NUMBER("sky.sun", sky.sun, "", 0, 16, 1,
           "of a generated sky's disc; what is above 1 shows by hdr.share"),
    NUMBER("sky.stars", sky.stars, "", 0, 1, 0.5, "how many stars a night has"),
    FACE("east", east, "PNG of a cube's side towards +x; alpha is light beyond white"),
    FACE("west", west, "towards -x"),
    FACE("up", up, "overhead; its lower edge joins the south"),
    FACE("down", down, "underfoot; its upper edge joins the south"),
    FACE("south", south, "towards +z"),
    FACE("north", north, "towards -z"),

    NUMBER("hdr.share", hdr.share, "", 0, 1, 0,
           "of the light beyond white that suns and skies carry; 0: no HDR"),
    CHOICE("hdr.exposure", hdr.exposure, "fixed|auto", TP_EXPOSURE_AUTO,
           TP_EXPOSURE_FIXED, "of the camera"),
    NUMBER("hdr.value", hdr.value, "", 0.125, 8, 1, "exposure, or where it begins"),
    NUMBER("hdr.rate", hdr.rate, "", 0, 1, 0.03,
           "share of the way that automatic exposure goes in a tick"),

    COLOUR("water.colour", water.colour, 0x2a5a6e, "multiplies the first layer"),
    CHOICE("water.filter", water.filter, "nearest|linear", TP_FILTER_LINEAR,
           TP_FILTER_LINEAR, "of the layers"),
    NUMBER("water.specular", water.specular, "", 0, 4, 1,
           "brightness of the sun's glitter"),
    NUMBER("water.shininess", water.shininess, "", 1, 1000, 80,
           "exponent of the glitter: higher is smaller and sharper"),
    NUMBER("water.reflection", water.reflection, "", 0, 1, 0.6,
           "share of the sky in what a grazing look sees"),
    CHOICE("water.fresnel", water.fresnel, "table|schlick", TP_FRESNEL_SCHLICK,
           TP_FRESNEL_TABLE, "the exact law of reflection, or the usual shortcut"),
    NUMBER("water.gravity", water.gravity, "m/s^2", 0.1, 100, 9.81,
           "sets the natural speed of waves"),
    NUMBER("water.pool_bump", water.pool_bump, "", 0, 4, 0,
           "above 0 pools bend the light only, so much; the mesh stays as it is"),
    NUMBER("water.clear", water.clear, "m", 0, 200, 0,
           "of water that turn white into the tint; 0: it is not seen through"),
    COLOUR("water.tint", water.tint, 0x2f8f9f, "of white seen through so much water"),
    COLOUR("water.deep", water.deep, 0x0a3040, "of bottomless water"),
    NUMBER("water.dispersion", water.dispersion, "", 0, 1, 0,
           "spread of the refractive index, red to violet; 0.02 is nature's"),
    NUMBER("water.caustics", water.caustics, "", 0, 4, 0,
           "strength of the light that waves gather on the floor; 0: none"),
    COUNT("water.caustic_cells", water.caustic_cells, "cells", 16, 256, 64,
          "of the side of its map"),
    NUMBER("water.caustic_size", water.caustic_size, "m", 1, 1000, 20,
           "side of its map, where there is no pool"),

    LAYER(0, "PNG laid over the water; empty: none"),
    LAYER(1, "PNG added to the first; empty: none"),
    LAYER(2, "PNG added to the first; empty: none"),
    MAP("distortion", distortion.map, 8, "PNG whose red and green bend the layers"),
    NUMBER("distortion.strength", distortion.strength, "m", 0, 20, 0.5,
           "that it moves them at the most"),
    MAP("ripple", ripple.map, 4, "PNG of capillary waves, a normal map; empty: none"),
    NUMBER("ripple.bump", ripple.bump, "", 0, 4, 1, "1: as steep as the PNG says"),

    CHOICE("mirror.objects", mirror.objects, "none|stencil|cube", TP_MIRROR_CUBE,
           TP_MIRROR_NONE, "boat and drops in the water: sharp, or by a small cube"),
    CHOICE("mirror.size", mirror.size, "half|quarter", TP_MIRROR_QUARTER, TP_MIRROR_HALF,
           "a side of stencil's picture of them, of the whole one's"),
    NUMBER("mirror.bend", mirror.bend, "", 0, 4, 1,
           "how far slopes push the mirrored picture"),

    COUNT("grid.cols", grid.cols, "points", 2, 1024, 100, "of the water's mesh along x"),
    COUNT("grid.rows", grid.rows, "points", 2, 1024, 100, "of the water's mesh along z"),
    NUMBER("grid.cell", grid.cell, "m", 0.01, 50, 1.5, "from point to point"),
    NUMBER("grid.reach", grid.reach, "m", 0, 16000, 4000,
           "how far water goes on beyond the cells; 0: the grid is all"),
    SWITCH("grid.follow", grid.follow, 1, "the grid goes with the camera"),

    WAVE(0),  WAVE(1),  WAVE(2),  WAVE(3),  WAVE(4),  WAVE(5),  WAVE(6),  WAVE(7),
    WAVE(8),  WAVE(9),  WAVE(10), WAVE(11), WAVE(12), WAVE(13), WAVE(14), WAVE(15),

    NUMBER("floor.depth", floor.depth, "m", 0, 8000, 0,
           "of still water at the origin; 0 without a map: no floor at all"),
    NUMBER("floor.slope", floor.slope, "", 0, 1, 0, "rise of the floor per metre"),
    HEADING("floor.heading", floor.heading, 0, "towards which it rises"),
    NAME("floor.map", floor.map, GREY, "PNG of the floor's heights; empty: a slope"),
    NUMBER("floor.map_x", floor.map_x, "m", -8000, 8000, 0, "of the map's centre"),
    NUMBER("floor.map_z", floor.map_z, "m", -8000, 8000, 0, "of the map's centre"),
    NUMBER("floor.map_size", floor.map_size, "m", 1, 8000, 200, "the map's width"),
    NUMBER("floor.map_low", floor.map_low, "m", -8000, 100, -10, "height of its black"),
    NUMBER("floor.map_high", floor.map_high, "m", -8000, 100, 2, "height of its white"),
    COLOUR("floor.colour", floor.colour, 0xc8b48c, "of the land, times the texture"),
    NAME("floor.texture", floor.texture, TEXTURE, "PNG laid over it; empty: none"),
    NUMBER("floor.texture_size", floor.texture_size, "m", 0.1, 1000, 8,
           "side of the square that one repeat covers"),

    NUMBER("wind.strength", wind.strength, "rad/m", 0, 1, 0,
           "how far crests lean over before the wind, per metre of height"),
    HEADING("wind.heading", wind.heading, 0, "where it blows to, clockwise from -z"),

    NUMBER("surf.k0", surf.k0, "1/m", 0, 4, 0.1, "how soon orbits tilt with the floor"),
    NUMBER("surf.kx", surf.kx, "1/m", 0.001, 4, 0.11, "how soon orbits widen"),
    NUMBER("surf.ky", surf.ky, "1/m", 0.001, 4, 0.09, "how soon orbits flatten"),
    NUMBER("surf.stretch", surf.stretch, "", 0, 2, 1,
           "of breaking crests; 1: as their type"),
    NUMBER("surf.irregular", surf.irregular, "", 0, 1, 0.3,
           "of breaking crests, by noise"),

    POOL("pool", pool),
    POOL("field", field),

    CHOICE("tank.kind", tank.kind, "none|stone|glass", TP_TANK_GLASS, TP_TANK_NONE,
           "walls around the pool; the front ones of glass are seen through"),
    NUMBER("tank.depth", tank.depth, "m", 0.05, 100, 1, "of its floor"),
    NUMBER("tank.rim", tank.rim, "m", 0, 20, 0.2, "of its walls above still water"),
    NUMBER("tank.tile", tank.tile, "m", 0.05, 100, 1, "side of a texture's repeat"),
    NAME("tank.wall", tank.wall, TEXTURE, "PNG of the walls; empty: plain"),
    NAME("tank.floor", tank.floor, TEXTURE, "PNG of the floor; empty: plain"),
    COLOUR("tank.wall_colour", tank.wall_colour, 0xc0ccd0, "multiplies the walls"),
    COLOUR("tank.floor_colour", tank.floor_colour, 0xd8dcd8, "multiplies the floor"),
    COLOUR("tank.glass_colour", tank.glass_colour, 0x9cc8c0, "of the glass"),
    NUMBER("tank.glass", tank.glass, "", 0, 1, 0.15, "share of the glass's colour"),

    COUNT("foam.cells", foam.cells, "cells", 0, 256, 0,
          "of the side of its field; 0: no foam"),
    NUMBER("foam.cell", foam.cell, "m", 0.01, 50, 0.5, "side of such a cell"),
    NUMBER("foam.crest", foam.crest, "", 0, 2, 0.6,
           "crests squeezed to so much foam; 0: never"),
    NUMBER("foam.breaking", foam.breaking, "", 0, 2, 1, "of breaking crests"),
    NUMBER("foam.shore", foam.shore, "m", 0, 20, 0.3, "shallower water foams"),
    NUMBER("foam.wall", foam.wall, "", 0, 2, 0.5, "of water that moves along walls"),
    NUMBER("foam.hull", foam.hull, "", 0, 2, 0.5, "around the boat and behind it"),
    NUMBER("foam.fade", foam.fade, "s", 0.1, 600, 4, "in which it is down to a third"),
    MAP("foam", foam.map, 4, "PNG of its bubbles; empty: plain"),
    COLOUR("foam.colour", foam.colour, 0xf4f8fa, "in full light"),

    COUNT("spray.count", spray.count, "", 0, 1024, 0,
          "specks of spray and bubbles at once; 0: none"),
    NUMBER("spray.crest", spray.crest, "", 0, 4, 1, "thrown off breaking crests"),
    NUMBER("spray.impact", spray.impact, "", 0, 4, 1, "thrown up by drops"),
    NUMBER("spray.size", spray.size, "m", 0.001, 1, 0.03, "of a speck"),

    COUNT("drops.count", drops.count, "", 0, 1024, 0,
          "in the air at once; 0: no sphere and no drops"),
    COUNT("drops.rings", drops.rings, "", 0, 1024, 64, "on the water at once"),
    CHOICE("drops.into", drops.into, "rings|pool", TP_DROPS_POOL, TP_DROPS_RINGS,
           "what a drop stirs"),
    NUMBER("drops.x", drops.x, "m", -8000, 8000, 0, "of the sphere at the start"),
    NUMBER("drops.y", drops.y, "m", 0, 100, 3, "of the sphere, always"),
    NUMBER("drops.z", drops.z, "m", -8000, 8000, 0, "of the sphere at the start"),
    NUMBER("drops.radius", drops.radius, "m", 0.002, 1, 0.06, "of a drop"),
    NUMBER("drops.density", drops.density, "kg/m^3", 100, 10000, 1000, "of a drop"),
    NUMBER("drops.drag", drops.drag, "", 0, 2, 0.47,
           "of the air, Cd; 0: all fall alike"),
    NUMBER("drops.bounce", drops.bounce, "", 0.5, 0.8, 0.65, "speed after over before"),
    COUNT("drops.impacts", drops.impacts, "", 5, 7, 6, "then a drop is gone"),
    NUMBER("drops.every", drops.every, "s", 0, 60, 1,
           "between drops that fall by themselves; 0: none do"),
    NUMBER("drops.scatter", drops.scatter, "m", 0, 1000, 0,
           "they fall so far from the sphere at the most"),
    NUMBER("drops.efficiency", drops.efficiency, "", 0, 1, 0.2,
           "share of a drop's lost energy that its ring takes"),
    NUMBER("drops.speed", drops.speed, "m/s", 0.01, 64, 1.2, "of rings"),
    NUMBER("drops.decay", drops.decay, "s", 0.05, 1000, 2, "of rings"),
    NUMBER("drops.spread", drops.spread, "m", 0.01, 1000, 1,
           "distance at which a ring's height is down to 0.7"),
    NUMBER("drops.attack", drops.attack, "s", 0, 8, 0.1, "in which a ring rises"),
    COLOUR("drops.colour", drops.colour, 0xbfe0f0, "of sphere and drops"),

    NAME("boat.mesh", boat.mesh, MESH, "OBJ file of the boat; empty: none"),
    NUMBER("boat.x", boat.x, "m", -8000, 8000, 0, "to the right of the origin"),
    NUMBER("boat.z", boat.z, "m", -8000, 8000, -12, "towards the viewer"),
    HEADING("boat.heading", boat.heading, 0, "where the bow points, clockwise from -z"),
    NUMBER("boat.scale", boat.scale, "", 0.001, 100, 1, "metres per unit of the mesh"),
    NUMBER("boat.lift", boat.lift, "m", -50, 50, 0, "of the mesh above the surface"),
    NUMBER("boat.length", boat.length, "m", 0.1, 200, 10,
           "between the points of bow and stern that feel the water"),
    NUMBER("boat.beam", boat.beam, "m", 0.1, 200, 3,
           "between the points of both sides that feel the water"),
    CHOICE("boat.mode", boat.mode, "kinematic|dynamic", TP_BOAT_DYNAMIC,
           TP_BOAT_KINEMATIC, "lies on the water, or floats by its weight"),
    NUMBER("boat.smooth", boat.smooth, "s", 0, 10, 0, "how slowly it follows the water"),
    NUMBER("boat.draft", boat.draft, "m", 0.05, 20, 0.6, "of the hull at rest"),
    NUMBER("boat.drag", boat.drag, "", 0, 2, 0.3,
           "damping of its rocking; 1: it does not overshoot"),
    NUMBER("boat.speed", boat.speed, "m/s", -30, 30, 0, "that it sails by itself"),
    NUMBER("boat.rudder", boat.rudder, "degrees/s", -90, 90, 0,
           "that it turns by itself"),
    NUMBER("boat.wake", boat.wake, "", 0, 1, 0.5,
           "share of its moving volume that stirs the pool"),

    NUMBER("clock.scale", clock.scale, "", 0.125, 4, 1, "slow motion to fast forward"),

    NUMBER("quality.error_px", quality.error_px, "px", 0, 64, 0.5,
           "that outlines may be off, for speed"),
    NUMBER("quality.error_colour", quality.error_colour, "levels", 0, 255, 2,
           "that colours may be off, rms of 255, for speed"),
    CHOICE("quality.visibility", quality.visibility,
           "auto|triangles|rows|projected|flat", TP_VISIBILITY_FLAT, TP_VISIBILITY_AUTO,
           "how water is found in the picture"),
    CHOICE("quality.shading", quality.shading, "auto|exact|quick", TP_SHADING_QUICK,
           TP_SHADING_AUTO, "of the water: exact, or by slopes and nearest texels"),
    CHOICE("quality.rate", quality.rate, "auto|full|layers|colour", TP_RATE_COLOUR,
           TP_RATE_AUTO, "what is worked out for every second pixel"),
    CHOICE("quality.lod", quality.lod, "auto|off|on", TP_LOD_ON, TP_LOD_AUTO,
           "fewer lines of the grid where they lie close"),
    NUMBER("quality.frame_ms", quality.frame_ms, "ms", 0, 10000, 0,
           "of a frame, held by stepping down rungs; 0: off"),
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
        if (tp_piece_is((tp_piece){ name, bytes }, rows[i].name))
            return &rows[i];
    return NULL;
}
