/* SPDX-License-Identifier: MIT */
/* three-swells in every pixel format, cut into tiles of every kind, against its golden
 * frames.  With `--write` the references are made anew instead. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include "golden.h"

#define FOLDER "tests/golden/three-swells"
#define WRECK  "build/golden"

static golden_scene scene;

static const uint32_t strips[] = { 16, 48, 64, GOLDEN_WIDTH };
static const uint32_t bands[] = { 1, 7, 16, GOLDEN_HEIGHT };

static int draw_and_compare(tp_format format, uint32_t index, uint32_t strip,
                            uint32_t band)
{
    char name[64];
    snprintf(name, sizeof name, "%s-%ux%u-%04u", tp_format_name(format), strip, band,
             golden_frames[index]);
    picture p = golden_draw(&scene, index, format, strip, band);
    bool right = golden_compare(FOLDER, WRECK, &p, golden_frames[index], name);
    golden_free(&p);
    return !right;
}

static void every_tiling_gives_the_reference(void **state)
{
    const tp_format format = *(const tp_format *)*state;
    int wrong = 0;
    for (uint32_t index = 0; index < GOLDEN_FRAMES; index++)
        for (size_t s = 0; s < sizeof strips / sizeof *strips; s++)
            for (size_t b = 0; b < sizeof bands / sizeof *bands; b++)
                wrong += draw_and_compare(format, index, strips[s], bands[b]);
    assert_int_equal(wrong, 0);
}

static void write_references(void)
{
    for (int format = 0; format < TP_FORMAT_COUNT; format++)
        for (uint32_t index = 0; index < GOLDEN_FRAMES; index++) {
            picture p = golden_draw(&scene, index, (tp_format)format, GOLDEN_WIDTH,
                                    GOLDEN_HEIGHT);
            golden_write(FOLDER, &p, golden_frames[index], index == 0);
            golden_free(&p);
        }
}

int main(int argc, char **argv)
{
    static tp_format format[TP_FORMAT_COUNT];
    static char name[TP_FORMAT_COUNT][64];
    struct CMUnitTest tests[TP_FORMAT_COUNT];
    int failed = 0;

    if (!golden_open(&scene, "assets/scenes/three-swells.ini"))
        return 1;
    mkdir(WRECK, 0777);
    setvbuf(stdout, NULL, _IOLBF, 0);       /* in step with cmocka's lines on stderr */
    if (argc == 2 && !strcmp(argv[1], "--write")) {
        mkdir(FOLDER, 0777);
        write_references();
    } else {
        for (int i = 0; i < TP_FORMAT_COUNT; i++) {
            format[i] = (tp_format)i;
            snprintf(name[i], sizeof name[i], "every_tiling_of_%s_gives_the_reference",
                     tp_format_name(format[i]));
            tests[i] = (struct CMUnitTest){ name[i], every_tiling_gives_the_reference,
                                            NULL, NULL, &format[i] };
        }
        failed = cmocka_run_group_tests_name("golden frames", tests, NULL, NULL);
    }
    golden_close(&scene);
    return failed;
}
