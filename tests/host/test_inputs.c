/* SPDX-License-Identifier: MIT */
/* Every shipped scene accepts any input: 200 ticks with random 32 bits in each number,
 * drawn now and then, with picks under pixels and probes at random places. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>
#include "../../ports/app/files/path.h"
#include "../../ports/app/scene/loaded_scene.h"
#include "tests/lib/random.h"
#include "world/world.h"

#define FOLDER "assets/scenes"

enum { WIDTH = 64, HEIGHT = 48, TICKS = 200 };

static uint64_t chance;

static void run(loaded_scene *s)
{
    for (int n = 1; n <= TICKS; n++) {
        const tp_input in = chance_input(&chance);
        tp_vec3 at;
        tp_world_step(&tp_program_all, s->world, &s->file.scene, &in);
        tp_world_sample(&tp_program_all, s->world, chance_word(&chance),
                        chance_word(&chance));
        if (n % 25 != 0)
            continue;
        tp_world_advance_clock(s->world);
        frame_renderer_draw(&s->renderer, s->world);
        tp_world_pick(&tp_program_all, s->world, &s->file.scene, WIDTH, HEIGHT,
                      chance_int(&chance, 0, WIDTH << 16),
                      chance_int(&chance, 0, HEIGHT << 16), &at);
    }
}

static void shipped_scenes_take_any_input(void **state)
{
    size_t programs, count;
    const machine *machines = machine_list(&programs);
    char **names = path_scene_names(FOLDER, &count);

    (void)state;
    assert_true(count > 0 && programs > 0);
    for (size_t i = 0; i < count; i++) {
        char *path = path_join(FOLDER, names[i], ".ini");
        const options o = { .scene = path,
                            .width = WIDTH,
                            .height = HEIGHT,
                            .threads = 1,
                            .machine = &machines[programs - 1] };
        loaded_scene s;
        assert_int_equal(loaded_scene_open(&s, &o), 0);
        run(&s);
        loaded_scene_close(&s);
        free(path);
    }
    path_free_names(names, count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shipped_scenes_take_any_input),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("inputs", tests, NULL, NULL);
}
