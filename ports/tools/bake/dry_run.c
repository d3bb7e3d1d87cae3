/* SPDX-License-Identifier: MIT */
#include "dry_run.h"
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/scene/thread_pool.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "world/world.h"

#define MOMENTS 24
#define EVERY   15              /* ticks between moments: 6 s in all */
#define ALONE   40              /* ticks between moments without a user: 15 s in all */
#define CAMERAS 8               /* cameras per moment if a user acts */
#define BAND    48              /* rows of a tile; every tiling draws the same bits */

/* -- random numbers ------------------------------------------------------------------ */

static uint32_t next(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (uint32_t)(z >> 32);
}

/* Returns a number in low..high. */
static int32_t between(uint64_t *state, int32_t low, int32_t high)
{
    const uint64_t span = (uint64_t)((int64_t)high - low) + 1;
    return (int32_t)(low + (int64_t)(next(state) * span >> 32));
}

static tp_fx metres(uint64_t *state, int32_t low_mm, int32_t high_mm)
{
    return (tp_fx)((int64_t)between(state, low_mm, high_mm) * TP_FX_ONE / 1000);
}

/* -- the world ----------------------------------------------------------------------- */

/* Returns a random input of a player: steers, drops, pushes the water, turns the light. */
static tp_input random_input(uint64_t *state)
{
    const tp_fx x = metres(state, -3000, 3000), z = metres(state, -3000, 3000);
    tp_input in = {
        .sphere_x = x / 64, .sphere_z = z / 64,
        .drops = next(state) % 16 == 0,
        .throttle = metres(state, -500, 4000), .rudder = 20 * metres(state, -1000, 1000),
        .light_turn = between(state, -(1 << 23), 1 << 23),
        .light_tilt = between(state, -(1 << 22), 1 << 22),
    };
    if (next(state) % 8 == 0)
        in.push[0] = (tp_push){ metres(state, -200, 200), x, z };
    return in;
}

/* Steps the world through the first moments.  Each moment's world is stored in `to` or, if
 * `to` is NULL, compared with the stored world; false: a world differs. */
static bool step_all(const dry_run *d, const dry_run_program *by, tp_world *world,
                     uint32_t moments, uint8_t *to)
{
    const uint32_t every = d->acts ? EVERY : ALONE;
    uint64_t state = 1;

    for (uint32_t m = 0; m < moments; m++) {
        for (uint32_t k = 0; m && k < every; k++) {
            const tp_input in = random_input(&state);
            const bool acts = d->acts && m > d->moments / 2;
            tp_world_step(by->program, world, by->scene, acts ? &in : NULL);
        }
        if (to)
            memcpy(to + m * d->world_bytes, world, d->world_bytes);
        else if (memcmp(d->worlds + m * d->world_bytes, world, d->world_bytes) != 0)
            return false;
    }
    return true;
}

bool dry_run_moves_same(const dry_run *d, const dry_run_program *by, uint32_t moments)
{
    if (tp_world_bytes(by->program, by->scene, by->assets) != d->world_bytes)
        return false;
    tp_world *world = malloc(d->world_bytes);
    const bool same =
        world
        && tp_world_init(by->program, world, d->world_bytes, by->scene, by->assets, NULL)
               == TP_OK
        && step_all(d, by, world, moments, NULL);
    free(world);
    return same;
}

/* -- cameras ------------------------------------------------------------------------- */

static const tp_world *moment_world(const dry_run *d, uint32_t moment)
{
    return (const tp_world *)(const void *)(d->worlds + moment * d->world_bytes);
}

/* Returns the position of the pool, the drops, the boat, or the camera. */
static tp_vec3 thing(const tp_scene *scene, const tp_world *world, uint64_t *state)
{
    switch (next(state) % 5) {
    case 0:
        return (tp_vec3){ scene->pool.x, 0, scene->pool.z };
    case 1:
        return (tp_vec3){ scene->drops.x, 0, scene->drops.z };
    case 2:
        return world->boat.place;
    default:
        return tp_world_camera(world).eye;
    }
}

