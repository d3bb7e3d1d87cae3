/* SPDX-License-Identifier: MIT */
/* Random scenes of the whole range of the parameter table: grids to 1024 points a side,
 * pools to 512 cells, pictures to 2048 pixels, any format, tiling and program.  A scene
 * refused by tp_scene_check is refused by every entry point; any other scene is stepped,
 * sampled for heights at any 32-bit position, and drawn whole and in tiles, where possible
 * with another program of equal results.  UBSan and ASan detect faults inside.
 *
 *     TP_SOAK=1       the whole range; otherwise sides stay small, for seconds
 *     TP_WIDE=n       number of scenes, default 12, or 1500 with TP_SOAK
 *     TP_FIRST=n      from number n on: with TP_SEED and TP_WIDE=1 one scene alone */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "app/scene/machine.h"
#include "quality/plan.h"
#include "world/pools.h"
#include "tests/lib/programs.h"
#include "tests/lib/tilings.h"

#define HIGHEST (2200 * (int64_t)TP_FX_ONE)     /* 16 waves, 1024 rings, two pools */

/* Limit of a frame's tiles times the points of its grid: a tile scans the grid's lines, or
 * evaluates all points that are not stored. */
#define TILED_MOST 60000000u

static uint64_t seed, chance;
static test_kit kit;
static test_twice twice;
static struct { uint32_t drawn, frames, refused, unfit; } counts;

static bool soak(void)
{
    return getenv("TP_SOAK") != NULL;
}

static uint32_t asked(const char *name, uint32_t usual)
{
    const char *text = getenv(name);
    return text ? (uint32_t)strtoul(text, NULL, 10) : usual;
}

/* -- scenes ---------------------------------------------------------------------------- */

/* Returns a side in [low, high], uniform in the logarithm; some sides are at an end. */
static int32_t any_side(int32_t low, int32_t high)
{
    switch (random_below(&chance, 16)) {
    case 0:  return low;
    case 1:
    case 2:  return high;
    default: return (int32_t)lround(low * pow((double)high / low,
                                              chance_double(&chance, 0, 1)));
    }
}

static void size_lattices(tp_scene *s)
{
    const int32_t cells = soak() ? 512 : 48;
    const bool pool = random_below(&chance, 2), field = random_below(&chance, 4) == 0;

    s->grid.vertices = any_side(64, soak() ? 65536 : 2048);
    s->pool.cols = pool ? any_side(16, cells) : 0;
    s->pool.rows = any_side(16, cells);
    s->field.cols = field ? any_side(16, cells) : 0;
    s->field.rows = any_side(16, cells);
}

/* Makes the numbers of a pool consistent. */
static void fit_pool(tp_scene_pool *p)
{
    p->courant = chance_fx(&chance, 0.25, 0.48);
    if (p->drive_min > p->drive_max)
        p->drive_min = p->drive_max;
}

/* A random scene; most scenes are drawn, the others are refused for their pools. */
static tp_scene any_scene(void)
{
    tp_scene s = scene_any(&chance);

    if (random_below(&chance, 4)) {
        kit_gather(&s, &chance);
        kit_switch_on(&s, &chance);
    }
    size_lattices(&s);
    if (random_below(&chance, 8)) {
        fit_pool(&s.pool);
        fit_pool(&s.field);
    }
    return s;
}

/* Sets one number just outside its range, or far outside. */
static void spoil(tp_scene *s)
{
    uint32_t count = 0;
    const tp_param *rows = tp_params(&count), *row;

    do
        row = &rows[random_below(&chance, count)];
    while (!scene_is_number(row));
    const int64_t value[] = { (int64_t)row->low - 1, (int64_t)row->high + 1, INT32_MIN,
                              INT32_MAX };
    const int64_t to = value[random_below(&chance, 4)];
    if (to >= INT32_MIN && to <= INT32_MAX)
        *scene_number(s, row) = (int32_t)to;
}

