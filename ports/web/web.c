/* SPDX-License-Identifier: MIT */
/* The browser port: a world and its picture, in an arena above the scene's files.
 *
 *     choose(i), put(...)             select a scene, change values (values.c)
 *     wanted() ...                    supply its files (assets.c)
 *     build(width, height, format)    make its world, frame and picture
 *     step(), draw()                  next frame; its pixels in the canvas's layout
 *
 * Frame numbers are counted as in `tidepool render`: crc() equals the number of its
 * --hash. */
#include "web.h"
#include "base/base.h"
#include "features/drops/drops.h"
#include "frame/tools.h"
#include "interact/camera_mode.h"
#include "interact/poke.h"
#include "interact/setting.h"
#include "pixel/pixel.h"
#include "world/pools.h"
#include "world/world.h"

#define BAND_ROWS 128           /* as in the frame renderer of ports/app */

static struct {
    tp_world *world;            /* NULL: none yet, or dropped after a change */
    tp_frame *frame;
    uint8_t  *rows;             /* the picture in its format */
    uint32_t *shown;            /* the picture as R, G, B, A bytes */
    void     *scratch;
    uintptr_t mark, above;      /* arena marks: below all of these; above the world */
    size_t    frame_bytes;
    tp_config config;
    size_t    row_bytes;
    uint32_t  number;           /* frame number of the world */
    tp_world  before;           /* head of the last world, for setting_carry */
    bool      was;
    tp_input  next_input;       /* input of the next tick */
    poke_queue pokes;           /* pokes for the next tick and later ticks */
    camera_mode look;
} page;

/* -- a world and a frame ------------------------------------------------------------- */

/* Drops world and picture.  The arena is a stack: it must be unwound before files are
 * added or a world is made. */
void web_drop(void)
{
    if (!page.world)
        return;
    page.before = *page.world;
    page.was = true;
    page.world = NULL;
    web_restore_mark(page.mark);
}

tp_world *web_world(void)
{
    return page.world;
}

/* Makes a frame that draws with the plan's rungs; memory taken since the world is freed. */
static int make_frame(tp_error *err)
{
    const tp_config *c = &page.config;
    const tp_scene *drawn = web_plan_drawn();
    web_restore_mark(page.above);
    page.frame_bytes = tp_frame_bytes(c, drawn);
    void *block = web_take(page.frame_bytes);
    page.scratch = web_take(tp_frame_direct_scratch_bytes(c, drawn));
    page.row_bytes = tp_format_row_bytes(c->format, (int)c->width);
    page.rows = web_take(page.row_bytes * c->height);
    page.shown = web_take((size_t)c->width * c->height * sizeof *page.shown);
    if (!block || !page.scratch || !page.rows || !page.shown)
        return (int)TP_FAIL(err, TP_E_NOSPACE, 0, 0, 0);
    return (int)tp_frame_init(&page.frame, c, drawn, block, page.frame_bytes, err);
}

static int make_world(tp_error *err)
{
    const size_t bytes = tp_world_bytes(&tp_program_all, &web_scene, &web_assets);
    tp_world *world = web_take(bytes < sizeof *world ? sizeof *world : bytes);
    if (!world)
        return (int)TP_FAIL(err, TP_E_NOSPACE, 0, bytes, 0);
    if (tp_world_init(&tp_program_all, world, bytes, &web_scene, &web_assets, err))
        return (int)err->code;
    page.world = world;
    page.above = web_mark();
    return 0;
}

/* Called after a change taken by the world.  Makes a new frame if needed, if its rungs
 * change or if its size has grown. */
int web_changed(bool anew)
{
    tp_error err = { 0 };
    const bool planned = web_plan_renew(page.config.width, page.config.height);
    const size_t bytes = tp_frame_bytes(&page.config, web_plan_drawn());
    if ((anew || planned || bytes > page.frame_bytes) && make_frame(&err))
        return web_refuse(&err);
    return 0;
}

