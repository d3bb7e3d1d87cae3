/* SPDX-License-Identifier: MIT */
/* A program: the list of the modules that an application links.
 *
 * The core reaches everything optional through one constant struct of pointers, so the linker
 * drops what the struct does not name (-ffunction-sections, --gc-sections).  tp_program_all
 * names everything.  The program for one scene is written by
 *
 *     tidepool bake SCENE --size 320x240 --format rgb565 -o scene.c       SCENE_program
 *
 * or by hand, with NULL for the rest:
 *
 *     static const tp_use modules[] = { TP_USE(base_layer), TP_USE(diffuse), { 0 } };
 *     static const tp_program mine = {
 *         .stage = { TP_STAGE(sky), TP_STAGE(plain) },
 *         .store = { [TP_FORMAT_RGB565] = tp_store_rgb565 },
 *         .method = { TP_METHOD(flat) },
 *         .modules = modules,
 *     };
 *     const tp_config config = { .width = 320, .height = 240, .program = &mine };
 *
 * C++ has no initialisers by index: there a program comes from a file of C.
 *
 * What is NULL is left out of the picture, as if the scene did not ask for it; each
 * frame's stats count it as dropped.  A program may name the modules that it leaves out,
 * tp_program.lacks: a scene that has one of them on is then refused by that name. */
#ifndef TP_MODULES_H
#define TP_MODULES_H
#include <stddef.h>
#include "tidepool/frame.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"

TP_BEGIN_C

/* -- stages: what a run of samples goes through; src/shade/shade.h ------------------- */

struct tp_shade;
struct tp_run;
typedef void (*tp_stage)(const struct tp_shade *shade, struct tp_run *run);

#define TP_STAGE_LIST(X) \
    /* colour of the empty view */ \
    X(sky) \
    X(plain)                /* colour of the water without texture */ \
    X(view)                 /* vx vy vz, lv: world axes */

#define X(name) void tp_stage_##name(const struct tp_shade *shade, struct tp_run *run);
TP_STAGE_LIST(X)
#undef X

typedef struct {
#define X(name) tp_stage name;
    TP_STAGE_LIST(X)
#undef X
} tp_stages;

#define TP_STAGE(name) .name = tp_stage_##name

/* -- pixels -------------------------------------------------------------------------- */

/* Converts `count` colours 0x00RRGGBB into `row`, from the row's pixel x_in_row on; other
 * pixels of the row stay as they are, also those that share a byte.  (x, y) is the place
 * in the picture of the first one: the dither is fixed there, so no tiling shows.
 * Rows of xrgb8888 are aligned to 4 bytes, of rgb565 to 2. */
typedef void (*tp_store)(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                         int count);

#define X(name, word, bits, text) \
    void tp_store_##word(void *row, int x_in_row, int x, int y, \
                         const uint32_t *colours, int count);
TP_FORMAT_LIST(X)
#undef X

/* -- models of the water's surface; src/geom/waters.h ------------------------------- */

#define TP_WATER_LIST(X) \
    X(swells)       /* without them the sea is level */ \
    X(sharp)        /* their sharpened crests (wave.power) */ \
    X(lod)          /* fewer lines of their mesh far away; needs swells */ \
    X(ocean)        /* over a floor, or in a wind; needs swells */ \
    X(rings) X(pools)

#define X(name) extern const struct tp_water_##name tp_water_##name;
TP_WATER_LIST(X)
#undef X

typedef struct {
#define X(name) const struct tp_water_##name *name;
    TP_WATER_LIST(X)
#undef X
} tp_waters;

#define TP_WATER(name) .name = &tp_water_##name

/* In place of swells, for little RAM: a world has room for as many as there are at init,
 * 88 bytes each, not for sixteen; with more of them it must be made anew. */
extern const struct tp_water_swells tp_water_few_swells;

/* -- parts of a frame; src/frame/parts.h -------------------------------------------- */

#define TP_DRAW_LIST(X) X(rungs) /* the plan */