/* A config with tiles of any size, in a number that does not take minutes. */
static tp_config any_config(const tp_scene *s)
{
    const int32_t most = soak() ? 2048 : 96;
    tp_config c = {
        .width = (uint32_t)any_side(16, most),
        .height = (uint32_t)any_side(16, most),
        .format = (tp_format)random_below(&chance, TP_FORMAT_COUNT),
    };
    const uint64_t points = 4000 + (uint64_t)tp_fan_budget(s);
    uint64_t tiles;

    do {
        c.tile_width = 16 * random_below(&chance, c.width / 16 + 1);
        c.tile_height = random_below(&chance, c.height);
        const uint64_t w = c.tile_width ? c.tile_width : c.width;
        const uint64_t h = c.tile_height ? c.tile_height : c.height;
        tiles = ((c.width + w - 1) / w) * ((c.height + h - 1) / h);
    } while (tiles > 1 && tiles * points > TILED_MOST);
    return c;
}

/* -- programs -------------------------------------------------------------------------- */

typedef struct {
    tp_program by, tiled_by;
    const char *name;
} programs;

/* Picks a pair of programs that draw the same bits, for the whole picture and for tiles. */
static programs any_programs(void)
{
    size_t count;
    const machine *machines = machine_list(&count);
    programs k = { tp_program_all, tp_program_all, "all" };

    switch (random_below(&chance, 8)) {
    case 0:
    case 1:
        k = (programs){ .by = thin_program(&chance), .name = "thin" };
        k.tiled_by = k.by;
        break;
    case 2:
    case 3:
        k.name = "streamed";
        k.tiled_by.method.triangles = &tp_method_streamed;
        break;
    case 4:
    case 5:
        k.name = machines[0].name;
        k.tiled_by = *machines[0].program;
        break;
    default:
        break;
    }
    return k;
}

/* -- refused scenes -------------------------------------------------------------------- */

static void assert_refusal(tp_status status, const tp_error *err, tp_status as,
                           const tp_error *why)
{
    assert_int_equal(status, as);
    assert_int_equal(err->code, as);
    assert_string_equal(err->word, why->word);
}

static void assert_refused(const tp_scene *scene, const tp_assets *assets, tp_status as,
                           const tp_error *why)
{
    const tp_config config = {
        .width = 64, .height = 48, .tile_height = 48, .format = TP_FORMAT_RGB565
    };
    static uint64_t block[8192], before[8192];
    tp_scene plain = scene_plain();
    tp_world *world = (tp_world *)(void *)block;
    tp_frame *frame = NULL;
    tp_error err = { 0 };

    assert_true(why->word[0] != '\0');
    assert_int_equal(tp_world_bytes(&tp_program_all, scene, assets), 0);
    assert_int_equal(tp_frame_bytes(&config, scene), 0);
    assert_refusal(
        tp_world_init(&tp_program_all, world, sizeof block, scene, assets, &err), &err,
        as, why);
    assert_refusal(tp_frame_init(&frame, &config, scene, block,
                                 tp_frame_bytes(&config, scene), &err),
                   &err, as, why);
    plain.boat.mesh[0] = '\0';
    assert_int_equal(
        tp_world_init(&tp_program_all, world, sizeof block, &plain, NULL, NULL), TP_OK);
    memcpy(before, block, sizeof block);
    assert_false(tp_world_apply(&tp_program_all, world, scene, assets));
    assert_memory_equal(before, block, sizeof block);
    assert_int_equal(tp_plan_make(scene, assets, 64, 48).price.cost, 0);
}

/* -- drawn scenes ---------------------------------------------------------------------- */

static void ask(const programs *k, const tp_world *world, int places)
{
    while (places-- > 0) {
        const tp_water p = tp_world_sample(&k->by, world, chance_word(&chance),
                                           chance_word(&chance));
        assert_true(llabs((int64_t)p.height) <= HIGHEST);
    }
}

static void step(const programs *k, tp_world *world, const tp_scene *scene)
{
    for (int n = chance_int(&chance, 1, 8); n > 0; n--) {
        const tp_input input = chance_input(&chance);
        tp_world_step(&k->by, world, scene, n % 2 ? &input : NULL);
        ask(k, world, 4);
    }
    for (uint32_t n = tp_world_advance_clock(world); n > 0; n--)
        tp_world_step(&k->by, world, scene, NULL);
}

static void draw(const tp_world *world)
{
    twice_draw(&twice, world);
    counts.frames += 2;
}

/* The same frames with numbers of another scene, except those that size the grid; the world
 * continues if it accepts the numbers. */
