/* SPDX-License-Identifier: MIT */
/* Estimates of a frame's work: pixels are compared with drawn pixels, and all numbers with
 * tests/golden/works.txt, which lists views of shipped scenes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/tilings.h"
#include "app/scene/assets.h"
#include "app/files/path.h"
#include "tests/lib/listing.h"
#include "quality/prices.h"
#include "world/text.h"
#include <math.h>

static listing listed;

static const char *const names[] = {
#define X(name) #name,
    TP_WORKS(X)
#undef X
};

typedef struct {
    scene_file file;
    asset_set *assets;
    tp_view_estimate estimate;
    tp_fixed_cost   works;
} works_view;

/* True if both scenes load the same files: switches of features may add or spare files. */
static bool has_same_files(const tp_scene *a, const tp_scene *b)
{
    uint32_t count;
    const tp_param *row = tp_params(&count);
    bool same = true;

    for (uint32_t i = 0; i < count; i++) {
        const void *const x = (const char *)a + row[i].offset,
                   *const y = (const char *)b + row[i].offset;
        if (tp_param_is_file(&row[i]))
            same = same && !strcmp(x, y);
        else if (!tp_param_is_text(&row[i]) && row[i].kind != TP_PARAM_FX)
            same = same && !memcmp(x, y, sizeof(int32_t));
    }
    return same && a->boat.scale == b->boat.scale;
}

/* Assets of a scene, kept for the next view if that has the same. */
static asset_set *assets_of(const scene_file *file, const char *path)
{
    static asset_set loaded;
    static tp_scene scene;
    static char from[160];

    if (!strcmp(from, path) && has_same_files(&scene, &file->scene))
        return &loaded;
    assets_close(&loaded);
    assert_int_equal(assets_open(&loaded, file), 0);
    scene = file->scene;
    snprintf(from, sizeof from, "%s", path);
    return &loaded;
}

/* Opens a view: "pond camera.y=1" is a scene and settings of the scene. */
static void view_open(works_view *v, const char *of, uint32_t width, uint32_t height)
{
    char text[LISTING_CASE], path[160];

    snprintf(text, sizeof text, "%s", of);
    snprintf(path, sizeof path, "assets/scenes/%s.ini", strtok(text, " "));
    assert_int_equal(scene_file_open(&v->file, path), 0);
    for (char *setting; (setting = strtok(NULL, " ")) != NULL;)
        assert_int_equal(scene_file_set(&v->file, setting), 0);
    v->assets = assets_of(&v->file, path);
    const tp_plan_input in = { tp_program_all.modules, &v->file.scene, &v->assets->names,
                               width, height };
    v->estimate = tp_view_estimate_make(&in);
    v->works = tp_fixed_cost_estimate(&in, &v->estimate,
                                      v->file.scene.quality.shading == TP_SHADING_QUICK);
}

static void view_close(works_view *v)
{
    scene_file_close(&v->file);
}

/* -- the listing --------------------------------------------------------------------- */

static size_t add(char *to, size_t at, const char *name, int64_t number)
{
    return number ? at + (size_t)sprintf(to + at, "%s%s %lld", at ? ", " : "", name,
                                         (long long)number) : at;
}

/* Writes all numbers except zeros. */
static void tell(const works_view *v, char *to)
{
    const tp_view_estimate *o = &v->estimate;
    size_t at = add(to, 0, "water", o->water_pixels);

    at = add(to, at, "other", o->other_pixels);
    at = add(to, at, "vertices", o->vertices);
    at = add(to, at, "waves", o->waves);
    at = add(to, at, "near", o->near);
    for (int i = 0; i < TP_VISIBILITIES; i++)
        at = add(to, at, "points", o->points[i]);
    at = add(to, at, "hidden", v->works.hidden);
    at = add(to, at, "stopped", v->works.solid);
    for (int i = 0; i < TP_WORK_COUNT; i++)
        at = add(to, at, names[i], v->works.of[i]);
}

static void every_number_is_the_listed_one(void **state)
{
    static works_view v;
    int wrong = 0;

    (void)state;
    assert_true(listed.count > 50);
    for (uint32_t i = 0; i < listed.count; i++) {
        char of[LISTING_CASE], values[LISTING_VALUES] = "";
        listing_case(&listed, i, of);
        view_open(&v, of, 320, 240);
        tell(&v, values);
        view_close(&v);
        wrong += !listing_holds(&listed, i, of, values);
    }
    listing_write(&listed);
    assert_int_equal(wrong, 0);
}

