/* SPDX-License-Identifier: MIT */
/* A scene: plain data that a person may change, each number a row of one table.
 *
 * The scene holds no pointer and may lie in ROM.  What it names (mesh, textures) the
 * port loads and hands to the frame.  The table gives INI files, the command line, the
 * preview's panel and the manual their names, units, ranges and defaults. */
#ifndef TP_SCENE_H
#define TP_SCENE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/asset.h"
#include "tidepool/fx.h"
#include "tidepool/status.h"
#include "tidepool/wave.h"

#define TP_NAME_BYTES 128       /* of a name in a scene, its end included */

/* Numbers are 16.16 unless said; angles are degrees; colours 0x00RRGGBB. */
typedef struct {
    char title[TP_NAME_BYTES];
    struct { tp_fx x, y, z, heading, pitch, fov, near; } camera;
    struct { tp_fx heading, elevation; int32_t colour; tp_fx ambient; } light;
    struct { int32_t horizon, zenith; tp_fx haze; } sky;
    struct {
        int32_t colour;                     /* multiplies the texture */
        char    texture[TP_NAME_BYTES];     /* "": none */
        tp_fx   texture_size;               /* m that one repeat covers */
        tp_fx   drift_x, drift_z;           /* m/s of the texture */
        int32_t filter;                     /* tp_filter, int */
        char    normal[TP_NAME_BYTES];      /* normal map, "": none */
        tp_fx   normal_size, normal_bump;   /* m, 1 = as the map says */
        tp_fx   specular, shininess, reflection;
        tp_fx   gravity;
    } water;
    struct { int32_t cols, rows; tp_fx cell, reach; int32_t follow; } grid;
    tp_wave wave[TP_WAVES];
    struct {
        char  mesh[TP_NAME_BYTES];          /* OBJ file, "": no boat */
        tp_fx x, z, heading, scale, lift;   /* lift: m above the surface */
        tp_fx length, beam;                 /* of the hull points in the water, m */
    } boat;
} tp_scene;

typedef enum { TP_FILTER_NEAREST, TP_FILTER_LINEAR } tp_filter;

typedef enum {
    TP_PARAM_FX,                /* 16.16 */
    TP_PARAM_INT,
    TP_PARAM_BOOL,              /* off, on */
    TP_PARAM_COLOUR,            /* #rrggbb */
    TP_PARAM_CHOICE,            /* a word of `unit`, which lists them: "nearest|linear" */
    TP_PARAM_MESH,              /* file name of an OBJ */
    TP_PARAM_TEXTURE,           /* file name of a PNG */
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

/* Every row's default. */
void tp_scene_default(tp_scene *scene);

/* -- the world: a scene as it moves ---------------------------------------------- */

/* What the port feeds in at each tick: the camera's own movement. */
typedef struct {
    tp_fx   ahead, aside, up;   /* m, in the camera's horizontal frame */
    int32_t turn, tilt;         /* tp_turn steps of heading and pitch, signed */
} tp_input;

/* Plain data without pointers: copying it is a snapshot. */
typedef struct {
    uint64_t tick;
    tp_vec3  eye;
    tp_turn  heading, pitch;
    tp_sea   sea;
    tp_turn  phases[TP_WAVES];  /* of this tick */
    tp_vec3  boat;              /* the mesh's origin; 0 in scenes that name no mesh */
    tp_rotation boat_turn;      /* world to mesh */
} tp_world;

/* The world of `scene` at tick 0. */
void tp_world_init(tp_world *world, const tp_scene *scene);

/* One tick further; `input` may be NULL.  The scene's numbers may have changed since
 * the last tick: call tp_world_refresh after changing a wave, gravity or the boat. */
void tp_world_step(tp_world *world, const tp_scene *scene, const tp_input *input);

/* The sea and boat of the scene as it is now, at the same tick. */
void tp_world_refresh(tp_world *world, const tp_scene *scene);
#endif