/* Returns a camera within 1, 4, 16 or 64 m of a thing, turned to the thing or anywhere; a
 * third of the cameras is under water. */
static dry_run_camera camera_near(const dry_run_program *by, const tp_world *world,
                                  uint64_t *state)
{
    const tp_vec3 at = thing(by->scene, world, state);
    const int32_t reach = 1000 << 2 * (next(state) % 4);
    const bool    under = next(state) % 3 == 0;
    dry_run_camera c = { .own = false };

    c.eye.x = at.x + metres(state, -reach, reach);
    c.eye.z = at.z + metres(state, -reach, reach);
    const tp_fx level = tp_world_sample(by->program, world, c.eye.x, c.eye.z).height;
    c.eye.y = under ? level - metres(state, 20, 4000)
                    : level + metres(state, 20, 500 + reach / 2);
    c.heading = next(state);
    if (next(state) % 2)
        c.heading = tp_atan2(c.eye.x - at.x, c.eye.z - at.z)
                  + (tp_turn)between(state, -(1 << 28), 1 << 28);
    c.pitch = (tp_turn)between(state, -(5 << 27), 3 << 27);    /* -56..34 degrees */
    return c;
}

static void choose_cameras(dry_run *d, const dry_run_program *by)
{
    const uint32_t each = d->cameras / d->moments;
    uint64_t state = 2;

    for (uint32_t i = 0; i < d->cameras; i++) {
        const uint32_t moment = i / each;
        d->camera[i] = d->acts && i % each
                           ? camera_near(by, moment_world(d, moment), &state)
                           : (dry_run_camera){ .own = true };
        d->camera[i].moment = moment;
    }
}

int dry_run_open(dry_run *d, const dry_run_program *by, const tp_config *config, bool acts)
{
    tp_error err = { 0 };

    *d = (dry_run){ .config = *config, .acts = acts, .moments = MOMENTS,
                    .cameras = MOMENTS * (acts ? CAMERAS : 1) };
    d->config.tile_width = 0;
    d->config.tile_height = BAND;
    d->world_bytes = tp_world_bytes(by->program, by->scene, by->assets);
    tp_world *world = malloc(d->world_bytes ? d->world_bytes : 1);
    d->worlds = malloc(MOMENTS * d->world_bytes + 1);
    d->camera = calloc(d->cameras, sizeof *d->camera);
    int code = EXIT_DONE;
    if (!world || !d->worlds || !d->camera)
        code = log_fail_memory((MOMENTS + 1) * d->world_bytes);
    else if (tp_world_init(by->program, world, d->world_bytes, by->scene, by->assets,
                           &err)
             != TP_OK)
        code = log_fail_error("tidepool bake", &err);
    if (!code) {
        step_all(d, by, world, d->moments, d->worlds);
        choose_cameras(d, by);
    }
    free(world);
    return code;
}

void dry_run_close(dry_run *d)
{
    free(d->worlds);
    free(d->camera);
    *d = (dry_run){ 0 };
}

/* -- pictures ------------------------------------------------------------------------ */

typedef struct {
    const dry_run     *run;
    const dry_run_program *by;
    const uint32_t    *which;
    uint32_t           count;
    dry_run_picture       *to;
    const dry_run_picture *want;
    tp_error           err;             /* error on the calling thread */
    atomic_uint        taken, differs;
    atomic_bool        failed;
} dry_run_job;

/* Frame and memory of one thread. */
typedef struct {
    void     *block, *scratch;
    tp_world *world;
    tp_frame *frame;
} dry_run_painter;

static tp_config make_config(const dry_run *d, const dry_run_program *by)
{
    tp_config c = d->config;

    c.program = by->program;
    c.assets = by->assets;
    return c;
}

