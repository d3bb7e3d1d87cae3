/* SPDX-License-Identifier: MIT */
/* A program: the list of the modules that an application links.
 *
 * The core reaches every optional part through one constant struct of pointers.  The
 * linker drops all parts that the struct does not name (-ffunction-sections,
 * --gc-sections). tp_program_all names every part.  The program for one scene is written
 * by
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
 * C++ has no initialisers by index: write the program in a C file there.
 *
 * A part that is NULL is missing from the picture, as if the scene did not ask for it; the
 * stats of each frame count it as dropped.  A program may list the modules that it leaves
 * out in tp_program.lacks: init then refuses a scene that has such a module on, and names
 * the module. */
#ifndef TP_MODULES_H
#define TP_MODULES_H
#include <stddef.h>
#include "tidepool/frame.h"
#include "tidepool/scene.h"
#include "tidepool/status.h"

TP_BEGIN_C

/* -- span stages: functions that shade a run of samples; src/shade/shade.h ----------- */

struct tp_shade;
struct tp_run;
typedef void (*tp_stage)(const struct tp_shade *shade, struct tp_run *run);

#define TP_STAGE_LIST(X) \
    X(sky)                  /* sky or other empty view */ \
    X(plain)                /* water without texture */ \
    X(view)                 /* vx vy vz, lv: view vectors in world axes */ \
    X(sky_fast)             /* the gradient for quality.sky=fast; four columns at a time */

#define X(name) void tp_stage_##name(const struct tp_shade *shade, struct tp_run *run);
TP_STAGE_LIST(X)
#undef X

typedef struct {
#define X(name) tp_stage name;
    TP_STAGE_LIST(X)
#undef X
} tp_stages;

#define TP_STAGE(name) .name = tp_stage_##name

/* -- pixel formats ------------------------------------------------------------------- */

/* Converts `count` colours 0x00RRGGBB into pixels of `row`, from the row's pixel x_in_row
 * on.  Other pixels of the row do not change, even if they share a byte.  (x, y) is the
 * first pixel's position in the picture: the dither pattern is fixed to the picture, and
 * tile borders do not show.  Rows of xrgb8888 are aligned to 4 bytes, of rgb565 to 2. */
typedef void (*tp_store)(void *row, int x_in_row, int x, int y, const uint32_t *colours,
                         int count);

#define X(name, word, bits, text) \
    void tp_store_##word(void *row, int x_in_row, int x, int y, \
                         const uint32_t *colours, int count);
TP_FORMAT_LIST(X)
#undef X

/* -- wave models: the water's surface; src/view/wave_models.h ------------------------ */

#define TP_WATER_LIST(X) \
    X(swells)       /* sums of waves; without them the water is level */ \
    X(coastal)      /* coastal water: over a floor or in a wind; needs swells */ \
    X(rings) X(pools) \
    X(samples)      /* swells above a position: for things in the water, eyes near it */ \
    X(points)       /* swells of level water: for projected, flat and walk */ \
    /* sources of foam: over a floor or in a wind, pools' walls, hulls; foam.slices > 1 */ \
    X(foam_coast) X(foam_walls) X(foam_hull) X(foam_slices) \
    X(foam_splashes) X(spray_splashes)      /* of falling drops */ \
    /* pools by bits of a cell, with walls inside or a sponge; splashes of drops and drives */ \
    X(pool_8) X(pool_8_walls) X(pool_8_sponge) X(pool_16) X(pool_16_walls) \
    X(pool_16_sponge) X(pool_32) X(pool_splashes)

#define X(name) extern const struct tp_water_##name tp_water_##name;
TP_WATER_LIST(X)
#undef X

typedef struct {
#define X(name) const struct tp_water_##name *name;
    TP_WATER_LIST(X)
#undef X
} tp_wave_models;

#define TP_WATER(name) .name = &tp_water_##name

/* Replaces tp_water_swells in programs with little RAM.  A world has room for the number
 * of waves at init, 88 bytes each, instead of sixteen; for more waves the world must be
 * made anew. */
extern const struct tp_water_swells tp_water_few_swells;

/* The same for programs with a baked world (tp_program.world): links no code that makes
 * waves, so that only that world can be made; tp_world_apply returns false. */
