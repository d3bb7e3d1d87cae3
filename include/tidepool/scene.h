/* SPDX-License-Identifier: MIT */
/* A scene: plain data that a person may change, each number a row of one table.
 *
 * The scene may lie in ROM.  The port loads the files that it names (mesh, textures) and
 * hands them to world and frame; its one pointer is to pictures that are built in.  The
 * table gives INI files, the command line, the preview's panel and the manual their names,
 * units, ranges and defaults. */
#ifndef TP_SCENE_H
#define TP_SCENE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/asset.h"
#include "tidepool/clock.h"
#include "tidepool/drop.h"
#include "tidepool/foam.h"
#include "tidepool/fx.h"
#include "tidepool/program.h"
#include "tidepool/language.h"
#include "tidepool/ocean.h"
#include "tidepool/pool.h"
#include "tidepool/ring.h"
#include "tidepool/status.h"
#include "tidepool/wave.h"

TP_BEGIN_C

#define TP_NAME_BYTES 128       /* of a name in a scene, its end included */

/* A pool as a scene describes it; see tp_pool_config for the meanings. */
typedef struct {
    int32_t cols, rows;                     /* cols 0: no such pool */
    int32_t cells, edges, damping, sponge;
    tp_fx   courant, range, cell, x, z;
    tp_fx   feed_low, feed_high, feed;
    tp_fx   poke_every, poke, poke_size;    /* s between hats at random places, m, m */
    tp_fx   paddle, paddle_period;          /* m, s: of waves made at the north edge */
    char    mask[TP_NAME_BYTES];            /* PNG, "": no walls inside */
} tp_scene_pool;

/* A picture that drifts over the water. */
typedef struct {
    char    texture[TP_NAME_BYTES];         /* PNG, "": none */
    tp_fx   size;                           /* m that one repeat covers */
    tp_fx   drift_x, drift_z;               /* m/s */
} tp_scene_map;

/* One of the water's pictures.  A texel is first brought to `saturation` (0: its grey),
 * then what is above `clamp` is spread over 0..1, then `colour` multiplies it.  The first
 * layer is the water's colour; the others add to it. */
typedef struct {
    tp_scene_map map;
    tp_fx   saturation, clamp;
    int32_t colour;
} tp_scene_layer;

#define TP_LAYERS 3
#define TP_FACES  6             /* of a cube: +x -x +y -y +z -z */

/* Room for the settings of modules that a program brings itself, tidepool/rows.h. */
#define TP_OWN_WORDS 32

