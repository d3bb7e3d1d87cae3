/* SPDX-License-Identifier: MIT */
/* Pictures drawn in several ways that must give equal bits: in tiles of any size and order,
 * by frames that live on, by two water renderers. */
#ifndef TP_TESTS_LIB_TILINGS_H
#define TP_TESTS_LIB_TILINGS_H
#include "features/exposure/exposure.h"
#include "features/foam/foam.h"
#include "features/reflection/reflection.h"
#include "features/spray/spray.h"
#include "features/tank/tank.h"
#include "features/underwater/underwater.h"
#include "features/water/water.h"
#include "frame/frame.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "tests/lib/frames.h"
#include "tests/lib/scenes.h"

/* -- pictures with the kind of object in each pixel ---------------------------------- */

/* Draws the whole picture as one tile.  `key` has one word per pixel and may be NULL; it
 * receives depths, with object kinds in place of stencil values. */
static inline void marks_draw(const tp_scene *scene, const tp_assets *assets,
                              const tp_world *world, tp_config config, uint32_t *key,
                              uint32_t *pixels)
{
    test_frame f = frame_of(scene, assets, &config);
    uint8_t kind[TP_MARKS];
    tp_tile tile;

    tp_frame_begin(f.frame, world);
    marks_list_kinds(f.frame, kind);
    for (uint32_t i = 0; tp_frame_draw_tile(f.frame, i, f.scratch, &tile); i++) {
        const uint32_t *from = (const uint32_t *)(const void *)f.scratch;
        for (uint32_t y = tile.y0; y < tile.y1; y++) {
            const size_t row = (y - tile.y0) * (size_t)f.frame->config.tile_width;
            const size_t at = y * (size_t)config.width + tile.x0;
            const size_t bytes = (tile.x1 - tile.x0) * sizeof *from;
            for (uint32_t x = 0; key && x < tile.x1 - tile.x0; x++)
                key[at + x] = (from[row + x] & ~0xffu) | kind[TP_MARK(from[row + x])];
            if (pixels)
                memcpy(pixels + at, (const uint8_t *)tile.pixels
                                    + (y - tile.y0) * tile.stride, bytes);
        }
    }
    if (!frame_guard_holds(f.block, f.bytes)
        || !frame_guard_holds(f.scratch, f.scratch_bytes))
        abort();
    frame_free(&f);
}

static inline uint32_t marks_count(const uint32_t *key, size_t pixels, marks_kind kind)
{
    uint32_t count = 0;

    for (size_t i = 0; i < pixels; i++)
        count += TP_MARK(key[i]) == kind;
    return count;
}

/* Asserts that the picture has the same pixels in tiles of each of these sizes as in one
 * tile. */
static inline void marks_assert_tiled(const tp_scene *scene, const tp_assets *assets,
                                      const tp_world *world, tp_config config,
                                      const uint32_t size[][2], size_t count,
                                      uint32_t *key)
{
    const size_t bytes = (size_t)config.width * config.height * sizeof(uint32_t);
    uint32_t *const whole = malloc(bytes), *const tiled = malloc(bytes);

    assert_true(whole && tiled && config.tile_height == config.height);
    marks_draw(scene, assets, world, config, key, whole);
    for (size_t i = 0; i < count; i++) {
        config.tile_width = size[i][0];
        config.tile_height = size[i][1];
        marks_draw(scene, assets, world, config, NULL, tiled);
        assert_memory_equal(tiled, whole, bytes);
    }
    free(whole);
    free(tiled);
}

/* Still water below a camera at this height in m that looks to -z. */
static inline tp_scene marks_still(int32_t metres)
{
    tp_scene s;

    tp_scene_level(&s);
    s.grid.vertices = 144;
    s.camera.y = metres * TP_FX_ONE;
    s.camera.pitch = 0;
    return s;
}

/* -- two water renderers, sample by sample ------------------------------------------- */

#ifndef LEVEL_WIDTH
#define LEVEL_WIDTH  150
#define LEVEL_HEIGHT 90
#endif
#define LEVEL_PIXELS (LEVEL_WIDTH * LEVEL_HEIGHT)