static bool painter_open(dry_run_painter *p, const dry_run_job *j, tp_error *err)
{
    const dry_run_program *by = j->by;
    const tp_config c = make_config(j->run, by);
    const size_t bytes = tp_frame_bytes(&c, by->scene);
    const size_t scratch = tp_frame_scratch_bytes(&c, by->scene);

    *p = (dry_run_painter){ .block = malloc(bytes + 1), .scratch = malloc(scratch + 1),
                    .world = malloc(j->run->world_bytes) };
    return p->block && p->scratch && p->world
           && tp_frame_init(&p->frame, &c, by->scene, p->block, bytes, err) == TP_OK;
}

static void painter_close(dry_run_painter *p)
{
    free(p->block);
    free(p->scratch);
    free(p->world);
}

static void take_place(tp_world *world, const dry_run_camera *c)
{
    if (c->own)
        return;
    tp_world_set_camera(world, c->eye, c->heading, c->pitch, 0);
}

static dry_run_picture paint(dry_run_painter *p, const dry_run *d, const dry_run_camera *c)
{
    dry_run_picture picture = { 0, 0 };
    tp_tile tile;

    memcpy(p->world, moment_world(d, c->moment), d->world_bytes);
    take_place(p->world, c);
    tp_frame_begin(p->frame, p->world);
    for (uint32_t i = 0; tp_frame_draw_tile(p->frame, i, p->scratch, &tile); i++) {
        picture.dropped += tile.dropped;
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            picture.crc = tp_crc32_pixels(picture.crc, d->config.format,
                                          (const uint8_t *)tile.pixels
                                          + (y - tile.y0) * tile.stride,
                                          (int)d->config.width);
    }
    picture.dropped += tp_frame_stats(p->frame).dropped;
    return picture;
}

static bool is_same(const dry_run_picture *a, const dry_run_picture *b)
{
    return a->crc == b->crc && a->dropped == b->dropped;
}

/* Notes the lowest index with a wrong picture.  Threads take pictures in order, so all
 * lower indices have been taken: the noted index is the first failure, whichever thread
 * drew it. */
static void tell(dry_run_job *j, uint32_t at)
{
    uint32_t least = atomic_load(&j->differs);
    while (at < least && !atomic_compare_exchange_weak(&j->differs, &least, at))
        continue;
}

static void draw_some(void *user, uint32_t thread)
{
    dry_run_job *j = user;
    dry_run_painter p;
    tp_error err = { 0 };

    if (!painter_open(&p, j, thread ? &err : &j->err))
        atomic_store(&j->failed, true);
    for (uint32_t i; !atomic_load(&j->failed)
                     && atomic_load(&j->differs) == j->count
                     && (i = atomic_fetch_add(&j->taken, 1)) < j->count;) {
        const uint32_t camera = j->which ? j->which[i] : i;
        const dry_run_picture picture = paint(&p, j->run, &j->run->camera[camera]);
        if (j->to)
            j->to[camera] = picture;
        if (j->want && !is_same(&picture, &j->want[camera]))
            tell(j, i);
    }
    painter_close(&p);
}

int dry_run_draw(const dry_run *d, const dry_run_program *by, const uint32_t *which,
                 uint32_t count, dry_run_picture *to, const dry_run_picture *want,
                 uint32_t *differs)
{
    dry_run_job j = {
        .run = d, .by = by, .which = which, .count = count, .to = to, .want = want
    };
    atomic_init(&j.taken, 0);
    atomic_init(&j.differs, count);
    atomic_init(&j.failed, false);
    const uint32_t threads = thread_pool_default_size();
    thread_pool *c = count > 1 && threads > 1 ? thread_pool_open(threads - 1) : NULL;
    thread_pool_run(c, draw_some, &j);
    thread_pool_close(c);
    const uint32_t first = atomic_load(&j.differs);
    if (differs)
        *differs = first == count ? d->cameras : which ? which[first] : first;
    if (!atomic_load(&j.failed))
        return EXIT_DONE;
    const tp_config config = make_config(d, by);
    return j.err.code ? log_fail_error("tidepool bake", &j.err)
                      : log_fail_memory(tp_frame_bytes(&config, by->scene));
}
