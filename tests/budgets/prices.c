/* SPDX-License-Identifier: MIT */
/* Measures the parts of the plan's cost table on a bare Cortex-M: draws the baked
 * prices.ini with all features off, then with one feature after another on, for each rung.
 * Prints the picture of each section of the plugin's counts; prices-count.awk takes the
 * differences. */
#include "base/arena.h"
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/marks.h"
#include "cortex-m/semihost.h"
#include "frame/tools.h"
#include "scene/prices.h"
#include "prices_scenes.h"
#include "scene/value.h"

#define BAND  16
#define STEPS 60                /* of pools and foam, until all of the water moves */

MARK(count_as_frame)
MARK(count_as_tiles)
MARK(count_end)
MARK(count_section)

static const char *const visibilities[] = { "triangles", "rows", "projected", "flat" };
static const char *const lods[] = { "off", "on" };
static const char *const shadings[] = { "exact", "quick" };
static const char *const rates[] = { "full", "layers", "colour" };

#define COUNT(of) (sizeof of / sizeof *of)

/* -- scenes -------------------------------------------------------------------------- */

static tp_scene  scene;
static tp_assets assets;

/* Number of characters before the first `a`, the first `b` or the end. */
static size_t until(const char *text, char a, char b)
{
    size_t n = 0;

    while (text[n] && text[n] != a && text[n] != b)
        n++;
    return n;
}

/* Enables an asset by the first letter of its name: layer0, layer1, distortion, ripple,
 * foam, boat, map and sand of the floor, tank, walls of a pool. */
static void keep(const char *name)
{
    switch (name[0]) {
    case 'l': assets.layer[name[5] - '0'] = baked_assets.layer[name[5] - '0']; break;
    case 'd': assets.distortion = baked_assets.distortion; break;
    case 'r': assets.ripple = baked_assets.ripple; break;
    case 'f': assets.foam = baked_assets.foam; break;
    case 'b':
        assets.boat = baked_assets.boat;
        scene.boat.mesh[0] = baked_scene.boat.mesh[0];
        break;
    case 'm':
        assets.floor = baked_assets.floor;
        scene.floor.map[0] = baked_scene.floor.map[0];
        break;
    case 's': assets.floor_texture = baked_assets.floor_texture; break;
    case 't':
        assets.tank_wall = baked_assets.tank_wall;
        assets.tank_floor = baked_assets.tank_floor;
        break;
    case 'w': assets.pool_mask = baked_assets.pool_mask; break;
    default:  semihost_stop(name);
    }
}

static void set(const char *text)
{
    while (*text) {
        const size_t bytes = until(text, ' ', ' '), name = until(text, ' ', '=');
        tp_error err;
        if (name == bytes)
            keep(text);
        else if (tp_param_set(&scene, tp_param_find(text, name), text + name + 1,
                              bytes - name - 1, &err))
            semihost_stop(text);
        text += bytes + (text[bytes] == ' ');
    }
}

static void begin(const tp_rungs *rungs)
{
    scene = baked_scene;
    assets = (tp_assets){ .boat = NULL };
    for (int i = 0; i < TP_FACES; i++)
        assets.sky[i] = baked_assets.sky[i];
    scene.quality.visibility = (int32_t)rungs->visibility;
    scene.quality.shading = (int32_t)rungs->shading;
    scene.quality.rate = (int32_t)rungs->rate;
    scene.quality.lod = (int32_t)rungs->lod;
    scene.boat.mesh[0] = scene.floor.map[0] = '\0';
    set(OFF);
}

/* -- pictures ------------------------------------------------------------------------ */