extern const struct tp_water_swells tp_water_baked_swells;

/* -- water renderers and cheaper drawing; src/frame/frame.h --------------------------- */

#define TP_DRAW_LIST(X) \
    X(cells)            /* triangles of the grid: all, or the cells that rows must clip */ \
    X(exact_triangles)  /* the water's: all, or those that fast triangles cannot draw */ \
    X(culling)          /* waves too faint to be seen are not drawn */ \
    X(row_sides)        /* rows that end in the picture */ \
    X(row_middles)      /* middle lines of rows of wide cells */ \
    X(row_land)         /* rows over a floor, which may rise out of the water */ \
    X(flat_waves)       /* slopes of waves on the level plane of flat */ \
    X(flat_roll)        /* flat for cameras that roll */ \
    X(horizon)          /* colours around the horizon, for quality.haze */ \
    X(tone_rgb565) X(tone_rgb565be)     /* tone mapping and store at once */ \
    /* the makers of tables that are not baked, TP_TABLE_LIST: */ \
    X(shine) X(tones) X(dome) X(light) X(ripple_sums) \
    X(grid_rows)        /* for triangles and rows */ \
    X(baking)           /* fast water's textures, if the assets have none */ \
    X(cube_map)         /* fast water's map of a cube sky */ \
    X(fast_triangles)   /* the water's, for quality.triangles */ \
    X(fast_solids)      /* the boat's, for quality.solids */ \
    X(wide_solids)      /* solids whose textures need perspective */ \
    X(coast_floor)      /* the floor of coastal water, seen through the water */ \
    X(upward_rays)      /* rays in the water that go up: eyes in it, or below its crests */ \
    X(half_lines)       /* water at half the rows, for quality.lines */ \
    X(kept_lines)       /* streamed lines kept in the scratch, for tp_config.kept_bytes */ \
    X(exact_waves)      /* exact vertices of any water, */ \
    X(exact_corners)    /* the same of cells that are clipped, */ \
    X(level_waves)      /* of water without swells */ \
    X(row_variance)     /* slope variance of waves that rows leave out, for water.rough */ \
    X(fast_waves)       /* vertices in 32 bits, for quality.waves */ \
    X(packed_rows)      /* means of rgb565 pixels, for quality.blending */ \
    X(packed_waves)     /* vertices by packed sines, for quality.normals */ \
    X(table_waves)      /* the same by a table of sines, for quality.sine */ \
    X(large_waves)      /* rows without low swells, for quality.geometry */

/* Renderers of the water's surface, see tp_visibility. */
#define TP_METHOD_LIST(X) \
    X(triangles)    /* of the grid; fallback of the other renderers */ \
    X(rows)         /* scanlines of the grid; needs triangles */ \
    X(projected)    /* screen grid: displaced lines over the picture */ \
    X(flat)         /* a level plane with the slopes of its waves */ \
    X(lines)        /* rungs fast and pairs of rows; needs rows */ \
    X(walk)         /* lines over the picture, for level views of swells */

struct tp_water_renderer;
#define X(name) extern const struct tp_water_renderer tp_method_##name;
TP_METHOD_LIST(X)
#undef X

typedef struct {
#define X(name) const struct tp_water_renderer *name;
    TP_METHOD_LIST(X)
#undef X
} tp_water_renderers;

#define TP_METHOD(name) .name = &tp_method_##name

/* Replaces tp_method_triangles in programs with little RAM.  Grid vertices are not stored
 * but computed line by line in tp_frame_begin, and again for each tile that they touch.
 * The picture is the same to the bit.  Two rows of vertices lie in the block, and two in
 * the scratch of tp_frame_scratch_bytes(), which keeps more by tp_config.kept_bytes. */
extern const struct tp_water_renderer tp_method_streamed;

/* Replaces tp_method_walk in programs with little RAM.  Points of lines are not stored but
 * computed in tp_frame_begin, and again for each tile that they touch.  The picture is the
 * same to the bit. */
extern const struct tp_water_renderer tp_method_streamed_walk;

#define X(name) extern const struct tp_draw_##name tp_draw_##name;
TP_DRAW_LIST(X)
#undef X

typedef struct {
#define X(name) const struct tp_draw_##name *name;
    TP_DRAW_LIST(X)
#undef X
} tp_draws;