/* Methods of finding the water in the picture, tp_visibility. */
#define TP_METHOD_LIST(X) \
    X(triangles)    /* of the grid; the others fall back on it */ \
    X(rows)         /* the grid's lines; needs triangles */ \
    X(projected)    /* displaced lines over the picture */ \
    X(flat)         /* level water, with the slopes of its waves */

struct tp_method;
#define X(name) extern const struct tp_method tp_method_##name;
TP_METHOD_LIST(X)
#undef X

typedef struct {
#define X(name) const struct tp_method *name;
    TP_METHOD_LIST(X)
#undef X
} tp_methods;

#define TP_METHOD(name) .name = &tp_method_##name

/* In place of triangles, for little RAM: crossings of the water's grid are not stored but
 * evaluated line by line in tp_frame_begin, and again for each tile that they touch.  The
 * same bits are drawn, by rows too, but as triangles where the camera looks along x.  Two
 * lines of crossings, 32 bytes for each of grid.cols, lie in the block and two in the
 * scratch of tp_frame_scratch_bytes(); only as many waves as there are at init have room.
 * An ocean, over a floor, is stored all the same. */
extern const struct tp_method tp_method_streamed;

#define X(name) extern const struct tp_draw_##name tp_draw_##name;
TP_DRAW_LIST(X)
#undef X

typedef struct {
#define X(name) const struct tp_draw_##name *name;
    TP_DRAW_LIST(X)
#undef X
} tp_draws;

#define TP_DRAW(name) .name = &tp_draw_##name

/* -- modules; src/scene/module.h, src/frame/drawing.h ------------------------------- */

/* Modules that a program brings itself, see ports/README.md; they come first, so that
 * mirrors know of them. */
#ifdef TP_MORE
#include TP_MORE
#else
#define TP_MORE_LIST(X, N, P)
#endif

/* Nothing is drawn of the ones that are named by N; the ones that are named by P cost more
 * than pixels of water. */
#define TP_MODULE_LIST(X, N, P) \
    TP_MORE_LIST(X, N, P) \
    X(bumps)        /* of pools that bend the light only */ \
    X(base_layer)   /* the water's first picture */ \
    X(layers)       /* the others, and their distortion */ \
    X(ripple) \
    X(lighting)     /* of water that shines, mirrors or is clear */ \
    X(diffuse)      /* of any other */ \
    P(sky_dome)     /* skies beside the gradient: generated ones, */ \
    P(sky_cube)     /* and six pictures */ \
    P(stars)        /* added to a night's dome */ \
    P(haze) \
    P(boat)         /* its mesh: of things as far away the first one is seen */ \
    P(land)         /* a floor that rises out of the water */ \
    P(drops)        /* in the air, the sphere that they fall from, and rings */ \
    N(coastal)      /* waves over a floor or in a wind; water.ocean, water.swells */ \
    N(hull)         /* how a boat sails and floats; after the rings of drops */ \
    N(wake)         /* of a boat in a pool */ \
    N(pokes)        /* of pools, by chance and by input */ \
    N(paddle)       /* waves made in pools */ \
    N(main_pool)    /* [pool]; and water.pools */ \
    N(field)        /* [field]; and water.pools */ \
    X(reflectance)  /* the sky in the water, by Fresnel's share */ \
    X(glint) \
    X(underwater)   /* the inside of the water, and the view of an eye in it */ \
    P(tank)         /* a tank's stone, and a pool's inner walls */ \
    P(glass)        /* a tank's walls of glass */ \
    X(lids)         /* of a boat: they keep water out of its hull */ \
    P(caustics)     /* light that waves gather on the floor */ \
    P(mirror)       /* of objects, a picture of half the size */ \
    X(object_cube)  /* the same as a small cube map */ \
    X(refraction)   /* objects under clear water */ \
    X(clear_water)  /* what is seen through the water */ \
    X(foam) \
    X(fast_water)   /* the water by fast stages alone; refused below what has none */ \
    X(spray) \
    N(meter)        /* exposure by itself */ \
    X(exposure)

/* The stages of each module, in the order of its table. */
#define TP_STAGES_OF_sky_dome(X) \
    X(sky_dome) X(sky_dome_hdr) X(quick_sky_dome)   /* colour of the empty view; */ \
    X(reflect_dome)                                 /* mirror, rx rz of water */