/* Makes the world; all wanted files must be present.  `carry`: camera, time and boat
 * continue from the last world.  Returns 0, or an error with its text in web_text; there
 * is then no world. */
EXPORT(int, build, uint32_t width, uint32_t height, int format, bool carry)
{
    tp_error err = { 0 };
    web_drop();
    page.mark = web_mark();
    page.config = (tp_config){ .width = width,
                               .height = height,
                               .tile_height = BAND_ROWS,
                               .format = (tp_format)format,
                               .assets = &web_assets };
    page.number = carry ? page.number : 0;
    page.next_input = (tp_input){ 0 };
    page.pokes = (poke_queue){ .count = 0 };
    web_plan_make(width, height);
    if (make_world(&err) || make_frame(&err)) {
        page.world = NULL;
        web_restore_mark(page.mark);
        return web_refuse(&err);
    }
    if (carry && page.was)
        setting_carry(page.world, &page.before);
    return 0;
}

/* Makes a picture of another size or format.  Returns 0, or an error; the old picture
 * then stays. */
EXPORT(int, resize, uint32_t width, uint32_t height, int format)
{
    tp_error err = { 0 };
    const tp_config before = page.config;
    page.config.width = width;
    page.config.height = height;
    page.config.format = (tp_format)format;
    web_plan_renew(width, height);
    if (make_frame(&err)) {
        page.config = before;
        web_plan_renew(before.width, before.height);
        make_frame(NULL);
        return web_refuse(&err);
    }
    return 0;
}

/* -- time ---------------------------------------------------------------------------- */

_Static_assert(offsetof(tp_input, push) == 13 * sizeof(int32_t),
               "the page adds to thirteen fields of 32 bits");

/* Returns the input of the next step; the page adds to its fields.  Pokes are separate. */
EXPORT(tp_input *, input, void)
{
    return &page.next_input;
}

/* Advances by a frame and returns its number.  The first tick takes the input; in slow
 * motion the input waits for a frame with a tick.  Each tick takes waiting pokes. */
EXPORT(uint32_t, step, void)
{
    for (uint32_t ticks = tp_world_advance_clock(page.world); ticks > 0; ticks--) {
        poke_take(&page.pokes, &web_scene, &page.next_input);
        camera_mode_steer(&page.look, page.world, &web_scene, &page.next_input);
        tp_world_step(&tp_program_all, page.world, &web_scene, &page.next_input);
        page.next_input = (tp_input){ 0 };
    }
    return ++page.number;
}

/* Moves the camera alone while the water stands still. */
EXPORT(void, turn, void)
{
    tp_input *input = &page.next_input;
    camera_mode_steer(&page.look, page.world, &web_scene, input);
    tp_world_move_camera(page.world, input);
    input->forward = input->strafe = input->up = 0;
    input->turn = input->tilt = 0;
}

/* -- pictures ------------------------------------------------------------------------ */

static void show_row(uint32_t y)
{
    const uint8_t *row = page.rows + y * page.row_bytes;
    const uint32_t *pixels = (const uint32_t *)(const void *)row;
    const tp_format format = page.config.format;
    uint32_t *to = page.shown + (size_t)y * page.config.width;
    for (uint32_t x = 0; x < page.config.width; x++) {
        const uint32_t c = format == TP_FORMAT_XRGB8888 ? pixels[x]
                         : tp_pixel_read(format, row, (int)x);
        to[x] = 0xff000000u | (c & 0xff) << 16 | (c & 0xff00) | (c >> 16 & 0xff);
    }
}

/* Draws.  Returns the pixels as R, G, B, A bytes. */
EXPORT(const uint32_t *, draw, void)
{
    tp_tile tile;
    web_plan_drawn();
    tp_frame_begin(page.frame, page.world);
    for (uint32_t i = 0; tp_frame_draw_tile_direct(page.frame, i, page.scratch, page.rows,
                                                   page.row_bytes, &tile);
         i++)
        for (uint32_t y = tile.y0; y < tile.y1; y++)
            show_row(y);
    return page.shown;
}

