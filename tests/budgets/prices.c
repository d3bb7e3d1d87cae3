/* SPDX-License-Identifier: MIT */
/* Measures the parts of the plan's cost table on a bare Cortex-M: draws the baked
 * prices.ini with all features off, then with one feature after another on, for each rung.
 * Prints the picture of each section of the plugin's counts; prices-count.awk takes the
 * differences. */
#include "base/base.h"
#include "cortex-m/baked.h"
#include "cortex-m/board.h"
#include "cortex-m/trace_marks.h"
#include "cortex-m/semihost.h"
#include "frame/tools.h"
#include "quality/prices.h"
#include "world/text.h"

#define BAND  16
#define STEPS 60                /* of pools and foam, until all of the water moves */

TRACE_MARK(count_as_frame)
TRACE_MARK(count_as_tiles)
TRACE_MARK(count_end)
TRACE_MARK(count_section)

static const char *const visibilities[] = { "triangles", "rows", "projected", "flat" };
static const char *const shadings[] = { "exact", "quick" };
static const char *const rates[] = { "full", "layers", "colour" };

#define COUNT(of) (sizeof of / sizeof *of)

/* -- scenes -------------------------------------------------------------------------- */

/* Scenes of prices.c: prices.ini with some features switched on. */
/* Settings, separated by blanks; a name without "=" enables the asset of that name. */
typedef struct {
    const char *name, *set;
} row;

#define OFF "water.specular=0 water.reflection=0 sky.haze=0 water.filter=nearest " \
            "water.rough=off " \
            "sky.kind=gradient ripple.bump=0 distortion.strength=0 "

#define STILL "wave0.amplitude=0 wave1.amplitude=0 wave2.amplitude=0 "

/* the pool is stirred before the frame: water at rest costs less */
#define POOL "pool.cols=64 pool.rows=64 pool.cell_bits=16 pool.cell=2 pool.max_height=2 " \
             "pool.boundary=tile pool.splash_interval=0.1 pool.splash_height=0.12 " \
             "pool.splash_width=8 "

#define BED   "sand floor.depth=3 floor.slope=0.05 floor.heading=160 "
#define CHART "sand map floor.map_size=400 floor.map_low=-6 floor.map_high=-3 "

static const row shaded[] = {
    { "unlit", "light.ambient=1" },
    { "plain", "" },
    { "texture", "layer0" },
    { "linear", "layer0 water.filter=linear" },
    { "bend", "layer0 distortion distortion.strength=0.9" },
    { "layer", "layer0 layer1" },
    { "lined", "layer0 layer1 layer2 water.filter=linear" },
    { "ripple", "ripple ripple.bump=0.8" },
    { "mirror", "water.reflection=0.6" },
    { "glint", "water.specular=1" },
    { "both", "water.reflection=0.6 water.specular=1" },
    { "rough", "water.reflection=0.6 water.specular=1 water.rough=on" },
    { "haze", "sky.haze=2000" },
    /* rippled: fast shading leaves smooth water under these skies to the exact stages */
    { "mirror1", "ripple ripple.bump=0.8 water.reflection=0.6" },
    { "dome0", "ripple ripple.bump=0.8 sky.kind=day" },
    { "dome", "ripple ripple.bump=0.8 sky.kind=day water.reflection=0.6" },
    { "cube0", "ripple ripple.bump=0.8 sky.kind=cube" },
    { "cube", "ripple ripple.bump=0.8 sky.kind=cube water.reflection=0.6" },
    { "objects0", "water.reflection=0.6 drops.count=1" },
    { "objects", "water.reflection=0.6 drops.count=1 mirror.method=stencil" },
    { "behind", "water.reflection=0.6 water.clarity=8" },
    { "bed0", "water.reflection=0.6 " BED },
    { "bed", "water.reflection=0.6 water.clarity=8 " BED },
    { "spread", "water.reflection=0.6 water.clarity=8 water.dispersion=0.02 " BED },
    { "caustic", "water.reflection=0.6 water.clarity=8 water.caustics=1 " BED },
    { "chart0", "water.reflection=0.6 " CHART },
    { "chart", "water.reflection=0.6 water.clarity=8 " CHART },
    { "tank0", "water.reflection=0.6 tank tank.kind=stone " POOL },
    { "tank", "water.reflection=0.6 water.clarity=8 tank tank.kind=stone " POOL },
    { "foam", "foam foam.cells=128 foam.cell=0.6 foam.crest=0.6 foam.fade=5" },
    { "expose", "hdr.exposure_factor=1.25" },
    { "bump", POOL "water.pool_normal_strength=1" },
};

