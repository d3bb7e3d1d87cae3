/* SPDX-License-Identifier: MIT */
/* A scene: plain data that describes the water, the sky and the camera.
 *
 * An application sets the fields of tp_scene, or sets a row of the table of parameters
 * by its name.  The table gives each number its name, unit, range and default; INI
 * files, the command line, the preview and the manual use the same rows.  A scene may
 * lie in ROM.  The library opens no file: the application loads the pictures and the
 * mesh that a scene names and passes them as tp_assets. */
#ifndef TP_SCENE_H
#define TP_SCENE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/fixed.h"
#include "tidepool/status.h"

TP_BEGIN_C

#define TP_WAVES 16

/* One Gerstner wave of the sea. */
typedef struct {
    tp_fx amplitude;        /* m, 0..16: half the height from trough to crest */
    tp_fx length;           /* m, 0.25..2000 */
    tp_fx steepness;        /* Q k A, 0..1; 0 is a plain sine */
    tp_fx heading;          /* direction of travel, degrees, clockwise from -z */
    tp_fx phase;            /* degrees at tick 0 */
    tp_fx speed;            /* factor of the natural speed sqrt(g/k); 0: stands still */
    int32_t exponent;       /* 1..8: 1 is a sine, more sharpens crests [A3]; 0 is 1 */
} tp_wave;

typedef enum { TP_DROPS_RINGS, TP_DROPS_POOL } tp_drops_target;

/* Drops that fall from a sphere and bounce on the water. */
typedef struct {
    int32_t count;          /* drops in the air at once, 0..1024; 0: no drops, no sphere */
    int32_t rings;          /* rings on the water at once, 0..1024 */
    int32_t target;         /* tp_drops_target: impacts make rings, or move the pool */
    tp_fx   x, y, z;        /* position of the sphere at tick 0, m */
    tp_fx   radius;         /* radius, m, 0.002..1; the sphere's is twice as large */
    tp_fx   density;        /* kg/m^3, 100..10000 */
    tp_fx   drag;           /* Cd [D1], 0..2; 0: mass does not matter */
    tp_fx   bounce;         /* coefficient of restitution e [D2], 0.5..0.8 */
    int32_t impacts;        /* impacts of a drop before it vanishes, 5..7 */
    tp_fx   interval;       /* time between automatic drops, s; 0: no automatic drops */
    tp_fx   scatter_radius; /* greatest distance of a falling drop from the sphere, m */
    tp_fx   efficiency;     /* share of the lost energy that the ring takes, 0..1 [D4] */
    tp_fx   ring_speed, ring_decay, ring_spread, ring_rise_time;    /* m/s, s, m, s */
    int32_t colour;         /* colour of drops and sphere */
} tp_scene_drops;

typedef enum { TP_CELLS_8, TP_CELLS_16, TP_CELLS_32 } tp_cells;

typedef enum {
    TP_EDGES_WALL,          /* walls reflect waves */
    TP_EDGES_SPONGE,        /* walls behind `sponge` cells that absorb waves [C15] */
    TP_EDGES_TILE           /* periodic: waves that leave at one side enter at the opposite
                             * side; the field repeats endlessly */
} tp_edges;

/* The renderer of the water's surface.  A frame that the renderer cannot draw (overhangs,
 * a camera in the water, strong roll ...) is drawn as triangles. */
typedef enum {
    TP_VISIBILITY_AUTO, TP_VISIBILITY_TRIANGLES, TP_VISIBILITY_ROWS,
    TP_VISIBILITY_PROJECTED, TP_VISIBILITY_FLAT, TP_VISIBILITY_WALK
} tp_visibility;

/* Exact shading, or fast shading: lighting from slopes, nearest texels. */
typedef enum { TP_SHADING_AUTO, TP_SHADING_EXACT, TP_SHADING_QUICK } tp_shading;

/* Half rate: every second pixel of nothing (full rate), of the layers, or of the whole
 * colour is interpolated. */
typedef enum { TP_RATE_AUTO, TP_RATE_FULL, TP_RATE_LAYERS, TP_RATE_COLOUR } tp_rate;

/* Boards for which rungs can be chosen; ports/app/scene/boards.c has their figures. */
#define TP_BOARD_LIST(X) \
    X(stm32f405) X(stm32f746) X(nrf52840) X(rp2040) X(rp2350) X(esp32s3) X(microbit)