#define TP_STAGES_OF_sky_cube(X)    X(sky_cube) X(sky_cube_hdr) X(reflect_cube)
#define TP_STAGES_OF_stars(X)       X(stars)
#define TP_STAGES_OF_haze(X) \
    X(haze) X(haze_dome) X(haze_cube)       /* towards the horizon of each kind of sky */
#define TP_STAGES_OF_boat(X)        X(solid) X(solid_blinn)     /* all of Phong */
#define TP_STAGES_OF_land(X)        X(land) X(ground)       /* plain; like the floor */
#define TP_STAGES_OF_drops(X)       X(drop)
#define TP_STAGES_OF_lids(X)
#define TP_STAGES_OF_bumps(X)       X(pool_bump)        /* sx sz: pools' */
#define TP_STAGES_OF_base_layer(X) \
    X(texture) X(texture_tinted) X(texture_linear) X(texture_linear_tinted) \
    X(texture_graded) X(texture_linear_graded)
#define TP_STAGES_OF_layers(X) \
    X(bend)                 /* ls lt, before layers */ \
    X(layers) X(layers_linear)      /* adds the second and third */
#define TP_STAGES_OF_ripple(X) \
    X(ripple)               /* sx sz: by a normal map, */ \
    X(ripple_gentle)        /* of flat surfaces, */ \
    X(ripple_over)          /* over pools' sx sz */
#define TP_STAGES_OF_lighting(X)    /* colour nv up glint, of a view */ \
    X(light) X(light_rippled) X(light_blinn) X(light_blinn_rippled)
#define TP_STAGES_OF_diffuse(X)     X(diffuse) X(diffuse_rippled)       /* colour */
#define TP_STAGES_OF_reflectance(X) \
    X(mirror)               /* sky by Fresnel's share; or in parts, for other skies, */ \
    X(slopes)               /* objects and light beyond white: sx sz of smooth water, */ \
    X(reflect_gradient)     /* mirror, rx rz, */ \
    X(fresnel) X(fresnel_hdr)       /* mirror into the colour */
#define TP_STAGES_OF_glint(X)       X(glint)            /* adds the specular */
#define TP_STAGES_OF_fast_water(X) \
    /* in this order: colour and slope x:z by prepared pictures */ \
    X(quick_far)            /* how far away; always the first */ \
    X(quick_still) X(quick_bend)        /* places of layers; */ \
    X(quick_still_thin) X(quick_bend_thin)      /* of every second column alone */ \
    X(quick_layers)         /* colour: all layers */ \
    X(quick_layers_thin)    /* of those columns, and the ones between */ \
    X(quick_layers_even)    /* of those columns alone */ \
    X(quick_ripple) X(quick_slopes)     /* slope: with ripples, and without */ \
    /* colour of slope: light, what is mirrored, and glints */ \
    X(quick_gradient) X(quick_gradient_phong) X(quick_gradient_blinn) \
    X(quick_dome_phong) X(quick_dome_blinn) \
    X(quick_cube) X(quick_cube_phong) X(quick_cube_blinn) \
    /* the same in parts: light and mirror of every second column; */ \
    X(quick_gradient_even) X(quick_dome_even) X(quick_cube_even) \
    X(quick_between)        /* the ones between; */ \
    X(quick_glint_phong) X(quick_glint_blinn)   /* those, and glints of all */
#define TP_STAGES_OF_underwater(X) \
    X(below) X(below_rippled)       /* the surface from below */ \
    X(deep)                 /* empty view in the water */ \
    X(absorb)               /* water before what is there */
#define TP_STAGES_OF_tank(X)        X(wall)
#define TP_STAGES_OF_glass(X) \
    X(side)                 /* water behind the glass */ \
    X(pane)                 /* the glass, over exposed colours */
#define TP_STAGES_OF_caustics(X)
#define TP_STAGES_OF_mirror(X)      X(mirrored)         /* objects over the sky's mirror */
#define TP_STAGES_OF_object_cube(X) X(mirrored_cube)
#define TP_STAGES_OF_refraction(X)
#define TP_STAGES_OF_clear_water(X) \
    X(behind) X(behind_rippled) X(behind_dispersed) X(behind_rippled_dispersed)