/* Numbers are 16.16 unless said; angles are degrees; colours 0x00RRGGBB. */
typedef struct tp_scene {
    char title[TP_NAME_BYTES], shows[TP_NAME_BYTES];
    struct {
        tp_fx   x, y, z, heading, pitch, fov, near;
        int32_t follow;                     /* tp_camera_follow */
    } camera;
    struct {
        tp_fx   heading, elevation;
        int32_t colour;
        tp_fx   ambient;
        int32_t model;                      /* tp_light_model */
        tp_fx   turn;                       /* degrees/s that it goes round */
    } light;
    struct {
        int32_t kind;                       /* tp_sky_kind */
        int32_t horizon, zenith;
        tp_fx   haze;
        tp_fx   sun, stars;                 /* intensity of the disc; share of stars */
        /* PNGs of a cube's sides, seen from inside: four upright, the lower edge of `up`
         * and the upper edge of `down` join the south.  Alpha is light beyond white [F8],
         * 255 for 16 whites more; a PNG without alpha has none. */
        char    east[TP_NAME_BYTES], west[TP_NAME_BYTES];
        char    up[TP_NAME_BYTES], down[TP_NAME_BYTES];
        char    south[TP_NAME_BYTES], north[TP_NAME_BYTES];
    } sky;
    struct {
        tp_fx   share;                      /* of the alpha's light; 0: no HDR */
        int32_t exposure;                   /* tp_exposure_mode */
        tp_fx   value, rate;                /* fixed exposure; share of the way a tick */
    } hdr;
    struct {
        int32_t colour;                     /* of the water, times the first layer */
        int32_t filter;                     /* tp_filter */
        tp_fx   specular, shininess, reflection;
        int32_t fresnel;                    /* tp_fresnel_rule */
        tp_fx   gravity;
        tp_fx   pool_bump;                  /* > 0: pools bend normals, not the mesh */
        tp_fx   clear;                      /* m; 0: nothing is seen through the water */
        int32_t tint;                       /* what white becomes after `clear` m */
        int32_t deep;                       /* what is seen where nothing is */
        tp_fx   dispersion;                 /* spread of the refractive index */
        tp_fx   caustics;                   /* strength of light focused on the floor */
        int32_t caustic_cells;              /* of the map's side */
        tp_fx   caustic_size;               /* m that it covers, without a pool */
    } water;
    tp_scene_layer layer[TP_LAYERS];
    struct { tp_scene_map map; tp_fx strength; } distortion;        /* m */
    struct { tp_scene_map map; tp_fx bump; } ripple;    /* normal map; 1 = as it says */
    struct {
        int32_t objects, size;              /* tp_mirror_kind, tp_mirror_size */
        tp_fx   bend;
    } mirror;
    struct {                                /* of the pool's sides */
        int32_t kind;                       /* tp_tank_kind */
        tp_fx   depth, rim, tile;           /* m: down, above still water, of a repeat */
        char    wall[TP_NAME_BYTES], floor[TP_NAME_BYTES];
        int32_t wall_colour, floor_colour, glass_colour;
        tp_fx   glass;                      /* share of its colour, 0..1 */
    } tank;
    struct {
        int32_t cells;                      /* of the field's side; 0: no foam */
        tp_fx   cell;                       /* m */
        tp_fx   crest, breaking, shore, wall, hull;     /* what makes it */
        tp_fx   fade;                       /* s */
        tp_scene_map map;                   /* whose drift is the foam's own */
        int32_t colour;
    } foam;
    struct { int32_t count; tp_fx crest, impact, size; } spray;
    struct { int32_t cols, rows; tp_fx cell, reach; int32_t follow; } grid;
    tp_wave wave[TP_WAVES];
    struct {
        tp_fx   depth, slope, heading;      /* depth 0, no map: open sea; see tp_floor */
        char    map[TP_NAME_BYTES];         /* PNG of heights, "": none */
        tp_fx   map_x, map_z, map_size, map_low, map_high;
        int32_t colour;                     /* of the land, times the texture */
        char    texture[TP_NAME_BYTES];     /* PNG, "": none */
        tp_fx   texture_size;
    } floor;
    struct { tp_fx strength, heading; } wind;       /* rad/m [B10], degrees */
    struct { tp_fx k0, kx, ky, stretch, irregular; } surf;  /* [B12], [B20] */
    tp_scene_pool pool, field;              /* a patch, and a tiled one under it */
    tp_scene_drops drops;
    struct {
        char    mesh[TP_NAME_BYTES];        /* OBJ file, "": no boat */
        tp_fx   x, z, heading, scale, lift; /* lift: m above the surface */
        tp_fx   length, beam;               /* of the hull points in the water, m */
        int32_t mode;                       /* tp_boat_mode */
        tp_fx   smooth;                     /* s: time of the low-pass on its pose */
        tp_fx   draft;                      /* m under water when it floats at rest */
        tp_fx   drag;                       /* damping of its rocking, of the critical */
        tp_fx   speed, rudder;              /* m/s, degrees/s that it sails by itself */
        tp_fx   wake;                       /* share of its volume that stirs the pool */
    } boat;
    struct { tp_fx scale; } clock;          /* 1/8..4: slow motion, fast forward [D6] */
    struct {                                /* how well it must be drawn; plan.h */
        tp_fx   error_px, error_colour;     /* outlines, px; rms of colours, of 255 */
        int32_t visibility, shading, rate, lod;     /* a rung, or auto: the budget's */
        tp_fx   frame_ms;                   /* that the governor holds; 0: none */
    } quality;
    int32_t own[TP_OWN_WORDS];              /* of modules that a program brings itself */
    const struct tp_assets *pictures;       /* its own: tp_scene_init's; NULL: none */
} tp_scene;

typedef enum { TP_BOAT_KINEMATIC, TP_BOAT_DYNAMIC } tp_boat_mode;

typedef enum { TP_FILTER_NEAREST, TP_FILTER_LINEAR } tp_filter;
typedef enum { TP_FOLLOW_NONE, TP_FOLLOW_BOAT } tp_camera_follow;
typedef enum { TP_LIGHT_PHONG, TP_LIGHT_BLINN } tp_light_model;
typedef enum { TP_SKY_GRADIENT, TP_SKY_DAY, TP_SKY_DUSK, TP_SKY_NIGHT, TP_SKY_CUBE
} tp_sky_kind;
typedef enum { TP_EXPOSURE_FIXED, TP_EXPOSURE_AUTO } tp_exposure_mode;
typedef enum { TP_FRESNEL_TABLE, TP_FRESNEL_SCHLICK } tp_fresnel_rule;
typedef enum { TP_MIRROR_NONE, TP_MIRROR_STENCIL, TP_MIRROR_CUBE } tp_mirror_kind;
typedef enum { TP_MIRROR_HALF, TP_MIRROR_QUARTER } tp_mirror_size;
typedef enum { TP_TANK_NONE, TP_TANK_STONE, TP_TANK_GLASS } tp_tank_kind;

