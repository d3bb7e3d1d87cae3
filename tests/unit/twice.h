/* SPDX-License-Identifier: MIT */
/* Draws a scene twice, whole and in tiles of any size and order, with frames that live on:
 * both pictures must have the same bits, without a write outside the frames' memory.
 * Counts the contents of the pictures, because a test of a stage proves nothing if the
 * stage never runs. */
#ifndef TP_TESTS_TWICE_H
#define TP_TESTS_TWICE_H
#include "features/exposure/exposure.h"
#include "features/foam/foam.h"
#include "features/reflection/mirror.h"
#include "features/reflection/object_cube.h"
#include "features/water/bumps.h"
#include "features/underwater/underwater.h"
#include "features/tank/tank.h"
#include "frame/frame.h"
#include "frame/tools.h"
#include "kinds.h"
#include "kit.h"
#include "pixel/pixel.h"

enum { TWICE_WIDTH = 68, TWICE_HEIGHT = 48 };

#define TWICE_REACHED(X) \
    X(drawn) X(under) X(in_a_tank) X(aboard) X(water) X(solids) X(land) X(drops) X(tank) \
    X(sides) X(spray) X(glass) X(blocks) X(mirrored) X(sunken) X(cube) X(caustics) \
    X(bumps) X(foam) X(dome) X(cube_sky) X(hdr) X(exposed) X(dispersed) X(between_ticks)

typedef struct {
#define X(name) uint32_t name;
    TWICE_REACHED(X)
#undef X
} twice_reached;

typedef struct {
    const tp_program *by;       /* NULL: all modules */
    const tp_program *tiled_by; /* program of the tiled frame; NULL: the same */
    bool          backwards;    /* draws the last tile first */
    test_frame    whole, tiled;
    tp_config config; /* config of the tiled frame */
    size_t        pixels;
    uint32_t     *picture[2];
    twice_reached reached;
} test_twice;

/* Begins pictures of any size, whole and in the given tiles. */
static inline void twice_begin_at(test_twice *t, const tp_scene *scene,
                                  const tp_assets *assets, const tp_config *tiles)
{
    const tp_config whole = { .width = tiles->width,
                              .height = tiles->height,
                              .tile_height = tiles->height,
                              .format = tiles->format };
    const tp_program *by = t->by ? t->by : &tp_program_all;
    t->config = *tiles;
    t->pixels = (size_t)tiles->width * tiles->height;
    t->whole = frame_by(by, scene, assets, &whole);
    t->tiled = frame_by(t->tiled_by ? t->tiled_by : by, scene, assets, tiles);
    for (int i = 0; i < 2; i++) {
        t->picture[i] = malloc(t->pixels * sizeof *t->picture[i]);
        assert_non_null(t->picture[i]);
    }
}

static inline void twice_begin(test_twice *t, const tp_scene *scene,
                               const tp_assets *assets, uint64_t *state)
{
    const tp_format format = (tp_format)random_below(state, TP_FORMAT_COUNT);
    const tp_config tiles = { .width = TWICE_WIDTH,
                              .height = TWICE_HEIGHT,
                              .tile_width = 16 * random_below(state, 5),
                              .tile_height = random_below(state, TWICE_HEIGHT),
                              .format = format };
    twice_begin_at(t, scene, assets, &tiles);
}

static inline void twice_end(test_twice *t)
{
    frame_free(&t->whole);
    frame_free(&t->tiled);
    free(t->picture[0]);
    free(t->picture[1]);
}

static inline void twice_marks(const tp_frame *f, const uint32_t *key, size_t pixels,
                               twice_reached *r)
{
    bool has[MARKS_SPRAY + 1] = { false };
    uint8_t kind[TP_MARKS];

    marks_list_kinds(f, kind);
    for (size_t i = 0; i < pixels; i++)
        has[kind[TP_MARK(key[i])]] = true;
    r->water += has[MARKS_WATER];
    r->solids += has[MARKS_BOAT];
    r->land += has[MARKS_LAND];
    r->drops += has[MARKS_DROP];
    r->tank += has[MARKS_TANK];
    r->sides += has[MARKS_SIDE];
    r->spray += has[MARKS_SPRAY];
}

