/* SPDX-License-Identifier: MIT */
/* Scanline water reads only the boxes of its own cells. */
#define _DEFAULT_SOURCE         /* for MAP_ANONYMOUS */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <sys/mman.h>
#include <unistd.h>
#include "frame/scanline_grid.h"
#include "tests/lib/scenes.h"
#include "tests/lib/frames.h"

enum { WIDTH = 160, HEIGHT = 90 };

static uint64_t chance;

/* Boxes that end at the end of a memory page: a frame is one block, where no sanitizer sees
 * the end of an array. */
typedef struct {
    uint8_t     *pages;
    size_t       bytes;         /* with the last page, which cannot be read */
    tp_grid_box *box;
} guarded;

static guarded guarded_copy(const tp_grid_box *box, size_t count)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE), bytes = count * sizeof *box;
    guarded g = { .bytes = (bytes + page - 1) / page * page + page };

    g.pages = mmap(NULL, g.bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1,
                   0);
    assert_true(g.pages != MAP_FAILED);
    assert_int_equal(mprotect(g.pages + g.bytes - page, page, PROT_NONE), 0);
    g.box = (tp_grid_box *)(void *)(g.pages + g.bytes - page - bytes);
    memcpy(g.box, box, bytes);
    return g;
}

/* A grid with the most vertices, whose near rows the near plane clips. */
static tp_scene scene_wide(void)
{
    tp_scene s = scene_plain();

    s.quality.visibility = TP_VISIBILITY_ROWS;
    s.grid.vertices = 65536;
    s.camera.near = 10 * TP_FX_ONE;
    s.camera.y = chance_fx(&chance, 3, 6);
    s.camera.heading = chance_int(&chance, 0, 1) * 180 * TP_FX_ONE;
    s.camera.pitch = chance_fx(&chance, -25, 0);
    return s;
}

static int count_cut(const tp_frame_lines *lines)
{
    int count = 0;

    for (uint32_t k = 0; k + 1 < lines->lines; k++)
        count += lines->line[k].is & TP_LINE_CUT;
    return count;
}

static void no_box_beyond_the_last_is_read(void **state)
{
    (void)state;
    const tp_config config = { .width = WIDTH,
                               .height = HEIGHT,
                               .tile_height = HEIGHT,
                               .format = TP_FORMAT_XRGB8888 };
    const tp_assets none = { .boat = NULL };
    int cut = 0;

    for (int n = 0; n < 60; n++) {
        const tp_scene scene = scene_wide();
        test_frame f = frame_of(&scene, &none, &config);
        tp_world *world = scene_world(&scene, &none);
        tp_frame_begin(f.frame, world);
        assert_int_equal(f.frame->visibility, TP_VISIBILITY_ROWS);
        tp_frame_lines *lines = f.frame->buffers.lines;
        guarded g = guarded_copy(lines->box, (lines->lines - 1) * lines->blocks);
        tp_tile tile;
        lines->box = g.box;
        assert_true(tp_frame_draw_tile(f.frame, 0, f.scratch, &tile));
        cut += count_cut(lines);
        assert_int_equal(munmap(g.pages, g.bytes), 0);
        frame_free(&f);
        free(world);
    }
    printf("    %d rows are cut\n", cut);
    assert_true(cut > 5);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_box_beyond_the_last_is_read),
    };
    return cmocka_run_group_tests_name("frame/scanline_grid", tests, NULL, NULL);
}
