/* SPDX-License-Identifier: MIT */
/* Every program variant usable on this processor draws every shipped scene with the same
 * bits. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "../../ports/app/files/path.h"
#include "../../ports/app/scene/loaded_scene.h"

#define FOLDER "assets/scenes"

enum { FRAMES = 3, MACHINES = 8 };

/* CRCs of ticks 30, 31, 32, in formats with full or dithered colours. */
static void draw(loaded_scene *s, options *o, uint32_t crc[FRAMES])
{
    o->format = TP_FORMAT_XRGB8888;
    assert_int_equal(loaded_scene_make_world(s), 0);
    for (int i = 0; i < 30; i++)
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
    for (int i = 0; i < FRAMES; i++) {
        assert_int_equal(loaded_scene_open_renderer(s, o), 0);
        frame_renderer_draw(&s->renderer, s->world);
        crc[i] = picture_crc(&s->renderer.picture);
        tp_world_step(&tp_program_all, s->world, &s->file.scene, NULL);
        o->format = i == 0 ? TP_FORMAT_RGB565 : TP_FORMAT_P8;
    }
}

static void check_scene(const char *name, const machine *machines, size_t count)
{
    options o = { .scene = name, .width = 200, .height = 150, .threads = 2 };
    uint32_t crc[MACHINES][FRAMES];
    loaded_scene s;
    assert_int_equal(loaded_scene_open(&s, &o), 0);
    for (size_t k = 0; k < count; k++) {
        o.machine = &machines[k];
        draw(&s, &o, crc[k]);
        assert_ptr_equal(s.renderer.machine, &machines[k]);
        if (memcmp(crc[k], crc[0], sizeof crc[k]))
            fail_msg("%s is another picture by %s", name, machines[k].name);
    }
    loaded_scene_close(&s);
}

static void every_machine_draws_every_scene_alike(void **state)
{
    size_t programs, count;
    const machine *machines = machine_list(&programs);
    char **names = path_scene_names(FOLDER, &count);
    (void)state;
    assert_true(count > 0 && programs > 0 && programs <= MACHINES);
    for (size_t i = 0; i < count; i++) {
        char *path = path_join(FOLDER, names[i], ".ini");
        check_scene(path, machines, programs);
        free(path);
    }
    path_free_names(names, count);
}

static void the_last_machine_runs_everywhere(void **state)
{
    size_t count;
    const machine *machines = machine_list(&count);
    (void)state;
    assert_string_equal(machines[count - 1].name, "baseline");
    assert_ptr_equal(machines[count - 1].program, &tp_program_all);
    for (size_t k = 0; k + 1 < count; k++)      /* the other variants are other code */
        assert_ptr_not_equal(machines[k].program->stage.view, tp_program_all.stage.view);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_machine_draws_every_scene_alike),
        cmocka_unit_test(the_last_machine_runs_everywhere),
    };
    return cmocka_run_group_tests_name("machines", tests, NULL, NULL);
}