EXPORT(uint32_t, crc, void)
{
    uint32_t crc = 0;
    for (uint32_t y = 0; y < page.config.height; y++)
        crc = tp_crc32_pixels(crc, page.config.format, page.rows + y * page.row_bytes,
                              (int)page.config.width);
    return crc;
}

/* Passes the last frame's time to the governor of quality.frame_ms.  Returns nonzero if
 * the quality has changed. */
EXPORT(int, took, uint32_t us)
{
    const int step = web_plan_took(us);
    tp_error err = { 0 };

    return step && make_frame(&err) ? web_refuse(&err) : step;
}

/* -- touch and camera ---------------------------------------------------------------- */

/* Moves the sphere of drops over the point and releases a drop. */
static void release_drop(const tp_drops *drops, const tp_vec3 *at)
{
    page.next_input.sphere_x = at->x - drops->sphere.x;
    page.next_input.sphere_z = at->z - drops->sphere.z;
    page.next_input.drops = 1;
}

enum { MISSED, TOUCHED, DRY, FULL };

static int poke(const tp_push *push, bool stir)
{
    if (stir)
        poke_stir(&page.pokes, push->x, push->z);
    return stir || poke_add(&page.pokes, push) ? TOUCHED : FULL;
}

/* Pokes the water under a pixel, or lets a drop fall there; `stir`: a finger moves on.
 * MISSED: no water there.  DRY: water, but neither pool nor drops.  FULL: the poke is
 * lost, because too many wait. */
EXPORT(int, touch, int32_t x, int32_t y, bool stir)
{
    tp_vec3 at;
    const tp_drops *drops = tp_world_drops(page.world);
    if (!tp_world_pick(&tp_program_all, page.world, &web_scene, page.config.width,
                       page.config.height, tp_pixel_middle(x), tp_pixel_middle(y), &at))
        return MISSED;
    const tp_push push = poke_make_push(&web_scene, at.x, at.z);
    if (tp_world_pool(page.world) || tp_world_field(page.world))
        return poke(&push, stir);
    if (drops)
        release_drop(drops, &at);
    else
        return DRY;
    return TOUCHED;
}

EXPORT(int, poke, uint32_t number)
{
    const tp_push push = poke_point(&web_scene, number);
    return poke(&push, false);
}

/* Begins a camera mode.  Returns false if the scene has no boat for it, or for an
 * unknown mode. */
EXPORT(bool, look, int mode)
{
    return camera_mode_begin(&page.look, (camera_mode_kind)mode, page.world, &web_scene);
}

/* Returns the camera.follow needed by the mode. */
EXPORT(int, follow, void)
{
    return (int)camera_mode_follow(&page.look, &web_filed);
}

/* Returns the camera's pose as camera.x .. camera.pitch: m and degrees, Q16.16. */
EXPORT(const int32_t *, camera, void)
{
    static int32_t at[5];
    const tp_world *w = page.world;
    const int32_t heading = (int32_t)((int64_t)(int32_t)w->heading * 360 >> 16);
    const int32_t pitch = (int32_t)((int64_t)(int32_t)w->pitch * 360 >> 16);
    at[0] = w->eye.x;
    at[1] = w->eye.y;
    at[2] = w->eye.z;
    at[3] = heading;
    at[4] = pitch;
    return at;
}

/* Returns figures for the page: vertices, triangles, things left out, bytes of memory. */
EXPORT(const uint32_t *, facts, void)
{
    static uint32_t facts[4];
    const tp_draw_stats stats = tp_frame_stats(page.frame);
    facts[0] = stats.vertices;
    facts[1] = stats.triangles;
    facts[2] = stats.dropped;
    facts[3] = (uint32_t)web_mark();
    return facts;
}
