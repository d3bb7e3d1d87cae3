/* SPDX-License-Identifier: MIT */
/*
 * A module: a feature of a scene behind a common interface.  This header has the
 * simulation part: the condition for the feature, its state, its step. frame/drawing.h
 * has the drawing part.
 *
 * A program lists its modules (tp_use, tidepool/modules.h).  The order of the list is the
 * order of memory, of steps and of drawing.  A world keeps the state of each module as a
 * chunk: an id and a length, then the bytes of the state.  A copy of the block therefore
 * describes its own contents.
 *
 * Further below: the variable part of a world, the states that only some scenes need,
 * after the head in the same block; the water of a world; the scenes that a program
 * accepts.
 */
#ifndef TP_WORLD_MODULE_H
#define TP_WORLD_MODULE_H
#include "base/base.h"
#include "tidepool/modules.h"
#include "view/grid.h"
#include "world/world.h"

static inline const tp_program *tp_program_or_linked(const tp_program *program)
{
    return program ? program : tp_program_linked;
}

/* Range of drops and rings: largest distance of their start from the origin along each
 * axis, 8000 m for the sphere plus 1000 m of scatter. */
#define TP_DROP_FAR (9000 * TP_FX_ONE)

/* Effect of an impact on the water; the caller passes the impact to rings or to a pool. */
typedef struct {
    tp_fx   x, z;
    int64_t time;           /* time in ticks x 65536, within the step */
    tp_fx   amplitude;      /* A0 [D4], m, at most L / 14 [B14] */
    int32_t uncapped_q24;   /* A0 before the limit, Q24, saturated; up to a few LSB high */
    tp_fx   length;         /* L = 8 radii, m */
    tp_fx   lost;           /* lost energy [D3], J, saturated */
} tp_impact;

/* Returns `assets`, or the scene's own textures if `assets` is NULL. */
static inline const tp_assets *tp_assets_or_scene_default(const tp_scene *scene,
                                                          const tp_assets *assets)
{
    return assets ? assets : scene->pictures;
}

#define TP_MODULE_ID(a, b, c, d) \
    ((uint32_t)(a) << 24 | (uint32_t)(b) << 16 | (uint32_t)(c) << 8 | (uint32_t)(d))

/* Bits of tp_module.is. */
enum {
    TP_MODULE_EXACT  = 1,       /* water stage without a fast form */
    TP_MODULE_SOLID  = 2,       /* draws floating or flying objects, to be reflected */
    TP_MODULE_WALLS  = 4,       /* draws the tank or the stone walls in the pool */
    TP_MODULE_UNDERWATER = 8,   /* models the volume of the water */
    TP_MODULE_FAST   = 16,      /* draws the water with fast stages only */
    TP_MODULE_SLOPES = 32,      /* draws pools as slopes on flat water */
    TP_MODULE_LIGHT  = 64,      /* adds view-dependent light to the water */
    TP_MODULE_DOME   = 128,     /* draws the sky with tp_dome */
    TP_MODULE_CUBE   = 256,     /* draws the sky with tp_cube; its trait: cost of
                                 * reflection */
    TP_MODULE_STARS  = 512,     /* adds stars to the sky */
    TP_MODULE_PANES  = 1024,    /* has stages that run after the tone mapping */
    TP_MODULE_COASTAL = 2048,   /* waves depend on a floor or on wind */
    TP_MODULE_MIRROR = 4096,    /* planar reflection of solid objects */
    TP_MODULE_OUTLINES = 8192,  /* outlines of meshes by coverage */
    TP_MODULE_SAMPLES = 32768,  /* asks for the water above positions, by tp_water_samples */
    TP_MODULE_CLEAR  = 16384    /* shows the floor through the water; its fast stage lights
                                 * the water */
};

/* The kind of samples that a module draws, in the upper bits of tp_module.is. */
#define TP_MODULE_KIND_SHIFT  24
#define TP_MODULE_DRAWS(kind) ((uint32_t)(TP_SAMPLE_##kind) << TP_MODULE_KIND_SHIFT)

#define TP_MODULES 40           /* most modules in a program's list */

/* The conditions that decide if a module is on. */
typedef struct tp_module_conditions {
    const tp_scene  *scene;
    const tp_assets *assets;    /* NULL: the scene names no file */
    const tp_wave_models *water;     /* wave models of the program; NULL: all models */
    uint32_t width, height;     /* size of the picture in px; 0 for a world */
    uint32_t shadings;          /* bits of tp_shading: shading rungs that a frame may use */
    bool     streams;           /* grid vertices are streamed, not stored */
    uint32_t above;             /* bits of tp_module.is of earlier enabled modules */
} tp_module_conditions;