enum {
    TP_BOARD_none,
#define X(name) TP_BOARD_##name,
    TP_BOARD_LIST(X)
#undef X
    TP_BOARDS
};

/* Effects with cheaper rungs: name, words of the rungs from dearest to cheapest, number of
 * the last rung, help.  The row of an effect is quality.NAME.  A frame draws a
 * rung left open (`auto`) as the exact one; `bake` and the host's programs plan first, and
 * name the plan's rungs (quality/plan.h).  quality.mesh takes effect when assets are loaded:
 * the boat's mesh is that of boat.mesh, or the file beside it with -mid or -low before its
 * suffix, if there is one. */
#define TP_EFFECT_LIST(X) \
    X(sky, "auto|exact|fast", 2, "colours of the sky: each pixel, or a lattice") \
    X(haze, "auto|exact|fast", 2, "haze: each pixel, or blocks of pixels") \
    X(layers, "auto|exact|nearest", 2, "textures of water: as water.filter, or nearest") \
    X(distortion, "auto|exact|nearest", 2, "distortion of fast textures: bilinear, or nearest") \
    X(ripple, "auto|exact|nearest", 2, "ripples of fast shading: bilinear, or nearest") \
    X(light, "auto|exact|fast", 2, "fast light: of each column, or of every second") \
    X(foam, "auto|exact|fast|plain", 3, \
      "foam: each pixel, cover at every eighth pixel, or without bubbles") \
    X(objects, "auto|exact|fast", 2, "mirrored objects: each pixel, or blocks of pixels") \
    X(refraction, "auto|exact|fast", 2, "view into water: each pixel, or a lattice") \
    X(caustics, "auto|exact|half|quarter", 3, "cells of the caustics map: all, half, quarter") \
    X(solids, "auto|exact|fast", 2, "light of solids: normal maps, or vertices alone") \
    X(mesh, "auto|full|middle|low", 3, "mesh of the boat: boat.mesh, NAME-mid, NAME-low") \
    X(triangles, "auto|exact|fast", 2, "cells of the water: exact triangles, or planes") \
    X(lines, "auto|all|half", 2, "rows of water: each shaded, or every second one") \
    X(rows, "auto|exact|fast|pairs", 3, \
      "water by lines: each column, without depths, or pairs of columns") \
    X(waves, "auto|exact|fast", 2, "waves of the grid's vertices: in 64 bits, or in 32") \
    X(blending, "auto|exact|rgb565", 2, \
      "means of columns and rows: of colours, or of packed rgb565 pixels") \
    X(geometry, "auto|all|large|largest", 3, \
      "swells that move vertices: all, those above 1/2 px, or above 1 px") \
    X(normals, "auto|exact|fast", 2, "normals of vertices: by the Jacobian, or one bend") \
    X(sine, "auto|exact|fast", 2, "sines of vertices: linear, or the nearest of a table") \
    X(spray, "auto|exact|fast", 2, "spray: light, haze and shape of each speck, or coarse") \
    X(dispersion, "auto|exact|fast|off", 3, \
      "dispersion: a ray for each colour, moved places, or none") \
    X(exposure, "auto|exact|fast", 2, \
      "exposure: exact sky with light beyond white; or without, steps of 1/64")

/* The first rungs of every effect. */
enum { TP_RUNG_AUTO, TP_RUNG_EXACT, TP_RUNG_FAST, TP_RUNG_PAIRS };

/* Quality targets. */
typedef struct {
    tp_fx   error_px;           /* outlines by omitted waves, px */
    tp_fx   error_colour;       /* beyond the exact picture, rms of 255 */
    int32_t visibility, shading, rate;          /* rungs; auto: the plan chooses */
#define X(name, words, last, help) int32_t name;    /* rung of an effect */
    TP_EFFECT_LIST(X)
#undef X
    int32_t board;                      /* TP_BOARD_; rungs are chosen for it */
    tp_fx   frame_ms;                   /* frame time, ms: on the board; without a board,
                                         * the governor's on this machine.  0: a tenth of
                                         * a second; no governor */
} tp_scene_quality;

/* The last rung of quality.dispersion. */
enum { TP_DISPERSION_OFF = TP_RUNG_FAST + 1 };

/* The rungs of quality.mesh. */
enum { TP_MESH_AUTO, TP_MESH_FULL, TP_MESH_MIDDLE, TP_MESH_LOW };