typedef enum {
    TP_PARAM_FX,                /* 16.16 */
    TP_PARAM_INT,
    TP_PARAM_BOOL,              /* off, on */
    TP_PARAM_COLOUR,            /* #rrggbb */
    TP_PARAM_CHOICE,            /* a word of `unit`, which lists them: "nearest|linear" */
    TP_PARAM_MESH,              /* file name of an OBJ */
    TP_PARAM_TEXTURE,           /* file name of a PNG */
    TP_PARAM_GREY,              /* file name of a PNG read as one number a pixel */
    TP_PARAM_TEXT
} tp_param_kind;

typedef struct {
    const char *name;           /* "wave0.steepness" */
    const char *unit;           /* "m", "degrees", "" ... */
    const char *help;           /* one line */
    tp_param_kind kind;
    int32_t  low, high, normal; /* range and default, in the number's own format */
    const char *text;           /* the default of names and texts */
    uint32_t offset;            /* of the int32_t or char[TP_NAME_BYTES] in tp_scene */
} tp_param;

/* True if the row's value is a file's name; true if it is text of any kind, in a
 * char[TP_NAME_BYTES], rather than a number in an int32_t. */
static inline bool tp_param_is_file(const tp_param *param)
{
    return param->kind == TP_PARAM_MESH || param->kind == TP_PARAM_TEXTURE
        || param->kind == TP_PARAM_GREY;
}

static inline bool tp_param_is_text(const tp_param *param)
{
    return tp_param_is_file(param) || param->kind == TP_PARAM_TEXT;
}

/* All rows, in the order in which people should read them. */
const tp_param *tp_params(uint32_t *count);

/* The row of that name, or NULL. */
const tp_param *tp_param_find(const char *name, size_t bytes);

/* Sets one value from its text ("0.35", "on", "#204060", "linear", a file name), white
 * space around it ignored; a bad text changes nothing.  err->word is the bad text; of
 * E_RANGE err->a and err->b are the range's ends in the number's own format. */
tp_status tp_param_set(tp_scene *scene, const tp_param *param, const char *text,
                       size_t bytes, tp_error *err);

/* The value as text that tp_param_set reads back, terminated, cut to `bytes`; returns
 * its whole length.  Likewise a row's range end or default, by its number. */
size_t tp_param_text(const tp_scene *scene, const tp_param *param, char *text,
                     size_t bytes);
size_t tp_param_number_text(const tp_param *param, int32_t number, char *text,
                            size_t bytes);

/* A gentle sea of three waves under a sunny sky, with a picture of ripples that is built
 * in; only who calls this links the picture, 1364 bytes. */
void tp_scene_init(tp_scene *scene);

/* Level water: each row's default, from which scene files and settings start. */
void tp_scene_level(tp_scene *scene);

/* TP_OK: every init takes this scene.  Otherwise err->word is the name of the first row
 * at fault:
 *  - TP_E_RANGE: a number, choice or colour outside the row's range, err->a..err->b
 *  - TP_E_UNENDED: a name without its terminating zero; TP_E_TEXT: a control character
 *  - TP_E_POOL_...: numbers of a pool that cannot be used together, see tp_pool_check
 * The inits of a world and a frame, their byte counts, tp_world_apply and the plan call
 * it, so a program that sets numbers need not.  Pictures that the scene names are no part
 * of it: tp_world_init checks these. */
tp_status tp_scene_check(const tp_scene *scene, tp_error *err);

/* -- what a scene names, as the port loaded it; NULL for what it does not name ------ */

typedef struct tp_assets {
    const tp_mesh    *boat;
    const tp_texture *layer[TP_LAYERS], *distortion, *ripple, *foam;
    /* Layers, distortion and ripple prepared for the quick rung (tp_prepare), for the scene's
     * numbers; they do not follow a change of those.  NULL: the frame prepares them in its
     * block. */
    const tp_texture *graded[TP_LAYERS], *offsets, *slopes;
    const tp_texture *sky[TP_FACES], *tank_wall, *tank_floor, *floor_texture;
    const tp_grey    *floor;            /* scene.floor.map */
    const tp_grey    *pool_mask, *field_mask;   /* scene.pool.mask, scene.field.mask */
} tp_assets;

