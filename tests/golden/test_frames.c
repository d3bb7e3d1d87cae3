/* SPDX-License-Identifier: MIT */
/* Compares every shipped scene and every scene of tests/golden/scenes with its golden
 * frames, in several tilings; three-swells and fast-packed in every pixel format and in more
 * tilings.
 * `--write` makes new references, for the scenes named behind it or for all scenes. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "tests/lib/golden.h"
#include "app/files/path.h"
#include "pixel/pixel.h"

#define WRECK "build/golden"
#define MOST  64            /* scenes */

typedef struct {
    const char *scene;
    bool whole;             /* test every format and tiling */
    char title[96];
} frame_job;

static const uint32_t strips[] = { 48, GOLDEN_WIDTH, 16, 64 };
static const uint32_t bands[] = { 7, GOLDEN_HEIGHT, 1, 16 };

static void folder_of(char *folder, size_t bytes, const char *scene)
{
    snprintf(folder, bytes, "tests/golden/%s", scene);
}

static int draw_and_compare(const golden_scene *g, const char *scene, tp_format format,
                            uint32_t index, uint32_t strip, uint32_t band)
{
    char name[128], folder[256];
    folder_of(folder, sizeof folder, scene);
    snprintf(name, sizeof name, "%s-%s-%ux%u-%04u", scene, tp_format_name(format),
             (unsigned)strip, (unsigned)band, (unsigned)golden_frames[index]);
    picture p = golden_draw(g, index, format, strip, band);
    bool right = golden_compare(folder, WRECK, &p, golden_frames[index], name);
    golden_free(&p);
    return !right;
}

/* Tries the first `kinds` strip widths with the first `kinds` band heights.  Returns the
 * failures. */
static int wrong_tilings(const golden_scene *g, const char *scene, tp_format format,
                         size_t kinds)
{
    int wrong = 0;
    for (uint32_t index = 0; index < GOLDEN_FRAMES; index++)
        for (size_t s = 0; s < kinds; s++)
            for (size_t b = 0; b < kinds; b++)
                wrong += draw_and_compare(g, scene, format, index, strips[s], bands[b]);
    return wrong;
}

static void open_scene(golden_scene *g, const char *scene)
{
    char path[256];
    snprintf(path, sizeof path, "tests/golden/scenes/%s.ini", scene);
    if (access(path, R_OK) != 0)
        snprintf(path, sizeof path, "assets/scenes/%s.ini", scene);
    if (!golden_open(g, path))
        exit(1);
}

static void every_tiling_gives_the_reference(void **state)
{
    const frame_job *j = *state;
    golden_scene g;
    int wrong = 0;
    open_scene(&g, j->scene);
    if (j->whole)
        for (int format = 0; format < TP_FORMAT_COUNT; format++)
            wrong += wrong_tilings(&g, j->scene, (tp_format)format, 4);
    else
        wrong = wrong_tilings(&g, j->scene, TP_FORMAT_XRGB8888, 2);
    golden_close(&g);
    assert_int_equal(wrong, 0);
}

static void write_references(const char *scene, bool whole)
{
    golden_scene g;
    char folder[256];
    folder_of(folder, sizeof folder, scene);
    mkdir(folder, 0777);
    printf("%s\n", scene);
    open_scene(&g, scene);
    for (int format = 0; format < (whole ? TP_FORMAT_COUNT : 1); format++)
        for (uint32_t index = 0; index < GOLDEN_FRAMES; index++) {
            picture p = golden_draw(&g, index, (tp_format)format, GOLDEN_WIDTH,
                                    GOLDEN_HEIGHT);
            golden_write(folder, &p, golden_frames[index], index == 0);
            golden_free(&p);
        }
    golden_close(&g);
}

static bool is_whole(const char *scene)
{
    return strcmp(scene, "three-swells") == 0 || strcmp(scene, "fast-packed") == 0;
}

static int compare_all(const char *const *names, size_t count)
{
    static frame_job jobs[MOST];
    struct CMUnitTest tests[MOST];
    for (size_t i = 0; i < count; i++) {
        jobs[i].scene = names[i];
        jobs[i].whole = is_whole(names[i]);
        snprintf(jobs[i].title, sizeof jobs[i].title,
                 "every_tiling_of_%s_gives_the_reference", names[i]);
        tests[i] = (struct CMUnitTest){ jobs[i].title, every_tiling_gives_the_reference,
                                        NULL, NULL, &jobs[i] };
    }
    return _cmocka_run_group_tests("golden frames", tests, count, NULL, NULL);
}

int main(int argc, char **argv)
{
    size_t shipped = 0, own = 0, count = 0;
    char **of_shipped = path_scene_names("assets/scenes", &shipped);
    char **of_own = path_scene_names("tests/golden/scenes", &own);
    const char *names[MOST];
    int failed = shipped == 0 || own == 0 || shipped + own > MOST;

    for (size_t i = 0; i < shipped && !failed; i++)
        names[count++] = of_shipped[i];
    for (size_t i = 0; i < own && !failed; i++)
        names[count++] = of_own[i];
    mkdir(WRECK, 0777);
    setvbuf(stdout, NULL, _IOLBF, 0);       /* in order with cmocka's stderr */
    if (argc >= 2 && !strcmp(argv[1], "--write")) {
        for (int i = 2; i < argc; i++)
            write_references(argv[i], is_whole(argv[i]));
        for (size_t i = 0; i < count && argc == 2; i++)
            write_references(names[i], is_whole(names[i]));
    } else if (!failed) {
        failed = compare_all(names, count);
    }
    path_free_names(of_shipped, shipped);
    path_free_names(of_own, own);
    return failed;
}
