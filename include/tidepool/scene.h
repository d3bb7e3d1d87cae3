/* SPDX-License-Identifier: MIT */
/* A scene: plain data that describes the water, the sky and the camera.
 *
 * An application sets the fields of tp_scene, or sets a row of the table of parameters by its
 * name.  The table gives each number its name, unit, range and default; INI files, the
 * command line, the preview and the manual use the same rows.  A scene may lie in ROM.  The
 * library opens no file: the application loads the pictures and the mesh that a scene names
 * and passes them as tp_assets. */
#ifndef TP_SCENE_H
#define TP_SCENE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/fixed.h"
#include "tidepool/status.h"

TP_BEGIN_C

#define TP_WAVES 16

/* One wave of the sea. */
typedef struct {
    tp_fx amplitude;        /* m, 0..16: half the height from trough to crest */
    tp_fx length;           /* m, 0.25..2000 */
    tp_fx steepness;        /* Q k A, 0..1; 0 is a plain sine */
    tp_fx heading;          /* degrees, clockwise from -z: where the wave travels to */
    tp_fx phase;            /* degrees at tick 0 */
    tp_fx speed;            /* of its natural speed sqrt(g/k); 0 stands still */
    int32_t power;          /* 1..8: 1 is a sine, more sharpen its crests [A3]; 0 is 1 */
} tp_wave;

typedef enum { TP_DROPS_RINGS, TP_DROPS_POOL } tp_drops_into;

/* Drops that fall from a sphere and bounce on the water. */
typedef struct {
    int32_t count;          /* drops in the air at once, 0..1024; 0: no sphere, no drops */
    int32_t rings;          /* on the water at once, 0..1024 */
    int32_t into;           /* tp_drops_into */
    tp_fx   x, y, z;        /* m, of the sphere at tick 0 */
    tp_fx   radius;         /* m of a drop, 0.002..1; the sphere's is twice as much */
    tp_fx   density;        /* kg/m^3, 100..10000 */
    tp_fx   drag;           /* Cd [D1], 0..2; 0: mass does not matter */
    tp_fx   bounce;         /* e [D2], 0.5..0.8 */
    int32_t impacts;        /* 5..7: impacts of a drop before it vanishes */
    tp_fx   every;          /* s between drops that fall by themselves; 0: none do */
    tp_fx   scatter;        /* m: greatest distance from the sphere at which drops fall */
    tp_fx   efficiency;     /* share of the lost energy that the ring takes, 0..1 [D4] */
    tp_fx   speed, decay, spread, attack;   /* of rings: m/s, s, m, s */
    int32_t colour;         /* of drops and sphere */
} tp_scene_drops;

typedef enum { TP_CELLS_8, TP_CELLS_16, TP_CELLS_32 } tp_cells;

typedef enum {
    TP_EDGES_WALL,          /* reflect */
    TP_EDGES_SPONGE,        /* walls behind `sponge` cells that swallow waves [C15] */
    TP_EDGES_TILE           /* what leaves at one side enters at the other: an endless
                             * field, sampled anywhere */
} tp_edges;

/* The method that draws the water's surface.  A frame that the method cannot draw (overhangs,
 * a camera in the water, strong roll ...) is drawn as triangles. */
typedef enum {
    TP_VISIBILITY_AUTO, TP_VISIBILITY_TRIANGLES, TP_VISIBILITY_ROWS,
    TP_VISIBILITY_PROJECTED, TP_VISIBILITY_FLAT
} tp_visibility;

/* Exact shading, or fast shading by slopes and nearest texels. */
typedef enum { TP_SHADING_AUTO, TP_SHADING_EXACT, TP_SHADING_QUICK } tp_shading;

/* Shading at half rate: nothing, the layers, or the whole colour, of every second pixel. */
typedef enum { TP_RATE_AUTO, TP_RATE_FULL, TP_RATE_LAYERS, TP_RATE_COLOUR } tp_rate;

/* Level of detail: fewer lines of the grid where they lie close together. */
typedef enum { TP_LOD_AUTO, TP_LOD_OFF, TP_LOD_ON } tp_lod;