static bool is_listed(const char *scene)
{
    const size_t bytes = strlen(scene);

    for (uint32_t i = 0; i < listed.count; i++)
        if (!strncmp(listed.line[i], scene, bytes) && listed.line[i][bytes] == ':')
            return true;
    return false;
}

static void every_shipped_scene_is_listed(void **state)
{
    size_t count;
    char **scenes = path_scene_names("assets/scenes", &count);

    (void)state;
    assert_true(count > 0);
    for (size_t i = 0; i < count; i++)
        if (!is_listed(scenes[i]))
            fail_msg("tests/golden/works.txt has no line \"%s:\"", scenes[i]);
    path_free_names(scenes, count);
}

static void every_kind_of_work_is_listed(void **state)
{
    (void)state;
    for (int i = 0; i < TP_WORK_COUNT; i++) {
        char name[64];
        uint32_t n = 0;
        snprintf(name, sizeof name, ", %s ", names[i]);
        while (n < listed.count && !strstr(listed.line[n], name))
            n++;
        if (n == listed.count)
            fail_msg("no view of tests/golden/works.txt has %s", names[i]);
    }
}

/* -- comparison with drawn pixels ---------------------------------------------------- */

enum { WIDTH = 160, HEIGHT = 120 };

/* Shares of the picture in percent: visible water, sky, everything else. */
typedef struct {
    double water, sky, other;
} pixel_shares;

static double most_of(const uint32_t *work, int from, int to)
{
    uint32_t most = 0;

    for (int i = from; i <= to; i++)
        most = work[i] > most ? work[i] : most;
    return most;
}

/* Stars are counted in addition to the sky behind the stars. */
static pixel_shares estimated(const works_view *v)
{
    const double all = WIDTH * HEIGHT / 100.0;

    return (pixel_shares){ (v->estimate.water_pixels - v->works.hidden) / all,
                           most_of(v->works.of, TP_WORK_sky_dome, TP_WORK_sky_cube) / all,
                           v->works.solid / all };
}

static pixel_shares drawn(const works_view *v)
{
    static const tp_config config = { .width = WIDTH,
                                      .height = HEIGHT,
                                      .tile_height = HEIGHT };
    static uint32_t key[WIDTH * HEIGHT];
    const double all = WIDTH * HEIGHT / 100.0;
    tp_world *world = scene_world(&v->file.scene, &v->assets->names);

    marks_draw(&v->file.scene, &v->assets->names, world, config, key, NULL);
    free(world);
    const double water = marks_count(key, WIDTH * HEIGHT, MARKS_WATER) / all;
    const double sky = marks_count(key, WIDTH * HEIGHT, MARKS_SKY) / all;
    return (pixel_shares){ water, sky, 100 - water - sky };
}

/* At the first tick.  A plain sky has no cost and is not counted. */
static void pixels_are_within_4_percent_of_the_picture(void **state)
{
    static works_view v;
    size_t count;
    char **scenes = path_scene_names("assets/scenes", &count);

    (void)state;
    assert_true(count > 0);
    for (size_t i = 0; i < count; i++) {
        view_open(&v, scenes[i], WIDTH, HEIGHT);
        const pixel_shares e = estimated(&v), d = drawn(&v);
        view_close(&v);
        printf("    %-14s water %5.1f of %5.1f, sky %5.1f of %5.1f, else %5.1f of %5.1f\n",
               scenes[i], e.water, d.water, e.sky, d.sky, e.other, d.other);
        assert_true(fabs(e.water - d.water) < 2);
        assert_true(e.sky == 0 || fabs(e.sky - d.sky) < 4);
        assert_true(fabs(e.other - d.other) < 4);
    }
    path_free_names(scenes, count);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_number_is_the_listed_one),
        cmocka_unit_test(every_shipped_scene_is_listed),
        cmocka_unit_test(every_kind_of_work_is_listed),
        cmocka_unit_test(pixels_are_within_4_percent_of_the_picture),
    };

    listing_read(&listed, "tests/golden/works.txt", argc, argv);
    return cmocka_run_group_tests_name("quality/fixed_cost", tests, NULL, NULL);
}