#define TP_NAME_BYTES 128       /* bytes of a name in a scene, terminating zero included */

/* A pool: a grid of cells that simulates waves in shallow water. */
typedef struct {
    int32_t cols, rows;             /* cells, 16..512; cols 0: no pool */
    int32_t cell_bits, boundary;    /* tp_cells, tp_edges */
    int32_t interval;               /* ticks to a step of the cells, 2^n: n = 0, 1, 2 */
    int32_t damping;                /* n: each tick 2^-n of the motion is lost */
    int32_t sponge;                 /* absorbing cells of TP_EDGES_SPONGE */
    tp_fx   courant;                /* Courant number, 0.05 to about 0.49 */
    tp_fx   max_height;             /* m at the full range of 8- and 16-bit cells */
    tp_fx   cell, x, z;             /* side of a cell, m; centre of the pool, m */
    tp_fx   drive_min, drive_max;   /* rms of the heights, m, between which the drive keeps
                                     * them; 0, 0: no drive */
    tp_fx   drive_amplitude;        /* height of one push of the drive, m */
    tp_fx   splash_interval;        /* s between splashes at random places; 0: none */
    tp_fx   splash_height, splash_width;    /* of a splash at a random place, m */
    tp_fx   paddle, paddle_period;  /* wave maker at the north edge: height m, period s */
    char    mask[TP_NAME_BYTES];    /* PNG of inner walls; "": none */
} tp_scene_pool;

/* A texture that drifts over the water. */
typedef struct {
    char    texture[TP_NAME_BYTES];         /* PNG; "": none */
    tp_fx   size;                           /* side that one repeat covers, m */
    tp_fx   drift_x, drift_z;               /* drift, m/s */
} tp_scene_map;

/* One of the water's texture layers.  Each texel is converted in three steps: `saturation`
 * (0: grey) is applied, values above `clamp` are stretched to 0..1, and `colour`
 * multiplies the result.  The first layer is the water's colour; the others are added to
 * it. */
typedef struct {
    tp_scene_map map;
    tp_fx   saturation, clamp;
    int32_t colour;
} tp_scene_layer;

#define TP_LAYERS 3
#define TP_FACES  6             /* faces of a cube map: +x -x +y -y +z -z */

/* Number of words for the settings of the application's own modules, tidepool/modules.h. */
#define TP_OWN_WORDS 32

/* A scene.  Numbers are 16.16 unless a comment says otherwise; angles are degrees; colours
 * are 0x00RRGGBB.  `tidepool params` prints unit, range, default and meaning of each
 * row. */