#define TP_NAME_BYTES 128       /* of a name in a scene, its end included */

/* A pool: a grid of cells whose heights move as waves of shallow water. */
typedef struct {
    int32_t cols, rows;             /* cells, 16..512; cols 0: no pool */
    int32_t cells, edges;           /* tp_cells, tp_edges */
    int32_t damping;                /* n: 2^-n of the motion is lost each tick */
    int32_t sponge;                 /* width of the edges of TP_EDGES_SPONGE, cells */
    tp_fx   courant;                /* wave speed x tick / cell, 0.05 to about 0.49 */
    tp_fx   range;                  /* m at the full range of 8- and 16-bit cells */
    tp_fx   cell, x, z;             /* m: the side of a cell; the centre of the pool */
    tp_fx   feed_low, feed_high;    /* m: feeding holds the rms of the heights between
                                     * these two; 0, 0: no feeding */
    tp_fx   feed;                   /* m: height of one injection */
    tp_fx   poke_every;             /* s between splashes at random places; 0: none */
    tp_fx   poke, poke_size;        /* m: height and width of a splash */
    tp_fx   paddle, paddle_period;  /* m, s: waves made at the north edge */
    char    mask[TP_NAME_BYTES];    /* PNG, "": no walls inside */
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

/* Numbers for the settings of the application's own modules, tidepool/modules.h. */
#define TP_OWN_WORDS 32

/* Numbers are 16.16 unless said; angles are degrees; colours 0x00RRGGBB.  `tidepool params`
 * prints unit, range, default and meaning of each row. */
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
        tp_fx   depth;                      /* m; 0 and no map: open sea */
        tp_fx   slope, heading;             /* rise a metre, towards heading */
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
    struct {                                /* how well it must be drawn */
        tp_fx   error_px, error_colour;     /* outlines, px; rms of colours, of 255 */
        int32_t visibility, shading, rate, lod;     /* a rung, or auto: the budget's */
        tp_fx   frame_ms;                   /* that the governor holds; 0: none */
    } quality;
    int32_t own[TP_OWN_WORDS];              /* settings of the application's own modules */
    const struct tp_assets *pictures;       /* built-in ones, of tp_scene_init; NULL: none */
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

/* All rows, in the order in which people should read them. */
const tp_param *tp_params(uint32_t *count);

/* Writes a row's value as text that tp_scene_set reads back: terminated, cut to `bytes`.
 * Returns the length of the whole text. */
size_t tp_param_text(const tp_scene *scene, const tp_param *param, char *text,
                     size_t bytes);

/* Sets the row `name` from its text ("0.35", "on", "#204060", "linear", a file name).  White
 * space around the text is ignored.  A bad text changes nothing.
 *  - TP_E_NULL: err->word is the argument; TP_E_NAME: no row has the name err->word
 *  - TP_E_NUMBER, TP_E_CHOICE, ...: err->word is the bad text
 *  - TP_E_RANGE: the same; err->a and err->b are the range in the number's own format */
tp_status tp_scene_set(tp_scene *scene, const char *name, const char *value, tp_error *err);

/* Sets a gentle sea of three waves under a sunny sky, with a built-in picture of ripples.
 * The picture, 1364 bytes, is linked only into programs that call this function. */
void tp_scene_init(tp_scene *scene);

/* Sets level water: the default of each row.  Scene files start from it. */
void tp_scene_level(tp_scene *scene);

/* Checks every number of a scene.  After a failure err->word is the name of the first row
 * at fault:
 *  - TP_E_RANGE: a number, choice or colour outside the row's range, err->a..err->b
 *  - TP_E_UNENDED: a name without its terminating zero; TP_E_TEXT: a control character
 *  - TP_E_POOL_...: numbers of a pool that cannot be used together
 * Inits, byte counts and applies call this function; an application need not.  It does not
 * check the pictures that a scene names: tp_world_init does. */
tp_status tp_scene_check(const tp_scene *scene, tp_error *err);

TP_END_C
#endif