#define TP_DRAW(name) .name = &tp_draw_##name

/* -- modules; src/world/module.h, src/frame/drawing.h -------------------------------- */

/* Modules that a program brings itself, see ports/README.md.  They come first, which lets
 * mirrors include them. */
#ifdef TP_MORE
#include TP_MORE
#else
#define TP_MORE_LIST(X, N, P)
#endif

/* All modules, in the order of memory, steps and drawing.  N names modules without
 * drawing; P names drawn modules with a cost beyond pixels of water; X names all others. */
#define TP_MODULE_LIST(X, N, P) \
    TP_MORE_LIST(X, N, P) \
    X(bumps)        /* pools that only change normals */ \
    X(base_layer)   /* the water's first texture layer */ \
    X(layers)       /* the other layers, and their distortion */ \
    X(ripple) \
    X(lighting)     /* lit water: with highlights, mirroring or clear */ \
    X(diffuse)      /* diffuse light on any other water */ \
    P(sky_dome)     /* generated skies */ \
    P(sky_cube)     /* cube map skies */ \
    P(stars)        /* stars over a night's dome */ \
    P(haze) \
    P(boat)         /* its mesh; at equal depth the module listed first is visible */ \
    X(outlines)     /* the boat's outlines by coverage */ \
    P(land)         /* a floor that rises out of the water */ \
    P(drops)        /* falling drops, the sphere that they fall from, and rings */ \
    N(coastal)      /* waves over a floor or in a wind; needs models coastal, swells */ \
    N(hull)         /* how a boat sails and floats; follows the rings of drops */ \
    N(wake)         /* wake of a boat in a pool */ \
    N(pokes)        /* splashes in pools, random and by input */ \
    N(paddle)       /* wave maker of pools */ \
    N(main_pool)    /* pool of section [pool]; needs the wave model pools */ \
    N(field)        /* pool of section [field]; needs the wave model pools */ \
    X(reflectance)  /* reflection of the sky, by Fresnel's share */ \
    X(glint) \
    X(underwater)   /* the volume of the water, and the view from in it */ \
    P(tank)         /* a tank's stone walls, and a pool's inner walls */ \
    P(glass)        /* a tank's glass walls */ \
    X(lids)         /* lids of a boat: keep the water out of its hull */ \
    P(caustics)     /* light focused by waves on the floor */ \
    P(mirror)       /* planar reflection of objects, of mirror.size */ \
    X(object_cube)  /* reflection of objects as a small cube map */ \
    X(refraction)   /* objects under clear water */ \
    X(clear_water)  /* the colours seen through the water */ \
    X(foam) \
    X(fast_water)   /* the water by fast stages alone; off if a module above has none */ \
    P(spray) \
    N(meter)        /* automatic exposure */ \
    X(exposure)

/* The stages of each module, in the order of its table. */
#define TP_STAGES_OF_sky_dome(X) \
    X(sky_dome) X(sky_dome_hdr) X(quick_sky_dome)   /* empty view */ \
    X(reflect_dome)                                 /* mirror, rx rz of water */ \
    X(sky_dome_fast)                                /* rays at every 16th column */
#define TP_STAGES_OF_sky_cube(X) \
    X(sky_cube) X(sky_cube_hdr) X(reflect_cube) X(sky_cube_fast)
#define TP_STAGES_OF_stars(X)       X(stars) X(stars_fast)
#define TP_STAGES_OF_haze(X) \
    X(haze) X(haze_dome) X(haze_cube)       /* towards each sky's horizon */ \
    X(haze_fast)                            /* by blocks of 16 columns */
#define TP_STAGES_OF_boat(X) \
    X(solid) X(solid_blinn)         /* Phong or Blinn */ \
    X(solid_fast)           /* by the light of vertices */
#define TP_STAGES_OF_outlines(X)
#define TP_STAGES_OF_land(X)        X(land) X(ground)       /* plain; like the floor */
#define TP_STAGES_OF_drops(X)       X(drop)
#define TP_STAGES_OF_lids(X)
#define TP_STAGES_OF_bumps(X)       X(pool_bump) X(quick_pool_bump) /* sx sz from pools */
#define TP_STAGES_OF_base_layer(X) \
    X(texture) X(texture_tinted) X(texture_linear) X(texture_linear_tinted) \
    X(texture_graded) X(texture_linear_graded)