/* True if the scene names a boat whose outlines are drawn by coverage. */
static inline bool tp_has_outlines(const tp_scene *scene)
{
    return scene->boat.edges == TP_EDGES_SMOOTH && scene->boat.mesh[0];
}

/* Returns how often the picture's sides are halved for the planar map of mirrored objects.
 * The projection of a small picture can be halved only once. */
static inline uint32_t tp_mirror_halvings(const tp_scene *scene, uint32_t width,
                                          uint32_t height)
{
    switch (scene->mirror.size) {
    case TP_MIRROR_FULL:    return 0;
    case TP_MIRROR_QUARTER: return width >= 64 && height >= 64 ? 2 : 1;
    default:                return 1;
    }
}

/* Returns the conditions for a world. */
static inline tp_module_conditions tp_world_module_conditions(const tp_program *program,
                                                              const tp_scene *scene,
                                                              const tp_assets *assets)
{
    return (tp_module_conditions){ .scene = scene,
                                   .assets = tp_assets_or_scene_default(scene, assets),
                                   .water = &program->water };
}

/* Traits of water pixels; each trait has a cost. plain: every pixel; diffuse: light that
 * does not depend on the view; look: view direction, shared by gloss, mirror and depth;
 * rough: light by the variance of slopes that are not drawn;
 * objects: reflected objects; lined: a layer with linear texture filtering; bed, chart,
 * tank: a floor that is a plane, a height map, a box. */
#define TP_TRAITS(X) \
    X(plain) X(texture) X(linear) X(bend) X(layer) X(lined) X(ripple) X(bump) \
    X(diffuse) X(look) X(rough) X(mirror) \
    X(glint) X(haze) X(dome) X(cube) X(objects) X(behind) X(bed) \
    X(chart) X(tank) X(caustic) X(dispersion) X(foam) X(expose)

enum {
#define X(name) TP_TRAIT_##name,
    TP_TRAITS(X)
#undef X
    TP_TRAIT_COUNT
};

/* Only name, id and enabled are mandatory; all other members may be NULL. */
typedef struct tp_module {
    const char *name;
    uint32_t    id;             /* unique TP_MODULE_ID of four letters */
    uint32_t    is;             /* bits TP_MODULE_EXACT ... */
    uint32_t    trait;          /* cost of its water stage, a TP_TRAIT_; 0: none */

    /* True if the feature is on.  Layout, step and drawing ask this function only, as
     * does the check of a program without the module (tp_lack). */
    bool (*enabled)(const tp_module_conditions *conditions);

    /* Sets the number of times that a pixel of water pays each trait's cost, if `trait`
     * does not describe the cost.  Used by the cost estimate.  The table is zeroed before
     * the call. */
    void (*count)(const tp_module_conditions *conditions, uint8_t trait[TP_TRAIT_COUNT]);

    /* Refuses combinations that the parameter table cannot express; err->word is the
     * parameter at fault. */
    tp_status (*check)(const tp_module_conditions *conditions, tp_error *err);

    /* Returns the size of the state in bytes; the state is aligned to 8.  NULL: the
     * module has no state in a world.  The state is zeroed before `init`. */
    size_t (*bytes)(const tp_module_conditions *conditions);
    tp_status (*init)(void *mine, tp_world *world, const tp_module_conditions *conditions,
                      tp_error *err);

    /* Called after numbers of the scene have changed.  `fits` changes nothing.  If all
     * states fit, each state is refreshed.  False: the world must be initialised again. */
    bool (*fits)(const void *mine, const tp_scene *scene);
    bool (*refresh)(void *mine, tp_world *world, const tp_module_conditions *conditions);

    /* Puts floating objects on the water, after all states have been initialised or
     * refreshed. */
    void (*settle)(void *mine, const tp_program *program, tp_world *world,
                   const tp_scene *scene);

    /* Advances by one tick, after the earlier modules in the list.  A module without
     * `bytes` steps in every world; its `mine` is NULL.  `input` NULL: all inputs are 0. */
    void (*step)(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input);

    /* Adds the module's heights to the water surface of this tick. */
    void (*surface)(const void *mine, tp_surface *surface);

    /* Adds the module's waves to the detail that the water's grid must hold, from numbers of
     * the scene alone.  `flat`: waves of pools bend the light and leave the grid level. */
    void (*detail)(const tp_scene *scene, bool flat, tp_water_detail *detail);

    /* Called when an object strikes the water at height `level`.  True: the module moves
     * the water. */
    bool (*hit)(void *mine, const tp_program *program, const tp_scene *scene,
                const tp_impact *impact, tp_fx level);

    /* Moves the camera with the module's body, `lag` before the tick. */
    void (*carry)(const tp_world *world, tp_fx lag, tp_camera *camera);

    /* True if a state from outside the program can be stepped and drawn.  `fresh` is a
     * state of the same scene and length as `init` leaves a state.  The head of `world`
     * is already checked. */
    bool (*is_valid)(const void *mine, const void *fresh, const tp_world *world);
} tp_module;