#define TP_STAGES_OF_foam(X) \
    X(foam) X(foam_rippled) X(foam_shiny) X(foam_shiny_rippled)     /* less glint */
#define TP_STAGES_OF_spray(X)       X(spray)            /* colour of specks */
#define TP_STAGES_OF_exposure(X)    X(expose)

struct tp_module;
struct tp_drawing;
struct tp_cost;
struct tp_want;

/* A module as a program uses it.  A list of uses ends with { 0 }; its order is the order of
 * memory, of steps and of drawing. */
typedef struct tp_use {
    const struct tp_module  *module;    /* what it is, and how it moves */
    const struct tp_drawing *drawing;   /* NULL: nobody draws it */
    const tp_stage          *stage;     /* its table; NULL in it: never asked for */
    const struct tp_cost    *cost;      /* for reports of the plan; NULL: none are made, or
                                         * it costs pixels of water alone */
} tp_use;

#define X(name) void tp_stage_##name(const struct tp_shade *shade, struct tp_run *run);
#define MODULE(name)                                                                     \
    UNSEEN(name)                                                                         \
    extern const struct tp_drawing tp_##name##_drawing;                                  \
    extern const tp_stage tp_##name##_stages[];                                          \
    TP_STAGES_OF_##name(X)
#define UNSEEN(name)                                                                     \
    extern const struct tp_module tp_##name##_module;                                    \
    bool tp_##name##_enabled(const struct tp_want *want);
#define PRICED(name) extern const struct tp_cost tp_##name##_cost; MODULE(name)
TP_MODULE_LIST(MODULE, UNSEEN, PRICED)
#undef PRICED
#undef UNSEEN
#undef MODULE
#undef X

/* The place of each stage in its module's table, TP_NTH_texture_linear, and the number of
 * stages, TP_COUNT_OF_base_layer. */
#define X(name) TP_NTH_##name,
#define MODULE(name) enum { TP_STAGES_OF_##name(X) TP_COUNT_OF_##name };
#define UNSEEN(name)
TP_MODULE_LIST(MODULE, UNSEEN, MODULE)
#undef UNSEEN
#undef MODULE
#undef X

