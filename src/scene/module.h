/* SPDX-License-Identifier: MIT */
/* A module: one feature of a scene, in one shape.  This header has the part that the world
 * asks: when the feature is on, its state, how it moves.  frame/drawing.h has the part
 * that a picture asks.
 *
 * A program lists its modules (tp_use, tidepool/modules.h); the list's order is the order of
 * memory, of steps and of drawing.  A world keeps each module's state as a chunk, an id and
 * a length before the state's bytes, so that a copy of the block says what is in it. */
#ifndef TP_SCENE_MODULE_H
#define TP_SCENE_MODULE_H
#include "base/arena.h"
#include "geom/surface.h"
#include "scene/prices.h"

/* Drops fall and rings begin so far from the origin at the most, m each way: 8000 of the
 * sphere, 1000 of scatter. */
#define TP_DROP_FAR (9000 * TP_FX_ONE)

/* What an impact does to the water; the caller gives it to rings or to a pool. */
typedef struct {
    tp_fx   x, z;
    int64_t time;           /* ticks x 65536: inside the step */
    tp_fx   amplitude;      /* A0 [D4], m, capped at L / 14 [B14] */
    int32_t uncapped_q24;   /* A0 before that, saturated: late ones are a few LSB high */
    tp_fx   length;         /* L = 8 radii */
    tp_fx   lost;           /* energy [D3], J, saturated */
} tp_impact;

/* The pictures that NULL assets stand for. */
static inline const tp_assets *tp_scene_pictures(const tp_scene *scene,
                                                 const tp_assets *assets)
{
    return assets ? assets : scene->pictures;
}

#define TP_MODULE_ID(a, b, c, d) \
    ((uint32_t)(a) << 24 | (uint32_t)(b) << 16 | (uint32_t)(c) << 8 | (uint32_t)(d))

/* Bits of tp_module.is. */
enum {
    TP_MODULE_EXACT  = 1,       /* its water stage has no fast form */
    TP_MODULE_SOLID  = 2,       /* draws what floats or flies: mirrors show it */
    TP_MODULE_WALLS  = 4,       /* draws a tank or stone in the pool */
    TP_MODULE_INSIDE = 8,       /* knows the inside of the water */
    TP_MODULE_FAST   = 16,      /* draws the water by fast stages alone */
    TP_MODULE_SLOPES = 32,      /* draws pools as slopes of flat water */
    TP_MODULE_LIGHT  = 64,      /* lights the water by the view */
    TP_MODULE_DOME   = 128,     /* draws the sky by tp_dome, */
    TP_MODULE_CUBE   = 256,     /* or by tp_cube: its trait is the price of mirroring it */
    TP_MODULE_STARS  = 512,     /* adds to the sky */
    TP_MODULE_PANES  = 1024,    /* has stages behind the exposure's */
    TP_MODULE_COASTAL = 2048,   /* the waves feel a floor or a wind */
    TP_MODULE_MIRROR = 4096     /* a picture of what is solid, in the water */
};

/* What the samples of a module show, in the upper bits of tp_module.is. */
#define TP_MODULE_KIND_SHIFT  24
#define TP_MODULE_DRAWS(kind) ((uint32_t)(TP_SAMPLE_##kind) << TP_MODULE_KIND_SHIFT)

#define TP_MODULES 40           /* in a program's list, at the most */

/* The conditions that a module is asked about. */
typedef struct tp_want {
    const tp_scene  *scene;
    const tp_assets *assets;    /* NULL: the scene names no file */
    const tp_waters *water;     /* the program's; NULL: all models */
    uint32_t width, height;     /* of the picture; 0 for a world */
    uint32_t shadings;          /* bits of tp_shading: rungs that may be reached */
    uint32_t above;             /* bits of tp_module.is of the enabled modules above this
                                 * one in the list */
} tp_want;

/* For a world. */
static inline tp_want tp_want_by(const tp_program *program, const tp_scene *scene,
                                 const tp_assets *assets)
{
    return (tp_want){ .scene = scene,
                      .assets = tp_scene_pictures(scene, assets),
                      .water = &program->water };
}