/* The pictures that NULL assets stand for. */
static inline const tp_assets *tp_scene_pictures(const tp_scene *scene,
                                                 const tp_assets *assets)
{
    return assets ? assets : scene->pictures;
}

/* TP_OK: worlds and frames of this program take this scene; every init, their byte counts
 * and tp_world_apply ask it.  NULL assets are none.
 *  - TP_E_NULL: err->word is the argument
 *  - as tp_scene_check, if the program has it
 *  - TP_E_PROGRAM: the scene has a module on that the program names in its `lacks`;
 *    err->word is that name, as `tidepool bake --with` takes it.  Fast stages are lacking
 *    only if quality.shading names them: a plan takes exact ones then. */
tp_status tp_program_fits(const tp_program *program, const tp_scene *scene,
                          const tp_assets *assets, tp_error *err);

/* -- the world: a scene as it moves ----------------------------------------------
 *
 * Each world goes with one program: what that lacks is not in it, as if the scene did not
 * name it; unless the program refuses such a scene, see tp_program_fits. */

/* A hat put into the pool, as wide as pool.poke_size: m above the level, at a place in
 * the world, m.  Of height 0 there is none; outside of the pool it does nothing. */
typedef struct {
    tp_fx   height, x, z;
} tp_push;

#define TP_PUSHES 8             /* that one tick takes */

/* What the port feeds in at each tick; all 0 is no input.  Any numbers are safe: camera
 * and sphere stay within 8000 m of the origin, the boat's speed within 100 m/s and its
 * turn within 360 degrees/s; negative drops are none, those that find no room are
 * counted. */
typedef struct {
    tp_fx   forward, strafe, up;    /* m that the camera moves: along its heading, to its
                                     * right, both level; and upwards */
    int32_t turn, tilt;         /* tp_turn steps of its heading and pitch, signed */
    tp_fx   sphere_x, sphere_z; /* m that the sphere of drops moves */
    int32_t drops;              /* to release, 0..1024 */
    tp_fx   throttle, rudder;   /* of the boat: m/s and degrees/s beside the scene's */
    int32_t slowdown;           /* n: halves the clock's scale n times; -n: doubles it */
    int32_t light_turn, light_tilt;     /* tp_turn steps of the light, signed */
    tp_push push[TP_PUSHES];    /* in their order; a world without a pool takes none */
} tp_input;

/* The layout of a world's block.  It rises when the head or a chunk changes its meaning;
 * a block of another version is refused. */
enum { TP_WORLD_VERSION = 4 };

/* States of modules lie behind this head as chunks: an id, a length, the bytes. */
typedef struct {
    uint32_t version;           /* TP_WORLD_VERSION */
    uint32_t modules;           /* byte offset of the first chunk; 0: there is none */
    uint32_t bytes;             /* of the whole block */
} tp_world_parts;

typedef struct {
    tp_vec3  place;             /* the mesh's origin; 0 in scenes that name no mesh */
    tp_turn  heading, pitch, roll;
} tp_pose;

/* Where a hull lies: in the plane, and the water over its waterline [E4]: in the middle,
 * of the bow over the stern, of port over starboard. */
typedef struct {
    tp_fx    x, z;
    tp_turn  heading;
    tp_fx    sunk[3];
} tp_hull;

/* How a boat lies: three lengths in Q40 m, the height of its waterline, of its bow over
 * its stern, of its port over its starboard side; and how they change, a tick, if it
 * floats. */
typedef struct { int64_t at[3], speed[3]; } tp_lie;

/* What of a boat moves. */
typedef struct {
    int64_t  sailed_x, sailed_z;    /* Q32 m from the scene's place */
    uint64_t turned;                /* Q64 turn from the scene's heading */
    tp_lie   lie, alone;        /* alone: as if the pool that it stirs were not there */
    tp_fx    rest[4][2];        /* of bow, stern, port and starboard in the water [E1] */
    tp_hull  hull, stirred;     /* now, and when it last stirred the pool [E4] */
    uint32_t laid;              /* 1: it has been laid on the water */
    uint32_t stirs;             /* ticks in which it stirred the pool, so far */
} tp_afloat;