#define TP_USE(name) \
    { &tp_##name##_module, &tp_##name##_drawing, tp_##name##_stages, NULL }
#define TP_USE_PRICED(name) \
    { &tp_##name##_module, &tp_##name##_drawing, tp_##name##_stages, &tp_##name##_cost }
/* At file scope: with a table of its own, all entries of it; NULL is never asked for. */
#define TP_USE_WITH(name, ...) \
    { &tp_##name##_module, &tp_##name##_drawing, (const tp_stage[]){ __VA_ARGS__ }, \
      NULL }
#define TP_USE_UNSEEN(name) { &tp_##name##_module, NULL, NULL, NULL }

/* A module that a program leaves out: its condition without its state and drawing.  A list
 * of lacks ends with { 0 } and has the order of TP_MODULE_LIST. */
typedef struct tp_lack {
    const char *name; /* as in TP_MODULE_LIST */
    bool (*enabled)(const struct tp_want *want);
    uint32_t above; /* uses of the program's list that come before it in
                                 * TP_MODULE_LIST: conditions may ask about those alone */
} tp_lack;

#define TP_LACK(name, above)                                                             \
    {                                                                                    \
#name, tp_##name##_enabled, above                                                \
    }

/* ------------------------------------------------------------------------------------ */

struct tp_scene;
struct tp_assets;

typedef struct tp_program {
    /* tp_scene_check, which every init asks.  NULL: scenes are trusted, as a baked one may
     * be: `tidepool bake` has checked it.  The check links the table of parameters. */
    tp_status (*check)(const struct tp_scene *scene, tp_error *err);
    tp_stages stage;
    tp_store  store[TP_FORMAT_COUNT];
    tp_waters water;
    tp_draws  draw;
    tp_methods method;
    const tp_use *modules;      /* a list of uses; NULL: none */
    /* tp_lacks_check: a scene that has one of `lacks` on is refused, see tp_world_init.
     * NULL: what is missing is left out of the picture. */
    tp_status (*refuse)(const struct tp_program *program, const struct tp_scene *scene,
                        const struct tp_assets *assets, tp_error *err);
    const tp_lack *lacks;       /* NULL: none */
} tp_program;

tp_status tp_lacks_check(const tp_program *program, const struct tp_scene *scene,
                         const struct tp_assets *assets, tp_error *err);

extern const tp_program tp_program_all; /* everything there is */

/* The program of who names none.  The library's own is tp_program_all; a file that
 * `tidepool bake --linked` wrote defines it instead, and then nothing else is linked. */
extern const tp_program *const tp_program_linked;

/* -- rows of parameters ------------------------------------------------------------------ */

/* Rows of the table of parameters, as a table writes them: a name, where its value lies in
 * tp_scene, a unit, the range, the default, one line of help.
 *
 *     static const tp_param rows[] = {
 *         TP_ROW_NUMBER("foam.cell", foam.cell, "m", 0.01, 50, 0.5, "side of such a cell"),
 *     };
 *
 * Numbers of the range are as a person writes them; a row has them in 16.16.
 *
 * A module that a program brings itself keeps its settings in tp_scene.own, and its rows
 * name their words there; scene files, snapshots, tapes and baked scenes know them then:
 *
 *     enum { BUOY_ON = BUOY_AT, BUOY_HEIGHT };
 *     TP_ROW_SWITCH("buoy.on", own[BUOY_ON], 0, "a buoy floats on the water"),
 *     TP_ROW_NUMBER("buoy.height", own[BUOY_HEIGHT], "m", 0.1, 20, 2, "of its mast"),
 *
 * The header that lists a program's own modules deals the words out (BUOY_AT), and tells
 * the library of them by TP_MORE; see ports/README.md. */

#define TP_ROW_AT(member) (uint32_t)offsetof(tp_scene, member)

#define TP_ROW_NUMBER(name, member, unit, low, high, normal, help) \
    { name, unit, help, TP_PARAM_FX, TP_FX(low), TP_FX(high), TP_FX(normal), "", \
      TP_ROW_AT(member) }
#define TP_ROW_COUNT(name, member, unit, low, high, normal, help) \
    { name, unit, help, TP_PARAM_INT, low, high, normal, "", TP_ROW_AT(member) }
#define TP_ROW_SWITCH(name, member, normal, help) \
    { name, "", help, TP_PARAM_BOOL, 0, 1, normal, "", TP_ROW_AT(member) }
#define TP_ROW_COLOUR(name, member, normal, help) \
    { name, "", help, TP_PARAM_COLOUR, 0, 0xffffff, normal, "", TP_ROW_AT(member) }

/* `words`: "nearest|linear"; the value is a word's place, up to `last`. */
#define TP_ROW_CHOICE(name, member, words, last, normal, help) \
    { name, words, help, TP_PARAM_CHOICE, 0, last, normal, "", TP_ROW_AT(member) }

/* A file's name or a text; `kind`: MESH, TEXTURE, GREY, TEXT. */
#define TP_ROW_NAME(name, member, kind, help) \
    { name, "", help, TP_PARAM_##kind, 0, 0, 0, "", TP_ROW_AT(member) }

/* 90 whole turns: 16.16 ends before 91.02. */
#define TP_ROW_HEADING(name, member, normal, help) \
    TP_ROW_NUMBER(name, member, "degrees", -32400, 32400, normal, help)

/* Four rows of a picture that drifts over the water, a tp_scene_map. */
#define TP_ROW_MAP(name, part, normal, help) \
    TP_ROW_NAME(name ".texture", part.texture, TEXTURE, help), \
    TP_ROW_NUMBER(name ".size", part.size, "m", 0.1, 1000, normal, \
        "side of the square that one repeat covers"), \
    TP_ROW_NUMBER(name ".drift_x", part.drift_x, "m/s", -20, 20, 0, "along x"), \
    TP_ROW_NUMBER(name ".drift_z", part.drift_z, "m/s", -20, 20, 0, "along z")

TP_END_C
#endif