/* True if the module is on. Then adds its bits to conditions->above for the later
 * modules. */
static inline bool tp_module_ask_condition(const tp_module *module,
                                         tp_module_conditions *conditions)
{
    const bool on = module->enabled(conditions);

    conditions->above |= on ? module->is : 0;
    return on;
}

/* True if an enabled module has at least one of the bits `flags` of tp_module.is.  Other
 * modules are not asked, so conditions->above stays as given. */
bool tp_modules_is_any_active(const tp_use *modules,
                              const tp_module_conditions *conditions, uint32_t flags);

/* -- chunks of a world --------------------------------------------------------------- */

/* Returns the state of a module, or NULL if the world has none. */
void *tp_world_module_state(const tp_world *world, uint32_t id);

/* Returns the length of a state in bytes, a multiple of 8. */
size_t tp_module_state_bytes(const void *part);

/* Checks all enabled modules and lays out their chunks. *modules_offset: offset of the
 * first chunk, or 0 without chunks.  `conditions.above` must be 0. */
tp_status tp_modules_check_and_measure(const tp_program *program, tp_arena *arena,
                                       tp_module_conditions conditions,
                                       uint32_t *modules_offset, tp_error *err);

/* Writes the chunk headers, then the initial states; the block is zeroed by the caller. */
tp_status tp_modules_init(const tp_program *program, tp_world *world,
                          tp_module_conditions conditions, tp_error *err);

/* True if the chunks match the scene's current modules and their states fit the scene. */
bool tp_modules_fit(const tp_program *program, const tp_world *world,
                    tp_module_conditions conditions);
bool tp_modules_refresh(const tp_program *program, tp_world *world,
                        tp_module_conditions conditions);

void tp_modules_place_floating(const tp_program *program, tp_world *world,
                               const tp_scene *scene);
void tp_modules_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                     const tp_input *input);
void tp_modules_add_surface(const tp_program *program, const tp_world *world,
                            tp_surface *surface);

/* True if at least one module moves the water. */
bool tp_modules_handle_impact(const tp_program *program, tp_world *world,
                              const tp_scene *scene, const tp_impact *impact,
                              tp_fx level);

/* Checks the modules' chunks of `world`, a block from outside the program, against
 * `fresh`, a new world of the same length.  Returns the name of the first module whose
 * chunk has another id or length or an invalid state; NULL if all chunks are valid. */
const char *tp_modules_find_invalid(const tp_program *program, const tp_world *world,
                                    const tp_world *fresh);

/* -- the water of a world ------------------------------------------------------------ */

/* Returns the coastal water of a world, or NULL. */
const tp_coastal_water *tp_world_coastal(const tp_world *world);

/* State of coastal water whose tables are baked: where they lie.  The pointer stays valid in
 * copies of the world, in this program. */
typedef struct {
    const tp_coastal_water *tables;
} tp_coastal_baked;

/* Returns the tables of a state of coastal water: its own, or the baked ones. */
const tp_coastal_water *tp_coastal_state_tables(const void *state);

#define TP_COASTAL_ID TP_MODULE_ID('o', 'c', 'e', 'a')

/* Returns the water surface of this tick, from the wave models of the program; valid
 * until the next step. */
tp_surface tp_world_surface(const tp_program *program, const tp_world *world);

/* -- scenes that a program accepts --------------------------------------------------- */

/* Returns TP_OK if worlds and frames of this program accept this scene.  All init
 * functions, their byte counts and tp_world_apply call this check.  NULL assets: none.
 *  - TP_E_NULL: an argument is NULL; err->word names the argument
 *  - errors of tp_scene_check, if the program links the check
 *  - TP_E_PROGRAM: the scene enables a module that the program names in its `lacks`;
 *    err->word is the module's name, as `tidepool bake --with` takes it.  Fast stages
 *    count as lacking only if quality.shading names them; otherwise the plan takes the
 *    exact stages. */
tp_status tp_program_check_all(const tp_program *program, const tp_scene *scene,
                               const tp_assets *assets, tp_error *err);

/* Returns TP_E_NULL for a NULL scene, else the result of the program's own check of the
 * scene.  All init functions call this check through tp_program_check_all. */
tp_status tp_program_check_scene(const tp_program *program, const tp_scene *scene,
                                 tp_error *err);

/* Returns TP_E_PROGRAM; err->word names the missing module. */
tp_status tp_program_fail_lacking(const char *what, tp_error *err);

#endif