#define TP_STAGES_OF_layers(X) \
    X(bend)                 /* ls lt, before layers */ \
    X(layers) X(layers_linear)      /* adds the second and third layer */
#define TP_STAGES_OF_ripple(X) \
    X(ripple)               /* sx sz from a normal map, */ \
    X(ripple_gentle)        /* for flat surfaces, */ \
    X(ripple_pool_slopes)   /* added to pools' sx sz */
#define TP_STAGES_OF_lighting(X)    /* colour nv up glint; after view */ \
    X(light) X(light_rippled) X(light_blinn) X(light_blinn_rippled) \
    /* the same with slope variance that samples do not show */ \
    X(light_rough) X(light_rough_rippled) \
    X(light_blinn_rough) X(light_blinn_rough_rippled)
#define TP_STAGES_OF_diffuse(X)     X(diffuse) X(diffuse_rippled)       /* colour */
#define TP_STAGES_OF_reflectance(X) \
    X(mirror_gradient_sky)  /* mixes the reflected gradient sky into colour, alone; */ \
    X(slopes)               /* or, for any sky, in turn: sx sz of smooth water, */ \
    X(reflect_gradient)     /* mirror, rx rz, */ \
    X(fresnel) X(fresnel_hdr)       /* mirror into the colour */
#define TP_STAGES_OF_glint(X)       X(glint)            /* adds the specular */
#define TP_STAGES_OF_fast_water(X) \
    /* in this order: colour and slope x:z from baked textures */ \
    X(quick_mip_spans)      /* spans of one mipmap level, by distance; always first */ \
    X(quick_still) X(quick_bend)        /* positions in layers; */ \
    X(quick_still_thin) X(quick_bend_thin)      /* half rate: even columns only */ \
    X(quick_layers)         /* colour: all layers */ \
    X(quick_layers_thin)    /* half rate, odd columns interpolated */ \
    X(quick_layers_even)    /* even columns only */ \
    X(quick_ripple) X(quick_slopes)     /* slope: with ripples, without */ \
    /* lighting from the slope: light, reflection, glints */ \
    X(quick_gradient) X(quick_gradient_phong) X(quick_gradient_blinn) \
    X(quick_dome_phong) X(quick_dome_blinn) \
    X(quick_cube) X(quick_cube_phong) X(quick_cube_blinn) \
    /* half rate lighting: light and reflection of even columns; */ \
    X(quick_gradient_even) X(quick_dome_even) X(quick_cube_even) \
    X(quick_odd_fill)       /* interpolates odd columns; */ \
    X(quick_glint_phong) X(quick_glint_blinn)   /* interpolates, adds glints */ \
    X(quick_diffuse)        /* light of water that neither glitters nor mirrors */ \
    /* bilinear textures: slope; places, colour, half rate too */ \
    X(quick_ripple_linear) \
    X(quick_bend_linear) X(quick_bend_linear_thin) \
    X(quick_layers_linear) X(quick_layers_linear_thin) \
    /* all light of even columns, glints too; interpolates */ \
    X(quick_gradient_half) X(quick_gradient_phong_half) X(quick_gradient_blinn_half) \
    X(quick_dome_phong_half) X(quick_dome_blinn_half) \
    X(quick_cube_half) X(quick_cube_phong_half) X(quick_cube_blinn_half) \
    /* mirrored objects in place of the reflected sky */ \
    X(quick_over_gradient) X(quick_over_dome) X(quick_over_cube) \
    X(quick_diffuse_half)   /* diffuse light of even columns; interpolates */
#define TP_STAGES_OF_underwater(X) \
    X(underside) X(underside_rippled)       /* the surface from below */ \
    X(deep)                 /* empty view in the water */ \
    X(absorb)               /* absorption in front of things */
#define TP_STAGES_OF_tank(X)        X(wall) X(quick_wall)
#define TP_STAGES_OF_glass(X) \
    X(tank_side)            /* water behind the glass */ \
    X(pane)                 /* the glass, after tone mapping */ \
    X(quick_tank_side) X(quick_pane)    /* fast: every second column; by blocks */