static const row seen[] = {
    { "near", "" },
    { "dense", "grid.vertices=6666" },
    { "small", "" },            /* 160x112 */
    { "one", "wave1.amplitude=0 wave2.amplitude=0" },
    { "low", "camera.y=1.6 camera.pitch=-1 camera.fov=46 grid.vertices=2700 "
             "wave0.amplitude=0.1 wave1.amplitude=0.05 "
             "wave2.amplitude=0.03" },
    { "rough", "camera.y=2.6 camera.pitch=-1 camera.fov=50 grid.vertices=3333 "
               "camera.heading=32 wave0.amplitude=0.45 "
               "wave1.amplitude=0.3 wave2.amplitude=0.15" },
    { "turned", "camera.heading=28 camera.y=8 camera.pitch=-15 camera.fov=52" },
    /* triangles only */
    { "above", "camera.y=50 camera.pitch=-86 camera.fov=50 grid.vertices=4033" },
    { "gale", "camera.y=3.4 camera.pitch=0 camera.fov=52 grid.vertices=5200 "
              "wave0.amplitude=1.05 wave0.length=38 wave1.amplitude=0.7 wave1.length=25 "
              "wave2.amplitude=0.6 wave2.length=31 "
              "wave3.amplitude=0.85 wave3.length=47" },
    { "swell", "camera.heading=16 camera.y=1.6 camera.pitch=-1 camera.fov=46 "
               "grid.vertices=2700 "
               "wave0.amplitude=0.1 wave1.amplitude=0.05 wave2.amplitude=0.03" },
    { "still", STILL },
    { "sharp", "wave0.exponent=3" },
    { "pool", POOL },
    { "coastal", "wind.strength=0.2" },
    { "floor", "floor.depth=20 floor.slope=0.004" },
    { "map", "map floor.map_size=400 floor.map_low=-20 floor.map_high=-10" },
};

/* Further measurements: each scene is drawn beside another of these scenes. */
typedef struct {
    const char *name, *beside, *set;
} pair;

#define LEVEL   "camera.y=1.3 camera.pitch=-1 camera.fov=45 boat boat.z=-29 boat.x=2 " \
                "boat.heading=140 "
#define RAIN    "grid.vertices=9000 camera.y=1.6 camera.z=4.4 camera.pitch=-15 camera.fov=56 "
#define DROPS   "drops.count=64 drops.rings=64 drops.y=1.8 drops.radius=0.09 " \
                "drops.interval=0.5 drops.scatter_radius=1.8 drops.efficiency=0.9 "
#define BASIN   POOL "pool.cell=0.05 pool.max_height=0.6 pool.splash_height=0.15 " \
                "pool.splash_width=0.2 " \
                "tank.sea=off grid.vertices=4096 camera.x=2.85 camera.y=2.2 " \
                "camera.z=3.75 camera.heading=-37 camera.pitch=-31 camera.fov=50 "
#define AWAY    "camera.x=4 camera.y=2.6 camera.z=4 camera.heading=-45 camera.pitch=-26 "
#define FRONT   "camera.x=0.3 camera.y=1.2 camera.z=4 camera.heading=-4 camera.pitch=-16 "
#define GLASS   "tank tank.kind=glass "
#define FLOOR   "wave1.amplitude=0.1 wave2.amplitude=0 "
#define DENSE   "grid.vertices=4033 camera.y=6 "
#define LOW     "grid.vertices=2700 camera.y=2 " \
                "camera.heading=25 camera.pitch=-5 "