/* Where the camera of a world stands. */
typedef enum {
    TP_ABOARD_NOT,  /* in the world: the scene's camera follows nothing */
    TP_ABOARD_DECK, /* on the boat: its place and angles are of the deck */
    TP_ABOARD_LEFT  /* in the world: tp_world_set_camera ended the following */
} tp_aboard;

/* Plain data without pointers, in one block of tp_world_bytes() bytes: copying it is a
 * snapshot. */
typedef struct {
    uint64_t tick;
    tp_fx    back;              /* 0..1: the picture lies so much of a tick before */
    tp_world_parts parts;
    tp_vec3  eye, last_eye;     /* the camera now and a tick ago, see aboard */
    tp_turn heading, pitch, roll, last_heading, last_pitch, last_roll;
    tp_turn  phases[TP_WAVES];  /* of this tick */
    uint32_t random;            /* of pokes */
    tp_pose  boat, last_boat;
    tp_afloat afloat;           /* the boat's */
    tp_turn  light_heading, light_elevation;    /* as input has moved it, and time */
    tp_turn  last_light_heading, last_light_elevation;
    tp_fx    scene_light[2];    /* heading and elevation of the scene, last looked at */
    tp_fx    exposure, last_exposure;
    tp_clock clock;
    tp_fx    clock_scale;       /* the scene's, when it was last looked at */
    uint32_t aboard;            /* tp_aboard */
    tp_sea sea;                 /* the last, without its swells if the program has none */
} tp_world;

/* sizeof (tp_world) if the scene has no pool, no floor or wind, no drops, and less by a
 * program without swells; 0 if it cannot be used (tp_world_init says why).  NULL assets are
 * none. */
size_t tp_world_bytes(const tp_program *program, const tp_scene *scene,
                      const tp_assets *assets);

/* The world of `scene` at tick 0, in `bytes` bytes aligned to 8.  Pictures that the
 * assets hold are read now and not kept; NULL assets are none.
 *  - TP_E_NULL, TP_E_ALIGN: err->word is the argument; TP_E_NOSPACE: `bytes` are too few
 *  - as tp_program_fits: err->word is the parameter at fault ("pool.courant"), or the
 *    module that the program lacks
 *  - TP_E_ARG: a map of the floor ("floor.map") outside what tp_ocean_init takes */
tp_status tp_world_init(const tp_program *program, tp_world *world, size_t bytes,
                        const tp_scene *scene, const tp_assets *assets, tp_error *err);

/* Checks that bytes from outside, such as a file's, are a world that can be stepped and
 * drawn.  `fresh` is a world of the same scene, assets and program, as tp_world_init or
 * tp_world_apply leaves it: version, layout and everything that follows from the scene
 * must be equal; numbers that ticks change must be in the ranges that ticks keep.  `world`
 * has `bytes` bytes, aligned to 8.  TP_E_WORLD: err->word names the part at fault; TP_E_NULL,
 * TP_E_ALIGN: the argument. */
tp_status tp_world_check(const tp_program *program, const tp_world *world, size_t bytes,
                         const tp_world *fresh, tp_error *err);

/* One tick further; `input` may be NULL.  After a change of the scene's numbers call
 * tp_world_apply first. */
void tp_world_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                   const tp_input *input);

/* Pushes the water at (x, z) m of the world, at once; between ticks, as often as wanted.
 *  - In the pool, else in the field: a hat of `height` m, up or down, that moves no volume,
 *    its width `radius` m (at least 1.5 cells).  A push of scene.pool.poke_size into the
 *    pool gives the same bits as that one in tp_input.push of the next tick, unless drops or
 *    a boat feel the pool in that tick: they then feel this push already.
 *  - On open water, where drops raise rings (drops.into = rings): a ring that begins with a
 *    crest of |height| m, 4 m at the most, of the length 4 radii, 16 m of radius at the
 *    most; with foam where the scene has foam.  It is seen from the next tick on.
 * False: no water moves, as there is nothing to take it at this place (no water, a wall,
 * more than 9000 m from the origin), no room for another ring, or a height of 0.  `scene`
 * is the one that the world was made for, or last refreshed by. */
bool tp_world_push(const tp_program *program, tp_world *world, const tp_scene *scene,
                   tp_fx x, tp_fx z, tp_fx radius, tp_fx height);

/* Moves the camera alone, while the water stands. */
void tp_world_move_camera(tp_world *world, const tp_input *input);