#define TP_STAGES_OF_caustics(X)
#define TP_STAGES_OF_mirror(X)      \
    X(mirrored) X(mirrored_fast)        /* objects, over the sky's mirror; by blocks */ \
    X(quick_objects)        /* mirror: objects alone, by blocks */ \
    /* the three of mirror.colours = rgb565 */ \
    X(mirrored_packed) X(mirrored_packed_fast) X(quick_packed_objects)
#define TP_STAGES_OF_object_cube(X) X(mirrored_object_cube) /* the same from a cube map */
#define TP_STAGES_OF_refraction(X)
#define TP_STAGES_OF_clear_water(X) \
    X(refract) X(refract_rippled) X(refract_dispersed) X(refract_rippled_dispersed) \
    X(quick_refract)        /* fast: the floor; light on the water's own colour */ \
    X(refract_shifted) X(refract_rippled_shifted)   /* with fast dispersion */ \
    X(quick_refract_shifted)
#define TP_STAGES_OF_foam(X) \
    X(foam) X(foam_rippled) X(foam_shiny) X(foam_shiny_rippled)     /* reduces glint */ \
    X(foam_packed)      /* after fast stages */ \
    X(foam_fast) X(foam_fast_shiny)     /* cover at each eighth column */ \
    X(foam_plain) X(foam_plain_shiny)   /* without bubbles */
#define TP_STAGES_OF_spray(X) \
    X(spray) X(spray_blend)         /* colour; streaks */ \
    X(spray_dashes) X(spray_fast)   /* fast: rows of a streak, without samples; streaks */
#define TP_STAGES_OF_exposure(X)    X(expose)

struct tp_module;
struct tp_drawing;
struct tp_cost;
struct tp_module_conditions;

/* A module as a program uses it.  A list of uses ends with { 0 }; the list's order is the
 * order of memory, of steps and of drawing. */
typedef struct tp_use {
    const struct tp_module  *module;    /* its condition and simulation */
    const struct tp_drawing *drawing;   /* NULL: draws nothing */
    const tp_stage          *stage;     /* its stage table; unused entries may be NULL */
    const struct tp_cost    *cost;      /* NULL: not in cost reports */
} tp_use;

#define X(name) void tp_stage_##name(const struct tp_shade *shade, struct tp_run *run);
#define MODULE(name)                                                                     \
    UNSEEN(name)                                                                         \
    extern const struct tp_drawing tp_##name##_drawing;                                  \
    extern const tp_stage tp_##name##_stages[];                                          \
    TP_STAGES_OF_##name(X)
#define UNSEEN(name)                                                                     \
    extern const struct tp_module tp_##name##_module;                                    \
    bool tp_##name##_enabled(const struct tp_module_conditions *conditions);
#define PRICED(name) extern const struct tp_cost tp_##name##_cost; MODULE(name)
TP_MODULE_LIST(MODULE, UNSEEN, PRICED)
#undef PRICED
#undef UNSEEN
#undef MODULE
#undef X

/* The index of each stage in its module's table, for example TP_NTH_texture_linear, and
 * the number of stages, for example TP_COUNT_OF_base_layer. */
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
/* A use with its own stage table, for file scope.  The table lists all entries; a NULL
 * entry must never be needed. */
#define TP_USE_WITH(name, ...) \
    { &tp_##name##_module, &tp_##name##_drawing, (const tp_stage[]){ __VA_ARGS__ }, \
      NULL }
#define TP_USE_UNSEEN(name) { &tp_##name##_module, NULL, NULL, NULL }

/* A module that a program leaves out: only its condition, without state and drawing.  A
 * list of lacks ends with { 0 } and has the order of TP_MODULE_LIST. */
typedef struct tp_lack {
    const char *name;           /* as in TP_MODULE_LIST */
    bool      (*enabled)(const struct tp_module_conditions *conditions);
    uint32_t    above;          /* number of the program's uses that come before it in
                                 * TP_MODULE_LIST: its condition may ask about them only */
} tp_lack;

#define TP_LACK(name, above) { #name, tp_##name##_enabled, above }

/* -- programs ------------------------------------------------------------------------ */

struct tp_scene;
struct tp_assets;
struct tp_steering;