typedef struct tp_scene {
    char title[TP_NAME_BYTES], description[TP_NAME_BYTES];
    struct {
        tp_fx   x, y, z, heading, pitch, fov, near;
        int32_t follow;                     /* tp_camera_follow */
    } camera;
    struct {
        tp_fx   heading, elevation;
        int32_t colour;
        tp_fx   ambient;
        int32_t model;                      /* tp_light_model */
        tp_fx   turn;                       /* angular speed of the heading, degrees/s */
    } light;
    struct {
        int32_t kind;                       /* tp_sky_kind */
        int32_t horizon, zenith;
        tp_fx   haze;
        tp_fx   sun, stars;                 /* intensity of the disc; density of stars */
        /* PNGs of a cube map's sides, seen from inside.  Four sides stand upright; the
         * lower edge of `up` and the upper edge of `down` join the south side.  Alpha is
         * light beyond white [F8]: 255 stands for 16 whites more; a PNG without alpha has
         * no such light. */
        char    east[TP_NAME_BYTES], west[TP_NAME_BYTES];
        char    up[TP_NAME_BYTES], down[TP_NAME_BYTES];
        char    south[TP_NAME_BYTES], north[TP_NAME_BYTES];
    } sky;
    struct {
        tp_fx   share;                      /* share of the light in alpha; 0: no HDR */
        int32_t exposure;                   /* tp_exposure_mode */
        tp_fx   exposure_factor;            /* fixed; start of automatic exposure */
        tp_fx   rate;                       /* adaptation per tick, 0..1 */
    } hdr;
    struct {
        int32_t colour;                     /* colour of the water, times the first layer */
        int32_t filter;                     /* tp_filter */
        tp_fx   specular, shininess, reflection;
        int32_t fresnel;                    /* tp_fresnel_rule */
        int32_t rough;                      /* light by the variance of slopes not drawn */
        tp_fx   gravity;
        tp_fx   pool_normal_strength;       /* > 0: pools bend normals, not the mesh */
        tp_fx   clarity;                    /* m; 0: the water is opaque */
        int32_t tint;                       /* colour of white light after `clarity` m */
        int32_t deep_colour;                /* colour of bottomless water */
        tp_fx   dispersion;                 /* spread of the refractive index by colour */
        tp_fx   caustics;                   /* strength of light focused on the floor */
        int32_t caustic_cells;              /* cells along the side of the caustics map */
        tp_fx   caustic_size;               /* side of that map without a pool, m */
    } water;
    tp_scene_layer layer[TP_LAYERS];
    struct { tp_scene_map map; tp_fx strength; } distortion;        /* distortion, m */
    struct { tp_scene_map map; tp_fx bump; } ripple;    /* normal map; bump 1: as drawn */
    struct {
        int32_t method, size;               /* tp_mirror_kind, tp_mirror_size */
        int32_t colours;                    /* tp_mirror_colours */
        tp_fx   distortion;
    } mirror;
    struct {                                /* the sides of the pool */
        int32_t kind;                       /* tp_tank_kind */
        int32_t sea;                        /* 1: a calm sea lies around the walls */
        tp_fx   depth, rim, tile;           /* m: depth, rim height, side of a tile */
        char    wall[TP_NAME_BYTES], floor[TP_NAME_BYTES];
        int32_t wall_colour, floor_colour, glass_colour;
        tp_fx   glass;                      /* opacity of the glass colour, 0..1 */
    } tank;
    struct {
        int32_t cells;                      /* cells along the field's side; 0: no foam */
        int32_t slices;                     /* visits of a cell to one of waves and walls */
        tp_fx   cell;                       /* side of a cell, m */
        tp_fx   crest, breaking, shore, wall, hull;     /* strength of each source */
        tp_fx   fade;                       /* lifetime, s */
        tp_scene_map map;                   /* texture; its drift moves the foam itself */
        int32_t colour;
    } foam;
    struct { int32_t count; tp_fx crest, impact, size; } spray;
    struct { int32_t vertices; } grid;         /* 0: by the water, see the row */
    tp_wave wave[TP_WAVES];
    struct {
        tp_fx   depth;                      /* m; 0 and no map: deep water */
        tp_fx   slope, heading;             /* rise, m per m; direction uphill, degrees */
        char    map[TP_NAME_BYTES];         /* PNG of heights, "": none */
        tp_fx   map_x, map_z, map_size, map_low, map_high;
        int32_t colour;                     /* colour of the land, times the texture */
        char    texture[TP_NAME_BYTES];     /* PNG, "": none */
        tp_fx   texture_size;
    } floor;
    struct { tp_fx strength, heading; } wind;       /* rad/m [B10], degrees */
    struct {                                        /* decays per m [B12]; [B20] */
        tp_fx   tilt_decay, widening_decay, flattening_decay, stretch, irregular;
    } surf;
    tp_scene_pool pool, field;              /* a bounded pool; a periodic field */
    tp_scene_drops drops;
    struct {
        char    mesh[TP_NAME_BYTES];        /* OBJ file; "": no boat */
        tp_fx   x, z, heading, scale, lift; /* lift: height above the surface, m */
        tp_fx   length, beam;               /* distances of the hull's sample points, m */
        int32_t mode;                       /* tp_boat_mode */
        tp_fx   smooth;                     /* low-pass time constant of the pose, s */
        tp_fx   draft;                      /* draft of the hull at rest, m */
        tp_fx   drag;                       /* damping of rocking; 1 is critical */
        tp_fx   speed, rudder;              /* cruise: speed m/s, turn rate degrees/s */
        tp_fx   wake;                       /* share of displaced volume in waves, 0..1 */
        int32_t edges;                      /* tp_boat_edges */
    } boat;
    struct { tp_fx scale; } clock;          /* time scale, 1/8..4 [D6] */
    tp_scene_quality quality;
    int32_t own[TP_OWN_WORDS];              /* settings of the application's own modules */
    const struct tp_assets *pictures;       /* of tp_scene_init; NULL: none */
} tp_scene;