static void draw(const char *what, const char *rung, const char *other, const char *item,
                 uint32_t width, uint32_t height)
{
    const tp_config config = { .width = width,
                               .height = height,
                               .tile_height = BAND,
                               .format = TP_FORMAT_RGB565,
                               .assets = &assets };
    const size_t world_bytes = tp_world_bytes(&tp_program_all, &scene, &assets);
    tp_arena  arena = tp_arena_init(arena_start, (size_t)(arena_end - arena_start));
    void *block = tp_arena_alloc(&arena, 1, tp_frame_bytes(&config, &scene));
    void *scratch = tp_arena_alloc(&arena, 1, tp_frame_scratch_bytes(&config, &scene));
    tp_world *world = tp_arena_alloc(&arena, 1, world_bytes);
    uint32_t  water = 0;
    tp_frame *frame;
    tp_tile   tile;

    if (arena.failed
        || tp_frame_init(&frame, &config, &scene, block, tp_frame_bytes(&config, &scene),
                         NULL)
        || tp_world_init(&tp_program_all, world, world_bytes, &scene, &assets, NULL))
        semihost_stop("a scene does not fit");
    const bool moves = scene.pool.cols > 0 || scene.drops.count > 1 || assets.foam;
    for (int i = 0; i < STEPS && moves; i++)
        tp_world_step(&tp_program_all, world, &scene, NULL);
    tp_frame_begin(frame, world);           /* the first begin fills tables */
    count_as_frame();
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0; tp_frame_draw_tile(frame, i, scratch, &tile); i++) {
        count_end();
        water += tp_frame_water_pixels(frame, scratch, &tile);
        count_as_tiles();
    }
    count_end();
    semihost_write("run ");
    semihost_write(what);
    semihost_write(" ");
    semihost_write(rung);
    semihost_write(other[0] ? "." : "");
    semihost_write(other);
    semihost_write(" ");
    semihost_write(item);
    semihost_decimal(" ", width * height);
    semihost_decimal(" ", water);
    const tp_plan_input in = { tp_program_all.modules, &scene, &assets, width, height };
    const tp_view_estimate estimate = tp_view_estimate_make(&in);
    semihost_decimal(" ", estimate.points[scene.quality.visibility - 1]);
    semihost_decimal(" ", estimate.waves);
    semihost_decimal(" ", (uint32_t)estimate.slant);
    semihost_decimal(" ", estimate.drawn);
    semihost_write("\n");
}

static const tp_rungs exact = { TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL,
                                TP_LOD_OFF };

static const char *const work_names[] = {
#define X(name) #name,
    TP_WORKS(X)
#undef X
};

static void draw_works(void)
{
    for (size_t i = 0; i < COUNT(works); i++) {
        begin(&exact);
        set(works[i].set);
        draw("work", "-", "", works[i].name, 320, 240);
        semihost_write("beside -");
        semihost_write(works[i].beside);
        semihost_write("\n");
        const tp_plan_input in = { tp_program_all.modules, &scene, &assets, 320, 240 };
        const tp_view_estimate estimate = tp_view_estimate_make(&in);
        const tp_fixed_cost done = tp_fixed_cost_estimate(&in, &estimate,
                                          scene.quality.shading == TP_SHADING_QUICK);
        for (size_t k = 0; k < TP_WORK_COUNT; k++) {
            semihost_write("work ");
            semihost_write(work_names[k]);
            semihost_decimal(" ", done.of[k]);
            semihost_write("\n");
        }
        count_section();
    }
}

static void draw_seen(void)
{
    for (size_t v = 0; v < COUNT(visibilities); v++)
        for (size_t l = 0; l < COUNT(lods); l++)
            for (size_t i = 0; i < COUNT(seen); i++) {
                tp_rungs rungs = exact;
                rungs.visibility = (tp_visibility)(v + 1);
                rungs.lod = (tp_lod)(l + 1);
                begin(&rungs);
                set(seen[i].set);
                const bool small = seen[i].name[1] == 'm';
                draw("seen", visibilities[v], lods[l], seen[i].name, small ? 160 : 320,
                     small ? 112 : 240);
                count_section();
            }
}

static void draw_shaded(void)
{
    for (size_t s = 0; s < COUNT(shadings); s++)
        for (size_t r = 0; r < COUNT(rates); r++)
            for (size_t i = 0; i < COUNT(shaded); i++) {
                tp_rungs rungs = exact;
                rungs.shading = (tp_shading)(s + 1);
                rungs.rate = (tp_rate)(r + 1);
                begin(&rungs);
                set(shaded[i].set);
                draw("shaded", shadings[s], rates[r], shaded[i].name, 320, 240);
                count_section();
            }
}

int main(void)
{
    for (size_t i = 0; i < COUNT(sky); i++) {
        begin(&exact);
        set(sky[i].set);
        draw("sky", "-", "", sky[i].name, i ? 160 : 320, i ? 112 : 240);
        count_section();
    }
    draw_seen();
    draw_shaded();
    draw_works();
    return 0;
}