typedef struct tp_program {
    /* tp_scene_check, which every init function calls.  NULL: scenes are trusted, which is
     * right for a baked scene: `tidepool bake` has checked it.  The check links the table
     * of parameters. */
    tp_status (*check)(const struct tp_scene *scene, tp_error *err);
    /* &tp_world_steering, which moves the camera and the clock by the input of a tick.
     * NULL: ticks leave both, which is right for programs without input. */
    const struct tp_steering *steering;
    tp_stages          stage;
    tp_store           store[TP_FORMAT_COUNT];
    tp_wave_models     water;
    tp_draws           draw;
    tp_water_renderers method;
    const tp_use *modules;      /* a list of uses; NULL: none */
    /* tp_lacks_check: refuses a scene that has a module of `lacks` on, see tp_world_init.
     * NULL: a missing module is left out of the picture. */
    tp_status (*refuse)(const struct tp_program *program, const struct tp_scene *scene,
                        const struct tp_assets *assets, tp_error *err);
    const tp_lack *lacks;       /* ends with { 0 }; NULL: none */
    const tp_baked_world *world;    /* NULL: tp_world_init makes it */
} tp_program;

extern const struct tp_steering tp_world_steering;

/* Returns TP_OK, or an error that names the first module of `lacks` that the scene has
 * on. */
tp_status tp_lacks_check(const tp_program *program, const struct tp_scene *scene,
                         const struct tp_assets *assets, tp_error *err);

extern const tp_program tp_program_all; /* every module, renderer and format */

/* The default program, for configs that name none.  The library's own default is
 * tp_program_all; a file written by `tidepool bake --linked` defines another, and nothing
 * else is linked then. */
extern const tp_program *const tp_program_linked;

/* -- rows of parameters -------------------------------------------------------------- */

/* Rows of the table of parameters: name, member of tp_scene, unit, range, default, one
 * line of help.
 *
 *     static const tp_param rows[] = {
 *         TP_ROW_NUMBER("foam.cell", foam.cell, "m", 0.01, 50, 0.5, "side of a cell"),
 *     };
 *
 * The macros take ranges in plain numbers; a row stores them in 16.16.
 *
 * A module that a program brings itself keeps its settings in tp_scene.own, and its rows
 * name the words there.  Scene files, snapshots, tapes and baked scenes then include the
 * settings:
 *
 *     enum { BUOY_ON = BUOY_AT, BUOY_HEIGHT };
 *
 *     TP_ROW_SWITCH("buoy.on", own[BUOY_ON], 0, "a buoy floats on the water"),
 *     TP_ROW_NUMBER("buoy.height", own[BUOY_HEIGHT], "m", 0.1, 20, 2,
 *         "height of its mast"),
 *
 * The header that lists a program's own modules assigns the words (BUOY_AT) and registers
 * the modules by TP_MORE; see ports/README.md. */

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

/* `words` is a list such as "nearest|linear"; the value is a word's index, 0 to `last`. */
#define TP_ROW_CHOICE(name, member, words, last, normal, help) \
    { name, words, help, TP_PARAM_CHOICE, 0, last, normal, "", TP_ROW_AT(member) }

/* The name of a file, or a text; `kind`: MESH, TEXTURE, GREY, TEXT. */
#define TP_ROW_NAME(name, member, kind, help) \
    { name, "", help, TP_PARAM_##kind, 0, 0, 0, "", TP_ROW_AT(member) }

/* A heading of up to 90 whole turns: 16.16 ends before 91.02 turns. */
#define TP_ROW_HEADING(name, member, normal, help) \
    TP_ROW_NUMBER(name, member, "degrees", -32400, 32400, normal, help)

/* Four rows of a texture that drifts over the water, a tp_scene_map. */
#define TP_ROW_MAP(name, part, normal, help) \
    TP_ROW_NAME(name ".texture", part.texture, TEXTURE, help), \
    TP_ROW_NUMBER(name ".size", part.size, "m", 0.1, 1000, normal, \
        "side of the square that one repeat covers"), \
    TP_ROW_NUMBER(name ".drift_x", part.drift_x, "m/s", -20, 20, 0, \
        "drift speed along x"), \
    TP_ROW_NUMBER(name ".drift_z", part.drift_z, "m/s", -20, 20, 0, \
        "drift speed along z")

TP_END_C
#endif