/* Places the camera in the world: the eye in metres, each axis held within +-8000 m, and
 * three angles of any size, in the order of tp_rotation_of: heading clockwise from -z as
 * seen from above, pitch upwards, roll lowers the picture's right side.  The next picture
 * is seen from there exactly, whatever world->back is; from then on input moves the camera
 * as ever, and tilts it to 89 degrees at the most.
 *
 * In a scene whose camera follows the boat the following ends: the camera stands in the
 * world until tp_world_reset_camera, or until camera.follow has been none in one
 * tp_world_apply and boat in a later one. */
void tp_world_set_camera(tp_world *world, tp_vec3 eye, tp_turn heading, tp_turn pitch,
                         tp_turn roll);

/* Places the camera as the scene does at tick 0, following the boat if the scene does. */
void tp_world_reset_camera(tp_world *world, const tp_scene *scene);

/* The scene as it is now, at the same tick: sea, ocean, boat, what of pools and drops may
 * change while they move.  False, and nothing is done: what sizes the world's block has
 * changed, or the scene cannot be used; tp_world_init makes the world anew, or tells what
 * is wrong.  Until one of them has taken the scene, neither step nor draw by it.
 *
 * Tables that take long to make, the ocean's and those of automatic exposure, keep the
 * numbers that they were made of, and are made again only where these have changed.  So
 * `assets` must hold the pictures that the world was made with. */
bool tp_world_apply(const tp_program *program, tp_world *world, const tp_scene *scene,
                    const tp_assets *assets);

/* Where the picture is seen from, and how: rows right, up and backward. */
typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
} tp_camera;

/* In the world, world->back of a tick before the last one, wherever it stands. */
tp_camera tp_world_camera(const tp_world *world);

/* Ticks that the clock asks for until the next picture: step the world so many times. The
 * picture then lies world->back of a tick before the last one. */
uint32_t tp_world_advance_clock(tp_world *world);

/* The middle of a pixel's column or row, 16.16; -32768 <= pixel < 32768. */
static inline tp_fx tp_pixel_middle(int32_t pixel)
{
    return pixel * TP_FX_ONE + TP_FX_ONE / 2;
}

/* The water at a place. */
typedef struct {
    tp_fx height;           /* m above the level of still water */
    tp_fx slope_x, slope_z; /* dy/dx and dy/dz */
    tp_vec3 velocity;       /* m/s, of the surface's point there: see tp_world_sample */
} tp_water;

/* The water above or below (x, z), m of the world, as the last tick left it [E1]: waves,
 * rings and pools together, without what overhangs.  No camera and no picture is asked:
 * any number of places, by any number of threads while the world stands still.
 *
 * Where waves are displaced sideways the place is found by inversion: within 30 km of the
 * origin, each way, and with a steepness sum below 0.9 the point is off by less than 1 mm
 * along and up (see tp_sea_above).  Any x and z are answered; near the ends
 * of 16.16 positions are held there.
 *
 * The velocity is the mean over the last tick, so that of 1/120 s ago: a boat that drifts
 * with the point is carried where waves carry it.  Swells and oceans move a point in all
 * three axes; rings and pools, which are heights, lift it alone.  Roundings are 3 mm/s, and
 * 1 mm/s more for each metre of the waves' amplitudes together. */
tp_water tp_world_sample(const tp_program *program, const tp_world *world, tp_fx x,
                         tp_fx z);

/* The place on the water under a place of a picture of width x height pixels, 1..8192
 * each: x_px and y_px pixels, 16.16, from its upper left corner; see tp_pixel_middle.  The
 * ray through it first meets the surface at *at: waves, rings and pools, these without
 * heights where they bend the light only; from below the surface as well.  It is within
 * 1 px of what is drawn there, but for crests that overhang and for what lies at a mesh's
 * far end, where its waves fade.  A place outside of the picture is one of a larger one.
 * False: the ray does not meet water within 8000 m, or meets land first, or a tank's walls
 * end before. */
bool tp_world_pick(const tp_program *program, const tp_world *world,
                   const tp_scene *scene, uint32_t width, uint32_t height, tp_fx x_px,
                   tp_fx y_px, tp_vec3 *at);

/* -- the parts, or NULL ------------------------------------------------------------ */

const tp_pool  *tp_world_pool(const tp_world *world);
const tp_pool  *tp_world_field(const tp_world *world);
const tp_ocean *tp_world_ocean(const tp_world *world);
const tp_drops *tp_world_drops(const tp_world *world);
const tp_foam  *tp_world_foam(const tp_world *world);
const tp_spray *tp_world_spray(const tp_world *world);

/* True if the exposure is automatic. */
bool tp_world_is_metered(const tp_world *world);

TP_END_C
#endif
