/* SPDX-License-Identifier: MIT */
/* Kept worlds for tests: three scenes with every part of a world between them.  Each has
 * the file of a world that has moved; a test can change its bytes and give it a correct
 * CRC again. */
#ifndef TP_TESTS_LIB_SNAPSHOTS_H
#define TP_TESTS_LIB_SNAPSHOTS_H
#include "pixel/pixel.h"
#include "world/pools.h"
#include "app/files/snapshot.h"
#include "tests/lib/worlds.h"

enum { KEPT_SCENES = 3, KEPT_WIDTH = 32, KEPT_HEIGHT = 24 };

typedef struct {
    tp_scene   scene;
    tp_assets  assets;
    test_boat  boat;
    test_frame frame;
    tp_world  *fresh, *world;   /* at tick 0; destination of snapshot_read */
    size_t     bytes;
    snapshot_store keep;
    uint8_t   *file;            /* written by snapshot_write: a head, then the world */
    size_t     head;
} kept;

/* -- scenes ------------------------------------------------------------------------ */

static inline void kept_pool(tp_scene_pool *pool, int32_t cells, int32_t edges)
{
    pool->cols = 20;
    pool->rows = 18;
    pool->cell_bits = cells;
    pool->boundary = edges;
    pool->sponge = 4;
    pool->courant = TP_FX(0.4);
    pool->drive_min = TP_FX(0.01);
    pool->drive_max = TP_FX(0.02);
    pool->splash_interval = TP_FX(0.2);
}

static inline void kept_air(tp_scene *s, int32_t into)
{
    s->drops.count = 6;
    s->drops.rings = 6;
    s->drops.target = into;
    s->drops.interval = TP_FX(0.1);
    s->spray.count = 12;
    s->foam.cells = 12;
}

/* Scene 0: cells of 16 and 32 bits, walls, rings, a floating boat, foam and spray, auto
 * exposure.  Scene 1: cells of 8 bits, a floor map, a camera on deck.  Scene 2: drops
 * into an endless field of 32 bits, and nothing else. */
static inline void kept_scene(kept *k, int number, uint64_t *chance)
{
    tp_scene *s = &k->scene;
    *s = scene_plain();
    k->assets = assets_with(chance, s, number == 1, number == 0);
    s->grid.vertices = 144;
    s->boat.wake = TP_FX_ONE;
    if (number < 2)
        kept_air(s, number == 0 ? TP_DROPS_RINGS : TP_DROPS_POOL);
    if (number == 0) {
        kept_pool(&s->pool, TP_CELLS_16, TP_EDGES_WALL);
        kept_pool(&s->field, TP_CELLS_32, TP_EDGES_SPONGE);
        s->boat.mode = TP_BOAT_DYNAMIC;
        s->hdr.exposure = TP_EXPOSURE_AUTO;
        s->mirror.method = TP_MIRROR_STENCIL;
        s->water.clarity = TP_FX(4);
    } else if (number == 1) {
        kept_pool(&s->pool, TP_CELLS_8, TP_EDGES_TILE);
        s->floor.map_size = 100 * TP_FX_ONE;
        s->wind.strength = TP_FX(0.05);
        s->camera.follow = TP_FOLLOW_BOAT;
        s->mirror.method = TP_MIRROR_CUBE;
    } else {
        kept_pool(&s->field, TP_CELLS_32, TP_EDGES_TILE);
        s->drops.count = 4;
        s->drops.target = TP_DROPS_POOL;
        s->boat.mesh[0] = '\0';
    }
    if (s->boat.mesh[0])
        k->assets.boat = &k->boat.mesh;
}

/* -- files ------------------------------------------------------------------------- */

static inline void kept_read(kept *k, const char *path)
{
    FILE *file = fopen(path, "rb");
    fseek(file, 0, SEEK_END);
    const size_t bytes = (size_t)ftell(file);
    rewind(file);
    k->file = malloc(bytes);
    k->head = bytes - k->bytes;
    if (fread(k->file, 1, bytes, file) != bytes)
        abort();
    fclose(file);
}

/* Makes the world, moves it 60 ticks and keeps it as `path`. */
static inline void kept_begin(kept *k, int number, const char *path)
{
    const tp_config config = { .width = KEPT_WIDTH,
                               .height = KEPT_HEIGHT,
                               .tile_height = KEPT_HEIGHT };
    uint64_t chance = 11 + (uint64_t)number;
    boat_make(&k->boat, &chance);
    kept_scene(k, number, &chance);
    k->frame = frame_of(&k->scene, &k->assets, &config);
    k->fresh = scene_world(&k->scene, &k->assets);
    k->bytes = k->fresh->layout.bytes;
    k->world = malloc(k->bytes);
    memcpy(k->world, k->fresh, k->bytes);
    run(&chance, k->world, &k->scene, 60);
    k->keep = snapshot_begin(path, &k->scene, &k->assets);
    if (snapshot_write(&k->keep, k->world, k->bytes, (snapshot_progress){ .frame = 60 }))
        abort();
    kept_read(k, path);
}

static inline void kept_end(kept *k)
{
    frame_free(&k->frame);
    free(k->fresh);
    free(k->world);
    free(k->file);
}

/* Writes the correct CRC-32 of all other bytes into the last four bytes of the head. */
static inline void kept_sign(const kept *k, uint8_t *file)
{
    uint8_t *crc = file + k->head - 4;
    memset(crc, 0, 4);
    const uint32_t sum = tp_crc32(tp_crc32(0, file, k->head), file + k->head, k->bytes);
    memcpy(crc, &sum, 4);
}

/* -- places of parts ----------------------------------------------------------------- */

enum { KEPT_PARTS = 7 };

/* Offset of a part in the scene's world; 0: the world has no such part. */
static inline uint32_t kept_place(const kept *k, const void *part)
{
    return part ? (uint32_t)((const char *)part - (const char *)k->fresh) : 0;
}

/* Offsets of the world's head and of its parts. */
static inline void kept_places(const kept *k, uint32_t places[KEPT_PARTS])
{
    const void *const layout[] = { tp_world_coastal(k->fresh), tp_world_pool(k->fresh),
                                   tp_world_field(k->fresh), tp_world_drops(k->fresh),
                                   tp_world_spray(k->fresh) };

    places[0] = 0;
    for (int i = 0; i < KEPT_PARTS - 2; i++)
        places[i + 1] = kept_place(k, layout[i]);
    places[KEPT_PARTS - 1] = k->fresh->layout.modules;
}

/* -- use --------------------------------------------------------------------------- */

static inline void kept_draw(const kept *k)
{
    tp_tile tile;
    tp_frame_begin(k->frame.frame, k->world);
    for (uint32_t i = 0; tp_frame_draw_tile(k->frame.frame, i, k->frame.scratch, &tile);
         i++)
        continue;
}

/* True if the current file is accepted. */
static inline bool kept_take(const kept *k)
{
    snapshot_progress at;
    memcpy(k->world, k->fresh, k->bytes);
    return snapshot_read(&k->keep, k->world, k->bytes, &at);
}

/* Draws the accepted world, moves it three ticks and draws again. */
static inline void kept_move(const kept *k)
{
    const tp_input input = { .drops = 1,
                             .push[0].height = TP_FX(0.1),
                             .forward = TP_FX_ONE,
                             .throttle = TP_FX_ONE,
                             .slowdown = 1 };
    kept_draw(k);
    for (int i = 0; i < 3; i++) {
        tp_world_advance_clock(k->world);
        tp_world_step(&tp_program_all, k->world, &k->scene, &input);
    }
    kept_draw(k);
}
#endif