static inline void twice_count(const tp_frame *f, const uint32_t *key, size_t pixels,
                               twice_reached *r)
{
    const tp_env *env = &f->shade.env;

    twice_marks(f, key, pixels, r);
    r->drawn++;
    r->under += f->under;
    r->in_a_tank += f->under && f->shade.inside->walled;
    r->aboard += f->world->aboard;
    const tp_tank *tank = tp_frame_module_memory(f, TP_TANK_ID);
    const tp_glass *glass = tp_frame_module_memory(f, TP_GLASS_ID);
    r->glass += glass && glass->walls > 0;
    r->blocks += tank && tank->blocks > 0;
    const tp_mirror *mirror = tp_frame_module_memory(f, TP_MIRROR_ID);
    const tp_object_cube *cube = tp_frame_module_memory(f, TP_OBJECT_CUBE_ID);
    r->mirrored += mirror && mirror->half.colour;
    const tp_clear_water *clear = tp_frame_module_memory(f, TP_CLEAR_WATER_ID);
    r->sunken += clear && clear->sunken;
    r->cube += cube && cube->colour;
    r->caustics += tp_frame_module_memory(f, TP_CAUSTICS_ID) != NULL;
    const tp_pool_bumps *bumps = tp_frame_module_memory(f, TP_BUMPS_ID);
    r->bumps += bumps && (bumps->pool[0].slope || bumps->pool[1].slope);
    r->foam += tp_world_foam(f->world) != NULL;
    r->dome += env->kind == TP_ENV_DOME;
    r->cube_sky += env->kind == TP_ENV_CUBE;
    r->hdr += env->beyond > 0;
    r->exposed +=
        tp_frame_module_memory(f, TP_EXPOSURE_ID) && f->drawn.exposure != TP_FX_ONE;
    r->dispersed += f->scene->water.dispersion > 0 && f->scene->water.clear > 0;
    r->between_ticks += f->world->back > 0;
}

static inline void twice_print(const twice_reached *r)
{
#define X(name) printf(" " #name " %" PRIu32, r->name);
    printf("# reached:");
    TWICE_REACHED(X)
#undef X
    printf("\n");
}

static inline bool twice_reached_all(const twice_reached *r)
{
#define X(name) && r->name > 0
    return true TWICE_REACHED(X);
#undef X
}

/* Draws all tiles; the scratch memory holds other data before. */
static inline void twice_paint(const test_frame *f, bool backwards, uint32_t *picture)
{
    const tp_config *config = &f->frame->config;
    const uint32_t count = tp_frame_tiles(f->frame);
    tp_tile tile;

    memset(f->scratch, 0x5a, f->scratch_bytes);
    for (uint32_t i = 0;
         tp_frame_draw_tile(f->frame, backwards ? count - 1 - i : i, f->scratch, &tile);
         i++) {
        const uint8_t *row = tile.pixels;
        for (uint32_t y = tile.y0; y < tile.y1; y++, row += tile.stride)
            for (uint32_t x = tile.x0; x < tile.x1; x++)
                picture[y * config->width + x] = tp_pixel_read(config->format, row,
                                                               (int)(x - tile.x0));
    }
    assert_true(frame_guard_holds(f->block, f->bytes));
    assert_true(frame_guard_holds(f->scratch, f->scratch_bytes));
}

static inline void twice_draw(test_twice *t, const tp_world *world)
{
    tp_frame_begin(t->whole.frame, world);
    tp_frame_begin(t->tiled.frame, world);
    twice_paint(&t->whole, false, t->picture[0]);
    twice_paint(&t->tiled, t->backwards, t->picture[1]);
    twice_count(t->whole.frame, (const uint32_t *)(const void *)t->whole.scratch,
                t->pixels, &t->reached);
    assert_memory_equal(t->picture[0], t->picture[1],
                        t->pixels * sizeof *t->picture[0]);
}
#endif