typedef enum { TP_BOAT_KINEMATIC, TP_BOAT_DYNAMIC } tp_boat_mode;
typedef enum { TP_EDGES_PLAIN, TP_EDGES_SMOOTH } tp_boat_edges;

typedef enum { TP_FILTER_NEAREST, TP_FILTER_LINEAR } tp_filter;
typedef enum { TP_FOLLOW_NONE, TP_FOLLOW_BOAT } tp_camera_follow;
typedef enum { TP_LIGHT_PHONG, TP_LIGHT_BLINN } tp_light_model;
typedef enum { TP_SKY_GRADIENT, TP_SKY_DAY, TP_SKY_DUSK, TP_SKY_NIGHT, TP_SKY_CUBE
} tp_sky_kind;
typedef enum { TP_EXPOSURE_FIXED, TP_EXPOSURE_AUTO } tp_exposure_mode;
typedef enum { TP_FRESNEL_TABLE, TP_FRESNEL_SCHLICK } tp_fresnel_rule;
typedef enum { TP_MIRROR_NONE, TP_MIRROR_STENCIL, TP_MIRROR_CUBE } tp_mirror_kind;
typedef enum { TP_MIRROR_HALF, TP_MIRROR_QUARTER, TP_MIRROR_FULL } tp_mirror_size;
typedef enum { TP_MIRROR_RGB888, TP_MIRROR_RGB565 } tp_mirror_colours;
typedef enum { TP_TANK_NONE, TP_TANK_STONE, TP_TANK_GLASS } tp_tank_kind;

typedef enum {
    TP_PARAM_FX,                /* 16.16 */
    TP_PARAM_INT,
    TP_PARAM_BOOL,              /* off, on */
    TP_PARAM_COLOUR,            /* #rrggbb */
    TP_PARAM_CHOICE,            /* a word from the list in `unit`: "nearest|linear" */
    TP_PARAM_MESH,              /* file name of an OBJ */
    TP_PARAM_TEXTURE,           /* file name of a PNG */
    TP_PARAM_GREY,              /* file name of a PNG read as one number per pixel */
    TP_PARAM_TEXT
} tp_param_kind;

typedef struct {
    const char *name;           /* "wave0.steepness" */
    const char *unit;           /* "m", "degrees", "" ... */
    const char *help;           /* one line */
    tp_param_kind kind;
    int32_t  low, high, normal; /* range and default, in the format of `kind` */
    const char *text;           /* default of names and texts */
    uint32_t offset;            /* offset of the int32_t or char[] in tp_scene */
} tp_param;

/* Returns all rows, ordered for reading; *count is their number. */
const tp_param *tp_params(uint32_t *count);

/* Writes a row's value as text that tp_scene_set reads back.  The text is terminated and
 * cut to `bytes`.  Returns the length of the whole text. */
size_t tp_param_text(const tp_scene *scene, const tp_param *param, char *text,
                     size_t bytes);

/* Sets the row `name` from its text ("0.35", "on", "#204060", "linear", a file name).
 * White space around the text is ignored.  A bad text changes nothing.
 *  - TP_E_NULL: err->word is the argument; TP_E_NAME: no row has the name err->word
 *  - TP_E_NUMBER, TP_E_CHOICE, ...: err->word is the bad text
 *  - TP_E_RANGE: err->word is the bad text; err->a and err->b are the range, in the format
 *    of the row */
tp_status tp_scene_set(tp_scene *scene, const char *name, const char *value, tp_error *err);

/* Sets a gentle sea of three waves under a sunny sky, with a built-in texture of ripples.
 * The texture, 1364 bytes, is linked only into programs that call this function. */
void tp_scene_init(tp_scene *scene);

/* Sets level water: the default of each row.  Scene files start from these defaults. */
void tp_scene_level(tp_scene *scene);

/* Checks every number of a scene.  After a failure err->word is the name of the first row
 * at fault:
 *  - TP_E_RANGE: a number, choice or colour outside the row's range, err->a..err->b
 *  - TP_E_UNENDED: a name without its terminating zero; TP_E_TEXT: a control character
 *  - TP_E_POOL_...: numbers of a pool that cannot be used together
 * Init functions, byte counts and apply functions call this function; an application need
 * not.  The pictures that a scene names are checked by tp_world_init, not here. */
tp_status tp_scene_check(const tp_scene *scene, tp_error *err);

TP_END_C
#endif