/* All but name, id and enabled may be NULL. */
typedef struct tp_module {
    const char *name;
    uint32_t    id;             /* TP_MODULE_ID of four letters, of no other module */
    uint32_t    is;             /* TP_MODULE_EXACT ... */
    uint32_t    trait;          /* the price of its water stage, a TP_TRAIT_; 0: none */

    /* The one place that says when the feature is on: layout, step and drawing ask it, and
     * a program that lacks the module (tp_lack). */
    bool (*enabled)(const tp_want *want);

    /* Sets how often a pixel of water pays what has a price, where `trait` does not say it:
     * for the estimate.  The table is zeroed. */
    void (*count)(const tp_want *want, uint8_t trait[TP_TRAIT_COUNT]);

    /* Refuses what the table of parameters cannot: err->word is the parameter at fault. */
    tp_status (*check)(const tp_want *want, tp_error *err);

    /* The state: its bytes, aligned to 8; NULL: a world has none.  It is zeroed before
     * `init`. */
    size_t    (*bytes)(const tp_want *want);
    tp_status (*init)(void *mine, tp_world *world, const tp_want *want, tp_error *err);

    /* After numbers of the scene have changed.  `fits` changes nothing; if all states fit,
     * each of them is refreshed.  False: the world must be made anew. */
    bool (*fits)(const void *mine, const tp_scene *scene);
    bool (*refresh)(void *mine, tp_world *world, const tp_want *want);

    /* Puts what floats on the water, when all states have been made or refreshed. */
    void (*settle)(void *mine, const tp_program *program, tp_world *world,
                   const tp_scene *scene);

    /* One tick, after the modules before it in the list.  A module without `bytes` steps in
     * every world that has a chunk; its `mine` is NULL.  `input` NULL: all 0. */
    void (*step)(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input);

    /* Adds what it raises to the water's surface of this tick. */
    void (*surface)(const void *mine, tp_surface *surface);

    /* Something struck the water, which stood at `level` there.  True: the water moves. */
    bool (*hit)(void *mine, const tp_scene *scene, const tp_impact *impact, tp_fx level);

    /* True if a state from outside can be stepped and drawn.  `fresh` is one of the same
     * scene, as `init` leaves it; both have its length.  The world's head is valid. */
    bool (*is_valid)(const void *mine, const void *fresh, const tp_world *world);
} tp_module;

/* The conditions that the plan asks modules about; outlook.c. */
tp_want tp_plan_want(const tp_plan_input *in);

/* True if the module is on; then the modules below it in the list are told. */
static inline bool tp_module_ask(const tp_module *module, tp_want *want)
{
    const bool on = module->enabled(want);

    want->above |= on ? module->is : 0;
    return on;
}

/* True if a module with one of these bits of tp_module.is is on.  It asks no others, so
 * want.above is as given. */
bool tp_modules_have(const tp_use *modules, const tp_want *want, uint32_t is);

/* -- a world's chunks ---------------------------------------------------------------- */

/* The state of a module, or NULL: the world has none. */
void *tp_world_part(const tp_world *world, uint32_t id);

/* Its length, a multiple of 8. */
size_t tp_part_bytes(const void *part);

/* Checks all enabled modules and lays out their chunks: *at is the first one's offset, or
 * 0.  `want.above` is 0. */
tp_status tp_modules_take(const tp_program *program, tp_arena *arena, tp_want want,
                          uint32_t *at, tp_error *err);

/* Writes their heads, then their first states; the block is zeroed. */
tp_status tp_modules_init(const tp_program *program, tp_world *world, tp_want want,
                          tp_error *err);

/* True if the chunks are those of the scene as it is now, and their states fit it. */
bool tp_modules_fit(const tp_program *program, const tp_world *world, tp_want want);
bool tp_modules_refresh(const tp_program *program, tp_world *world, tp_want want);

void tp_modules_settle(const tp_program *program, tp_world *world, const tp_scene *scene);
void tp_modules_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                     const tp_input *input);
void tp_modules_add_surface(const tp_program *program, const tp_world *world,
                            tp_surface *surface);
/* True if one of them moves the water. */
bool tp_modules_hit(const tp_program *program, tp_world *world, const tp_scene *scene,
                    const tp_impact *impact, tp_fx level);

/* The first module whose chunk in `world`, from outside, has another id or length than in
 * `fresh`, or whose state is not valid; NULL: there is none.  Both blocks are of one length. */
const char *tp_modules_find_invalid(const tp_program *program, const tp_world *world,
                                    const tp_world *fresh);
#endif