/* G-buffer of a frame that is drawn as one tile; the caller frees the frame. */
typedef struct {
    test_frame frame;
    tp_world   world;
    const uint32_t *key, *s, *t, *n;
    const uint32_t *pixels;
} level_shot;

static inline void level_draw(level_shot *shot, tp_scene *scene, const tp_assets *assets,
                              tp_visibility how, uint64_t tick)
{
    const tp_config config = { .width = LEVEL_WIDTH,
                               .height = LEVEL_HEIGHT,
                               .tile_height = LEVEL_HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    tp_tile tile;

    scene->quality.visibility = (int32_t)how;
    shot->frame = frame_of(scene, assets, &config);
    if (tp_world_init(&tp_program_all, &shot->world, sizeof shot->world, scene, NULL,
                      NULL)
        != TP_OK)
        abort();
    shot->world.tick = tick;
    tp_world_apply(&tp_program_all, &shot->world, scene, NULL);
    tp_frame_begin(shot->frame.frame, &shot->world);
    if (!tp_frame_draw_tile(shot->frame.frame, 0, shot->frame.scratch, &tile))
        abort();
    shot->key = (const uint32_t *)(const void *)shot->frame.scratch;
    shot->s = shot->key + LEVEL_PIXELS;
    shot->t = shot->s + LEVEL_PIXELS;
    shot->n = shot->t + LEVEL_PIXELS;
    shot->pixels = (const uint32_t *)tile.pixels;
}

static inline bool level_is_water(const level_shot *shot, int i)
{
    return TP_MARK(shot->key[i]) == TP_MARK_WATER;
}

/* Returns the number of pixels that are water in one frame only. */
static inline int level_apart(const level_shot *a, const level_shot *b)
{
    int count = 0;

    for (int i = 0; i < LEVEL_PIXELS; i++)
        count += level_is_water(a, i) != level_is_water(b, i);
    return count;
}

/* Mean absolute difference of the colour channels of both pictures. */
static inline double level_colour_apart(const level_shot *a, const level_shot *b)
{
    double sum = 0;

    for (int i = 0; i < LEVEL_PIXELS; i++)
        for (int k = 0; k < 24; k += 8)
            sum += abs((int)(a->pixels[i] >> k & 255) - (int)(b->pixels[i] >> k & 255));
    return sum / 3 / LEVEL_PIXELS;
}

/* Asserts that every tile of a begun frame equals its part of the picture. */
static inline void level_compare_tiles(const test_frame *f, const uint32_t *picture)
{
    tp_tile tile;

    for (uint32_t i = 0; tp_frame_draw_tile(f->frame, i, f->scratch, &tile); i++) {
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            assert_memory_equal((const uint8_t *)tile.pixels + (y - tile.y0) * tile.stride,
                                picture + y * LEVEL_WIDTH + tile.x0,
                                (tile.x1 - tile.x0) * sizeof *picture);
    }
    assert_true(frame_guard_holds(f->block, f->bytes));
    assert_true(frame_guard_holds(f->scratch, f->scratch_bytes));
}

/* Asserts that every tiling gives the same pixels as the frame drawn whole. */
static inline void level_compare_tilings(const level_shot *whole, const tp_scene *scene,
                                         const tp_assets *assets)
{
    static const uint32_t sizes[][2] = { { 0, 1 }, { 0, 7 }, { 16, 0 }, { 48, 13 },
                                         { 64, 16 } };

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const tp_config config = { .width = LEVEL_WIDTH,
                                   .height = LEVEL_HEIGHT,
                                   .tile_width = sizes[i][0],
                                   .tile_height = sizes[i][1],
                                   .format = TP_FORMAT_XRGB8888 };
        test_frame f = frame_of(scene, assets, &config);
        tp_frame_begin(f.frame, &whole->world);
        level_compare_tiles(&f, whole->pixels);
        frame_free(&f);
    }
}

/* Puts the camera aboard a rolling boat. */
static inline void level_board(tp_scene *scene, tp_fx height)
{
    scene->camera.follow = TP_FOLLOW_BOAT;
    scene->camera.y = height;
    scene->boat.mode = TP_BOAT_KINEMATIC;
}