static void live_on(const programs *k, tp_world *world, tp_scene *scene,
                    const tp_assets *assets)
{
    const tp_scene other = any_scene(), before = *scene;
    const uint32_t one_in = 1u << random_below(&chance, 8);
    uint32_t count = 0;
    const tp_param *row = tp_params(&count);

    for (uint32_t i = 0; i < count; i++)
        if (scene_is_number(&row[i]) && random_below(&chance, one_in) == 0)
            *scene_number(scene, &row[i]) = *(const int32_t *)(const void *)(
                (const char *)&other + row[i].offset);
    scene->grid.vertices = before.grid.vertices;
    if (!tp_world_apply(&k->by, world, scene, assets)) {
        *scene = before;
        assert_true(tp_world_apply(&k->by, world, scene, assets));
    }
    step(k, world, scene);
    draw(world);
}

/* Draws the scene.  False if an asset does not fit the scene, which only an init function
 * can detect. */
static bool draw_scene(const programs *k, tp_scene *scene, const tp_assets *assets,
                       const tp_config *config)
{
    const size_t bytes = tp_world_bytes(&k->by, scene, assets);
    tp_world *world = malloc(bytes > sizeof *world ? bytes : sizeof *world);
    tp_error err = { 0 };

    assert_non_null(world);
    const tp_status status = tp_world_init(&k->by, world, bytes, scene, assets, &err);
    assert_int_equal(status == TP_OK, bytes > 0);
    if (status == TP_OK) {
        twice.by = &k->by;
        twice.tiled_by = &k->tiled_by;
        twice.backwards = random_below(&chance, 2);
        twice_begin_at(&twice, scene, assets, config);
        draw(world);
        step(k, world, scene);
        draw(world);
        if (random_below(&chance, 3) == 0)
            live_on(k, world, scene, assets);
        twice_end(&twice);
    } else {
        assert_true(err.code == status && err.word[0] != '\0');
    }
    free(world);
    return status == TP_OK;
}

static void tell(uint32_t number, const tp_scene *s, const tp_config *c, const char *how)
{
    printf("# %u: grid %d, pool %dx%d, field %dx%d, picture %ux%u %s, tiles %ux%u, %s\n",
           (unsigned)number, (int)s->grid.vertices, (int)s->pool.cols,
           (int)s->pool.rows, (int)s->field.cols, (int)s->field.rows, (unsigned)c->width,
           (unsigned)c->height, tp_format_name(c->format), (unsigned)c->tile_width,
           (unsigned)c->tile_height, how);
    fflush(stdout);             /* the next step may end in a crash */
}

static void run_scene(uint32_t number)
{
    uint64_t begin = seed + number;
    chance = random_next(&begin);
    tp_scene scene = any_scene();
    const tp_assets assets = kit_assets(&kit, &scene, &chance);
    const programs k = any_programs();
    tp_error err = { 0 };

    if (random_below(&chance, 16) == 0)
        spoil(&scene);
    const tp_status status = tp_scene_check(&scene, &err);
    if (status != TP_OK) {
        printf("# %u: refused for %s\n", (unsigned)number, err.word);
        assert_refused(&scene, &assets, status, &err);
        counts.refused++;
        return;
    }
    const tp_config config = any_config(&scene);
    tell(number, &scene, &config, k.name);
    if (draw_scene(&k, &scene, &assets, &config))
        counts.drawn++;
    else
        counts.unfit++;
}

static void random_scenes_of_the_whole_range_are_safe(void **state)
{
    (void)state;
    const uint32_t first = asked("TP_FIRST", 0);
    const uint32_t count = asked("TP_WIDE", soak() ? 1500 : 12);

    for (uint32_t i = first; i < first + count; i++)
        run_scene(i);
    printf("# %u scenes: %u drawn in %u frames, %u refused, %u named what does not fit\n",
           (unsigned)count, (unsigned)counts.drawn, (unsigned)counts.frames,
           (unsigned)counts.refused, (unsigned)counts.unfit);
    twice_print(&twice.reached);
    assert_true(count < 12 || counts.drawn > count / 2);
    assert_true(count < 500 || (twice_reached_all(&twice.reached) && counts.refused > 0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_scenes_of_the_whole_range_are_safe),
    };
    seed = chance = random_seed();
    kit_make(&kit, &chance);
    return cmocka_run_group_tests_name("stability of wide scenes", tests, NULL, NULL);
}
