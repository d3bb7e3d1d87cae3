/* SPDX-License-Identifier: MIT */
/* What the plan's prices are made of, on a bare Cortex-M: the baked prices.ini with all
 * of it switched off and one thing after another on, by every rung.  Says which picture is
 * which section of the plugin's counts; prices-count.awk takes the differences. */
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/marks.h"
#include "cortex-m/semihost.h"
#include "scene/prices.h"

#define BAND 16

MARK(count_as_frame)
MARK(count_as_tiles)
MARK(count_end)
MARK(count_section)

/* Settings, parted by blanks; a name without "=" keeps the picture that it names. */
typedef struct {
    const char *name, *set;
} row;

#define OFF "water.specular=0 water.reflection=0 sky.haze=0 water.filter=nearest " \
            "sky.kind=gradient ripple.bump=0 distortion.strength=0 "

static const row shaded[] = {
    { "plain", "" },
    { "texture", "layer0" },
    { "linear", "layer0 water.filter=linear" },
    { "bend", "layer0 distortion distortion.strength=0.9" },
    { "layer", "layer0 layer1" },
    { "ripple", "ripple ripple.bump=0.8" },
    { "mirror", "water.reflection=0.6" },
    { "glint", "water.specular=1" },
    { "both", "water.reflection=0.6 water.specular=1" },
    { "haze", "sky.haze=2000" },
    /* rippled: the quick stages leave smooth water under these skies to the exact ones */
    { "mirror1", "ripple ripple.bump=0.8 water.reflection=0.6" },
    { "dome0", "ripple ripple.bump=0.8 sky.kind=day" },
    { "dome", "ripple ripple.bump=0.8 sky.kind=day water.reflection=0.6" },
    { "cube0", "ripple ripple.bump=0.8 sky.kind=cube" },
    { "cube", "ripple ripple.bump=0.8 sky.kind=cube water.reflection=0.6" },
    { "objects0", "water.reflection=0.6 drops.count=1" },
    { "objects", "water.reflection=0.6 drops.count=1 mirror.objects=stencil" },
    { "behind", "water.reflection=0.6 water.clear=8" },
    { "bed0", "water.reflection=0.6 floor.depth=3" },
    { "bed", "water.reflection=0.6 floor.depth=3 water.clear=8" },
    { "spread", "water.reflection=0.6 floor.depth=3 water.clear=8 "
                "water.dispersion=0.02" },
    { "foam", "foam foam.cells=64" },
    { "expose", "hdr.value=1.25" },
    { "bump", "pool.cols=64 pool.cells=32 pool.cell=2 water.pool_bump=1" },
};

static const row seen[] = {
    { "near", "" },
    { "dense", "grid.cols=100 grid.rows=100 grid.cell=1.06" },
    { "small", "" },            /* 160x112 */
    { "one", "wave1.amplitude=0 wave2.amplitude=0" },
    { "pool", "pool.cols=64 pool.cells=32 pool.cell=2" },
    { "ocean", "floor.depth=20" },
};

static const row sky[] = {
    { "large", "camera.pitch=60" }, { "small", "camera.pitch=60" },
};

static const char *const visibilities[] = { "triangles", "rows", "projected", "flat" };
static const char *const lods[] = { "off", "on" };
static const char *const shadings[] = { "exact", "quick" };
static const char *const rates[] = { "full", "layers", "colour" };

#define COUNT(of) (sizeof of / sizeof *of)

/* -- scenes -------------------------------------------------------------------------- */

static tp_scene  scene;
static tp_assets assets;

/* Up to the first of either, or the end. */
static size_t until(const char *text, char a, char b)
{
    size_t n = 0;

    while (text[n] && text[n] != a && text[n] != b)
        n++;
    return n;
}

/* Of the pictures, by their first letters: layer0, layer1, distortion, ripple, foam. */
static void keep(const char *name)
{
    switch (name[0]) {
    case 'l': assets.layer[name[5] - '0'] = baked_assets.layer[name[5] - '0']; break;
    case 'd': assets.distortion = baked_assets.distortion; break;
    case 'r': assets.ripple = baked_assets.ripple; break;
    case 'f': assets.foam = baked_assets.foam; break;
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
    set(OFF);
}

/* -- pictures ------------------------------------------------------------------------ */

static void draw(const char *what, const char *rung, const char *other, const char *item,
                 uint32_t width, uint32_t height)
{
    const tp_frame_config config = { width, height, 0, BAND, TP_FORMAT_RGB565 };
    const size_t world_bytes = tp_world_bytes(&scene, &assets);
    tp_arena  arena = tp_arena_over(arena_start, (size_t)(arena_end - arena_start));
    void     *block = tp_arena_take(&arena, 1, tp_frame_bytes(&scene, &assets, &config));
    void     *scratch = tp_arena_take(&arena, 1, tp_frame_scratch_bytes(&config));
    tp_world *world = tp_arena_take(&arena, 1, world_bytes);
    uint32_t  water = 0;
    tp_frame *frame;
    tp_tile   tile;

    if (arena.failed || tp_frame_init(&frame, &scene, &assets, &config, block, NULL)
        || tp_world_init(world, world_bytes, &scene, &assets, NULL))
        semihost_stop("a scene does not fit");
    tp_frame_begin(frame, world);           /* the first fills tables */
    count_as_frame();
    tp_frame_begin(frame, world);
    count_as_tiles();
    for (uint32_t i = 0; tp_frame_tile(frame, i, scratch, &tile); i++) {
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
    const tp_outlook outlook = tp_outlook_of(&scene, &assets, width, height);
    semihost_decimal(" ", outlook.points[scene.quality.visibility - 1]);
    semihost_decimal(" ", outlook.waves);
    semihost_write("\n");
    count_section();
}

static const tp_rungs exact = { TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL,
                                TP_LOD_OFF };

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
                const bool small = seen[i].name[0] == 's';
                draw("seen", visibilities[v], lods[l], seen[i].name, small ? 160 : 320,
                     small ? 112 : 240);
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
            }
}

int main(void)
{
    for (size_t i = 0; i < COUNT(sky); i++) {
        begin(&exact);
        set(sky[i].set);
        draw("sky", "-", "", sky[i].name, i ? 160 : 320, i ? 112 : 240);
    }
    draw_seen();
    draw_shaded();
    return 0;
}