/* -- whole and in tiles -------------------------------------------------------------- */

/* Draws a scene twice, whole and in tiles of any size and order, with frames that live on:
 * both pictures must have the same bits, without a write outside the frames' memory.
 * Counts the contents of the pictures, because a test of a stage proves nothing if the
 * stage never runs. */

enum { TWICE_WIDTH = 68, TWICE_HEIGHT = 48 };

#define TWICE_REACHED(X) \
    X(drawn) X(under) X(in_a_tank) X(aboard) X(water) X(solids) X(land) X(drops) X(tank) \
    X(sides) X(spray) X(glass) X(blocks) X(mirrored) X(refraction_map) X(cube) X(caustics) \
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
    tp_config     config;       /* config of the tiled frame */
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
    bool has[MARKS_SIDE + 1] = { false };
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
}

static inline void twice_count(const tp_frame *f, const uint32_t *key, size_t pixels,
                               twice_reached *r)
{
    const tp_env *env = &f->shade.env;

    twice_marks(f, key, pixels, r);
    r->drawn++;
    r->under += f->under;
    r->in_a_tank += f->under && f->shade.underwater->walled;
    r->aboard += f->world->aboard;
    const tp_tank *tank = tp_frame_module_memory(f, TP_TANK_ID);
    const tp_glass *glass = tp_frame_module_memory(f, TP_GLASS_ID);
    r->glass += glass && glass->walls > 0;
    r->blocks += tank && tank->blocks > 0;
    const tp_mirror *mirror = tp_frame_module_memory(f, TP_MIRROR_ID);
    const tp_object_cube *cube = tp_frame_module_memory(f, TP_OBJECT_CUBE_ID);
    r->mirrored += mirror && mirror->map.colour;
    const tp_clear_water *clear = tp_frame_module_memory(f, TP_CLEAR_WATER_ID);
    r->refraction_map += clear && clear->refraction_map;
    r->cube += cube && cube->colour;
    r->caustics += tp_frame_module_memory(f, TP_CAUSTICS_ID) != NULL;
    const tp_pool_bumps *bumps = tp_frame_module_memory(f, TP_BUMPS_ID);
    r->bumps += bumps && (bumps->pool[0].slope || bumps->pool[1].slope);
    const tp_streaks *spray = tp_frame_module_memory(f, TP_SPRAY_ID);
    r->spray += spray && spray->count > 0;
    r->foam += tp_world_foam(f->world) != NULL;
    r->dome += env->kind == TP_ENV_DOME;
    r->cube_sky += env->kind == TP_ENV_CUBE;
    r->hdr += env->beyond > 0;
    r->exposed +=
        tp_frame_module_memory(f, TP_EXPOSURE_ID) && f->drawn.exposure != TP_FX_ONE;
    r->dispersed += f->scene->water.dispersion > 0 && f->scene->water.clarity > 0;
    r->between_ticks += f->world->lag > 0;
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

/* False if a streamed grid draws triangles where the stored grid draws scanlines: in a view
 * along x, whose lines a streamed grid cannot read.  No other difference is legal. */
static inline bool twice_has_one_renderer(const test_twice *t)
{
    const tp_frame *a = t->whole.frame, *b = t->tiled.frame;

    if (a->visibility == b->visibility)
        return true;
    assert_int_equal(a->visibility, TP_VISIBILITY_ROWS);
    assert_int_equal(b->visibility, TP_VISIBILITY_TRIANGLES);
    assert_true(b->buffers.grid->streams && !a->buffers.grid->streams);
    return false;
}

static inline void twice_draw(test_twice *t, const tp_world *world)
{
    tp_frame_begin(t->whole.frame, world);
    tp_frame_begin(t->tiled.frame, world);
    twice_paint(&t->whole, false, t->picture[0]);
    twice_paint(&t->tiled, t->backwards, t->picture[1]);
    twice_count(t->whole.frame, (const uint32_t *)(const void *)t->whole.scratch,
                t->pixels, &t->reached);
    if (twice_has_one_renderer(t))
        assert_memory_equal(t->picture[0], t->picture[1],
                            t->pixels * sizeof *t->picture[0]);
}
#endif