#define FINE    "grid.vertices=5633 " \
                "camera.y=1.5 camera.heading=50 camera.pitch=-3 "
#define SURF    "grid.vertices=8533 camera.x=-7 " \
                "camera.y=1.5 camera.z=11 camera.heading=60 camera.pitch=-4 camera.fov=60 "
#define SWELL   FLOOR "wave0.amplitude=0.62 wave0.length=24 wave0.heading=180 "
#define GALE    "wave0.exponent=4 wave0.steepness=0.6 "
#define RIPPLED "ripple ripple.bump=0.8 water.reflection=0.6 "
#define QUICK   "quality.shading=quick "
#define MIRROR  "mirror.method=stencil "
#define NEAR    "boat boat.z=-14 boat.x=2 boat.heading=60 "
#define FAR     "boat boat.z=-30 boat.x=-4 boat.heading=100 "
#define ALONG   "boat boat.z=-20 boat.x=5 boat.heading=10 "

static const pair works[] = {
    { "plain", "", "" },
    { "dome", "plain", "sky.kind=day" },
    { "dome_hdr", "dome", "sky.kind=day hdr.share=0.4" },
    { "night", "dome", "sky.kind=night" },
    { "cube", "plain", "sky.kind=cube" },
    { "cube_hdr", "cube", "sky.kind=cube hdr.share=0.4" },
    { "quick", "", QUICK },
    { "quick_dome", "quick", QUICK "sky.kind=day" },
    { "haze", "", "sky.haze=2000" },
    { "dome_haze", "dome", "sky.kind=day sky.haze=2000" },
    { "cube_haze", "cube", "sky.kind=cube sky.haze=2000" },
    { "mirror", "", RIPPLED "sky.kind=cube" },
    { "mirror_hdr", "mirror", RIPPLED "sky.kind=cube hdr.share=0.4" },
    { "still", "", STILL "camera.y=1.3 camera.pitch=-1 camera.fov=45" },
    { "near", "plain", NEAR },
    { "far", "plain", FAR },
    { "along", "plain", ALONG },
    { "near_haze", "haze", NEAR "sky.haze=2000" },
    { "along_haze", "cube_haze", ALONG "sky.kind=cube sky.haze=2000" },
    { "near_mirror0", "", NEAR RIPPLED "sky.kind=cube" },
    { "near_mirror", "near_mirror0", NEAR RIPPLED MIRROR "sky.kind=cube" },
    { "far_mirror0", "", FAR RIPPLED "sky.kind=cube" },
    { "far_mirror", "far_mirror0", FAR RIPPLED MIRROR "sky.kind=cube" },
    { "along_mirror0", "", ALONG RIPPLED "sky.kind=cube" },
    { "along_mirror", "along_mirror0", ALONG RIPPLED MIRROR "sky.kind=cube" },
    { "low_mirror0", "", FAR RIPPLED "sky.kind=cube camera.y=1.5 camera.pitch=-1" },
    { "low_mirror", "low_mirror0",
      FAR RIPPLED MIRROR "sky.kind=cube camera.y=1.5 camera.pitch=-1" },
    { "calm_mirror0", "", STILL LEVEL RIPPLED "sky.kind=cube" },
    { "calm_mirror", "calm_mirror0", STILL LEVEL RIPPLED MIRROR "sky.kind=cube" },
    { "calm", "still", STILL LEVEL },
    { "broad_mirror0", "", STILL LEVEL RIPPLED "sky.kind=cube boat.heading=75" },
    { "broad_mirror", "broad_mirror0",
      STILL LEVEL RIPPLED MIRROR "sky.kind=cube boat.heading=75" },
    { "high_mirror0", "", ALONG RIPPLED "sky.kind=cube boat.lift=4" },
    { "high_mirror", "high_mirror0", ALONG RIPPLED MIRROR "sky.kind=cube boat.lift=4" },
    { "sunk_mirror0", "", ALONG RIPPLED "sky.kind=cube boat.lift=-0.7" },
    { "sunk_mirror", "sunk_mirror0",
      ALONG RIPPLED MIRROR "sky.kind=cube boat.lift=-0.7" },
    { "quarter_mirror0", "", NEAR RIPPLED "sky.kind=cube" },
    { "quarter_mirror", "quarter_mirror0",
      NEAR RIPPLED MIRROR "sky.kind=cube mirror.size=quarter" },
    { "large_mirror0", "", ALONG RIPPLED "sky.kind=cube boat.scale=1.7" },
    { "large_mirror", "large_mirror0",
      ALONG RIPPLED MIRROR "sky.kind=cube boat.scale=1.7" },
    { "drops0", "", STILL RAIN },
    { "drops", "drops0", STILL RAIN DROPS },
    { "ball", "drops0", STILL RAIN DROPS "drops.interval=0" },
    { "ball_large", "drops0", STILL RAIN DROPS "drops.interval=0 drops.radius=0.25" },
    { "rain0", "", STILL RIPPLED "sky.kind=cube " RAIN DROPS },
    { "rain_mirror", "rain0", STILL RIPPLED MIRROR "sky.kind=cube " RAIN DROPS },
    { "rain1", "",
      STILL RIPPLED "sky.kind=cube " RAIN DROPS "camera.y=2.6 camera.pitch=-25" },
    { "rain1_mirror", "rain1",
      STILL RIPPLED MIRROR "sky.kind=cube " RAIN DROPS "camera.y=2.6 camera.pitch=-25" },
    { "pool0", "", STILL POOL },
    { "pool_tank", "pool0", STILL POOL "tank tank.kind=stone" },
    { "tank0", "", STILL POOL "tank tank.kind=stone tank.rim=1.4" },
    { "tank0_walled", "tank0", STILL POOL "tank tank.kind=stone tank.rim=1.4 walls" },
    { "tank2", "", STILL POOL "tank tank.kind=stone tank.rim=1 camera.heading=70" },
    { "tank2_walled", "tank2",
      STILL POOL "tank tank.kind=stone tank.rim=1 camera.heading=70 walls" },
    { "tank1", "", STILL POOL RIPPLED "sky.kind=cube tank tank.kind=stone walls" },
    { "tank1_mirror", "tank1",
      STILL POOL RIPPLED MIRROR "sky.kind=cube tank tank.kind=stone walls" },
    { "glass0", "", STILL BASIN },
    { "glass", "glass0", STILL BASIN GLASS },
    { "glass_far0", "", STILL BASIN AWAY },
    { "glass_far", "glass_far0", STILL BASIN AWAY GLASS },
    { "glass_low0", "", STILL BASIN AWAY },
    { "glass_low", "glass_low0", STILL BASIN AWAY GLASS "tank.depth=0.4" },
    { "glass_one0", "", STILL BASIN FRONT },
    { "glass_one", "glass_one0", STILL BASIN FRONT GLASS },
    { "lit0", "", STILL POOL "tank tank.kind=stone water.reflection=0.6 water.clarity=8" },
    { "lit", "lit0", STILL POOL "tank tank.kind=stone water.reflection=0.6 water.clarity=8 "
                     "water.caustics=1" },
    { "sunny0", "", BED "water.reflection=0.6 water.clarity=8" },
    { "sunny", "sunny0", BED "water.reflection=0.6 water.clarity=8 water.caustics=1" },
    { "deep", "", FLOOR "floor.depth=20 floor.slope=0.004" },
    { "beach", "deep", FLOOR "floor.depth=2.4 floor.slope=0.13 floor.heading=0" },
    { "beach_left", "deep", FLOOR "floor.depth=2.4 floor.slope=0.13 floor.heading=270" },
    { "beach_behind", "deep",
      FLOOR "floor.depth=2.4 floor.slope=0.13 floor.heading=150" },
    { "shelf", "deep", FLOOR "floor.depth=1.4 floor.slope=0.001 floor.heading=30" },
    { "chart0", "", "map floor.map_size=160 floor.map_low=-22 floor.map_high=-10" },
    { "chart", "chart0", "map floor.map_size=160 floor.map_low=-9 floor.map_high=3" },
    { "chart_near", "chart0", "map floor.map_size=90 floor.map_low=-6 floor.map_high=2" },
    { "deep_dense", "", FLOOR DENSE "floor.depth=20 floor.slope=0.004" },
    { "beach_dense", "deep_dense",
      FLOOR DENSE "floor.depth=2.4 floor.slope=0.13 floor.heading=250" },
    { "shelf_dense", "deep_dense",
      FLOOR DENSE "floor.depth=1.6 floor.slope=0.01 floor.heading=300" },
    { "chart_dense0", "",
      DENSE "map floor.map_size=160 floor.map_low=-22 floor.map_high=-10" },
    { "chart_dense", "chart_dense0",
      DENSE "map floor.map_size=160 floor.map_low=-9 floor.map_high=3" },
    { "deep_low", "", FLOOR LOW "floor.depth=20 floor.slope=0.004" },
    { "beach_low", "deep_low",
      FLOOR LOW "floor.depth=2.4 floor.slope=0.13 floor.heading=120" },
    { "shelf_low", "deep_low",
      FLOOR LOW "floor.depth=1.2 floor.slope=0.06 floor.heading=205" },
    { "deep_bare", "", FLOOR DENSE "floor.depth=20 floor.slope=0.004" },
    { "shelf_bare", "deep_bare",
      FLOOR DENSE "floor.depth=1.2 floor.slope=0.01 floor.heading=300" },
    { "deep_fine", "", FLOOR FINE "floor.depth=20 floor.slope=0.004" },
    { "beach_fine", "deep_fine",
      FLOOR FINE "floor.depth=2 floor.slope=0.1 floor.heading=160" },
    { "bank_fine", "deep_fine",
      FLOOR FINE "floor.depth=1.5 floor.slope=0.05 floor.heading=20" },
    { "spit_fine", "deep_fine",
      FLOOR FINE "floor.depth=1 floor.slope=0.03 floor.heading=100" },
    { "deep_far", "", FLOOR FINE "camera.y=3 camera.heading=75 floor.depth=20 "
                      "floor.slope=0.004" },
    { "bank_far", "deep_far",
      FLOOR FINE "camera.y=3 camera.heading=75 floor.depth=1.8 floor.slope=0.07 "
                 "floor.heading=190" },
    { "deep_surf", "", SWELL SURF "floor.depth=20 floor.slope=0.004" },
    { "beach_surf", "deep_surf",
      SWELL SURF "floor.depth=2.4 floor.slope=0.13 floor.heading=180" },
    { "gale0", "", GALE "spray.count=1" },
    { "gale", "gale0", GALE "spray.count=512 spray.crest=4" },
    { "small", "plain", ALONG "boat.scale=0.4" },
    { "large", "plain", FAR "boat.scale=2.5" },
    { "beside", "plain", "boat boat.z=-40 boat.x=20 boat.heading=30" },
};

static const row sky[] = {
    { "large", "camera.pitch=60" }, { "small", "camera.pitch=60" },
};

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
    const bool moves = scene.pool.cols > 0 || scene.drops.count > 1 || assets.foam
                    || scene.spray.count > 0;
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
    semihost_write("\n");
}

static const tp_rungs exact = { TP_VISIBILITY_TRIANGLES, TP_SHADING_EXACT, TP_RATE_FULL };

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
        for (size_t i = 0; i < COUNT(seen); i++) {
            tp_rungs rungs = exact;
            rungs.visibility = (tp_visibility)(v + 1);
            begin(&rungs);
            set(seen[i].set);
            const bool small = seen[i].name[1] == 'm';
            draw("seen", visibilities[v], "", seen[i].name, small ? 160 : 320,
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
