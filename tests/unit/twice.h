/* SPDX-License-Identifier: MIT */
/* A scene drawn twice, whole and in tiles of any size, by frames that live on: both must
 * hold the same bits, and write nothing outside of their memory.  Counts what the pictures
 * had in them, since a test of a stage that never runs says nothing. */
#ifndef TP_TESTS_TWICE_H
#define TP_TESTS_TWICE_H
#include "frame/frame.h"
#include "kit.h"
#include "tidepool/kit.h"

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
    const tp_kit *by;           /* NULL: everything */
    test_frame    whole, tiled;
    tp_format     format;
    uint32_t      picture[2][TWICE_WIDTH * TWICE_HEIGHT];
    twice_reached reached;
} test_twice;

static inline void twice_begin(test_twice *t, const tp_scene *scene,
                               const tp_assets *assets, uint64_t *state)
{
    t->format = (tp_format)random_below(state, TP_FORMAT_COUNT);
    const tp_frame_config whole = { TWICE_WIDTH, TWICE_HEIGHT, 0, 0, t->format };
    const tp_frame_config tiled = { TWICE_WIDTH, TWICE_HEIGHT, 16 * random_below(state, 5),
                                    random_below(state, TWICE_HEIGHT), t->format };
    const tp_kit *by = t->by ? t->by : &tp_kit_all;
    t->whole = frame_by(by, scene, assets, &whole);
    t->tiled = frame_by(by, scene, assets, &tiled);
}

static inline void twice_end(test_twice *t)
{
    frame_free(&t->whole);
    frame_free(&t->tiled);
}

static inline void twice_marks(const uint32_t *key, twice_reached *r)
{
    bool has[256] = { false };

    for (int i = 0; i < TWICE_WIDTH * TWICE_HEIGHT; i++)
        has[TP_MARK(key[i])] = true;
    r->water += has[TP_MARK_WATER];
    r->solids += has[TP_MARK_SOLID] || has[TP_MARK_SOLID + 1];
    r->land += has[TP_MARK_LAND];
    r->drops += has[TP_MARK_DROP];
    r->tank += has[TP_MARK_TANK];
    r->sides += has[TP_MARK_SIDE];
    r->spray += has[TP_MARK_SPRAY];
}

static inline void twice_count(const tp_frame *f, const uint32_t *key, twice_reached *r)
{
    const tp_env *env = &f->shade.env;

    twice_marks(key, r);
    r->drawn++;
    r->under += f->under;
    r->in_a_tank += f->under && f->shade.inside.walled;
    r->aboard += f->world->aboard;
    r->glass += f->glasses > 0;
    r->blocks += f->blocks > 0;
    r->mirrored += f->shade.mirrored.colour != NULL;
    r->sunken += f->shade.sunken.colour != NULL;
    r->cube += f->shade.around.colour != NULL;
    r->caustics += f->parts.caustic_light != NULL;
    r->bumps += f->shade.bumps.pool[0].slope || f->shade.bumps.pool[1].slope;
    r->foam += tp_world_foam(f->world) != NULL;
    r->dome += env->kind == TP_ENV_DOME;
    r->cube_sky += env->kind == TP_ENV_CUBE;
    r->hdr += env->beyond > 0;
    r->exposed += f->shade.tone && f->drawn.exposure != TP_FX_ONE;
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

/* Into a scratch full of other things. */
static inline void twice_paint(const test_frame *f, tp_format format, uint32_t *picture)
{
    tp_tile tile;

    memset(f->scratch, 0x5a, f->scratch_bytes);
    for (uint32_t i = 0; tp_frame_tile(f->frame, i, f->scratch, &tile); i++) {
        const uint8_t *row = tile.pixels;
        for (uint32_t y = tile.y0; y < tile.y1; y++, row += tile.stride)
            for (uint32_t x = tile.x0; x < tile.x1; x++)
                picture[y * TWICE_WIDTH + x] = tp_pixel_read(format, row,
                                                             (int)(x - tile.x0));
    }
    assert_true(frame_guard_holds(f->block, f->bytes));
    assert_true(frame_guard_holds(f->scratch, f->scratch_bytes));
}

static inline void twice_draw(test_twice *t, const tp_world *world)
{
    tp_frame_begin(t->whole.frame, world);
    tp_frame_begin(t->tiled.frame, world);
    twice_paint(&t->whole, t->format, t->picture[0]);
    twice_paint(&t->tiled, t->format, t->picture[1]);
    twice_count(t->whole.frame, (const uint32_t *)(const void *)t->whole.scratch,
                &t->reached);
    assert_memory_equal(t->picture[0], t->picture[1], sizeof t->picture[0]);
}
#endif
