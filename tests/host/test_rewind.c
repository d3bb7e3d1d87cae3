/* SPDX-License-Identifier: MIT */
/* Rewinding: every kept frame is restored bit for bit, after any actions and within any
 * budget. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../../ports/app/session/rewind.h"
#include "tests/lib/worlds.h"

#define MB ((size_t)1 << 20)

static uint64_t chance;

/* A moving scene, its whole history, and the kept part. */
typedef struct {
    tp_scene  scene;
    tp_world *world;
    size_t    bytes;
    rewind_history     *history;
    uint32_t  picture, first;   /* next frame; first frame of `was` */
    char    **was;              /* scene and world before each frame */
    uint32_t  room;
} past_show;

static past_show show_of(const tp_scene *scene, size_t budget)
{
    past_show s = { .scene = *scene, .world = scene_world(scene, NULL), .room = 4000,
               .history = rewind_begin(budget) };

    assert_non_null(s.world);
    assert_non_null(s.history);
    s.bytes = s.world->layout.bytes;
    s.was = calloc(s.room, sizeof *s.was);
    return s;
}

static void show_end(past_show *s)
{
    for (uint32_t i = 0; i < s->room; i++)
        free(s->was[i]);
    free(s->was);
    free(s->world);
    rewind_end(s->history);
}

/* Makes the ticks of a frame, as the preview and a replay do. */
static void make_picture(tp_world *world, const tp_scene *scene, const tp_input *input)
{
    const tp_input *in = input;

    for (uint32_t ticks = tp_world_advance_clock(world); ticks > 0; ticks--) {
        tp_world_step(&tp_program_all, world, scene, in);
        in = NULL;
    }
}

static void remember(past_show *s)
{
    char **was = &s->was[s->picture];

    assert_true(s->picture < s->room);
    free(*was);
    *was = malloc(sizeof s->scene + s->bytes);
    memcpy(*was, &s->scene, sizeof s->scene);
    memcpy(*was + sizeof s->scene, s->world, s->bytes);
}

static void next_picture(past_show *s, bool changed)
{
    tp_input in = input_any(&chance);

    in.turn = chance_int(&chance, -9999999, 9999999);
    remember(s);
    rewind_add(s->history, s->picture++, s->world, s->bytes, &s->scene, &in, changed);
    make_picture(s->world, &s->scene, &in);
}

static void run_on(past_show *s, uint32_t pictures)
{
    while (pictures-- > 0)
        next_picture(s, false);
}

/* Restores the state before a frame.  Returns the number of replayed frames, UINT32_MAX:
 * not kept. */
static uint32_t go_back(past_show *s, uint32_t picture)
{
    uint32_t at, from;

    if (!rewind_take(s->history, picture, s->world, s->bytes, &s->scene, &at))
        return UINT32_MAX;
    for (from = at; at < picture; at++) {
        const tp_input *in = rewind_input(s->history, at);
        assert_non_null(in);
        make_picture(s->world, &s->scene, in);
    }
    s->picture = picture;
    return picture - from;
}

static void assert_as_it_was(const past_show *s)
{
    const char *was = s->was[s->picture];

    assert_memory_equal(was, &s->scene, sizeof s->scene);
    assert_memory_equal(was + sizeof s->scene, s->world, s->bytes);
}

/* one_of: bytes of a snapshot. snapshots_of: number of snapshots held beside the inputs. */
static size_t one_of(const past_show *s)
{
    return (sizeof s->scene + 7) / 8 * 8 + s->bytes;
}

static size_t snapshots_of(const past_show *s)
{
    const size_t inputs = (s->picture - rewind_oldest(s->history)) * sizeof(tp_input);
    const size_t rest = rewind_bytes(s->history) - inputs;

    assert_int_equal(rest % one_of(s), 0);
    return rest / one_of(s);
}

/* All frames from `first` on are restored, earlier ones are not.  Returns the longest
 * replay. */
static uint32_t try_all(past_show *s, uint32_t first)
{
    const uint32_t end = s->picture;
    uint32_t most = 0;

    assert_int_equal(rewind_oldest(s->history), first);
    for (uint32_t n = 0; n < end; n++) {
        const uint32_t way = go_back(s, n);
        assert_int_equal(way == UINT32_MAX, n < first);
        if (n < first)
            continue;
        assert_as_it_was(s);
        most = way > most ? way : most;
    }
    s->picture = end;
    return most;
}

static tp_scene scene_some(void)
{
    tp_scene s = scene_with(&chance, 4 + 16);

    s.pool.cols = s.pool.rows = 16;
    s.drops.count = 6;
    s.drops.rings = 12;
    s.foam.cells = 16;
    return s;
}

/* -- tests -------------------------------------------------------------------------- */

static void every_picture_comes_back(void **state)
{
    (void)state;
    for (uint32_t parts = 0; parts < 32; parts += 5) {
        const tp_scene scene = scene_with(&chance, parts);
        past_show s = show_of(&scene, 64 * MB);
        run_on(&s, 150);
        assert_true(try_all(&s, 0) < 16);
        show_end(&s);
    }
}

static void what_follows_a_way_back_is_another_past(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    past_show s = show_of(&scene, 64 * MB);

    run_on(&s, 120);
    for (uint32_t n = 110; n > 0; n -= 11) {
        assert_true(go_back(&s, n) < 16);
        run_on(&s, 20);
        assert_null(rewind_input(s.history, s.picture));
        assert_int_equal(snapshots_of(&s), (s.picture + 15) / 16);
        try_all(&s, 0);
        assert_true(go_back(&s, n + 20) <= 16);       /* as far as it was */
    }
    go_back(&s, 0);
    run_on(&s, 40);
    try_all(&s, 0);
    show_end(&s);
}

/* Some frames change the scene once, some in a row as a slider does. */
static void changes_of_the_scene_come_back_with_it(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    past_show s = show_of(&scene, 64 * MB);

    for (uint32_t n = 0; n < 200; n++) {
        const bool changed = n % 50 == 3 || (n > 100 && n < 130);
        if (changed) {
            s.scene.wave[0].amplitude = chance_fx(&chance, 0.1, 1);
            assert_true(tp_world_apply(&tp_program_all, s.world, &s.scene, NULL));
        }
        next_picture(&s, changed);
    }
    try_all(&s, 0);
    show_end(&s);
}

/* A camera moved while the water stands still. */
static void a_look_while_it_stands_comes_back(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    past_show s = show_of(&scene, 64 * MB);

    run_on(&s, 20);
    tp_world_move_camera(s.world, &(tp_input){ .turn = 777777, .forward = TP_FX_ONE });
    next_picture(&s, true);
    run_on(&s, 20);
    try_all(&s, 0);
    show_end(&s);
}

static void worlds_of_another_size_are_kept_apart(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    past_show s = show_of(&scene, 64 * MB);

    run_on(&s, 40);
    const size_t small = s.bytes;
    tp_world *const old = s.world;
    s.scene.pool.cols = 40;
    s.world = scene_world(&s.scene, NULL);
    s.bytes = s.world->layout.bytes;
    assert_true(s.bytes != small);
    run_on(&s, 40);
    assert_int_equal(rewind_world_bytes(s.history, 39), small);
    assert_int_equal(rewind_world_bytes(s.history, 40), s.bytes);
    assert_int_equal(go_back(&s, 39), UINT32_MAX);
    for (uint32_t n = 40; n < 80; n++) {
        assert_true(go_back(&s, n) < 16);
        assert_as_it_was(&s);
    }
    free(s.world);
    s.world = old;
    s.bytes = small;
    assert_int_equal(go_back(&s, 40), UINT32_MAX);
    assert_int_equal(go_back(&s, 39), 39 % 16);
    assert_as_it_was(&s);
    show_end(&s);
}

/* Makes frames with a budget of `worlds` snapshots and `inputs` inputs for each. */
static past_show long_show(const tp_scene *scene, uint32_t pictures, size_t worlds,
                           size_t inputs)
{
    past_show s = show_of(scene, 0);
    const size_t budget = worlds * (one_of(&s) + inputs * sizeof(tp_input));

    rewind_end(s.history);
    s.history = rewind_begin(budget);
    for (uint32_t n = 0; n < pictures; n++) {
        const bool looked = n % 500 == 50;
        if (looked)
            tp_world_move_camera(s.world,
                                 &(tp_input){ .turn = 777777, .forward = TP_FX_ONE });
        next_picture(&s, looked);
        assert_true(rewind_bytes(s.history) <= budget);
    }
    assert_true(snapshots_of(&s) > 0);
    return s;
}

/* Returns the longest replay of the last `pictures` frames. */
static uint32_t longest_way(past_show *s, uint32_t pictures)
{
    const uint32_t end = s->picture;
    uint32_t most = 0;

    for (uint32_t n = end - pictures; n < end; n += n < end - 300 ? 7 : 1) {
        const uint32_t way = go_back(s, n);
        assert_as_it_was(s);
        most = way > most ? way : most;
    }
    s->picture = end;
    return most;
}

static void older_snapshots_are_thinned_first(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    static const uint32_t want[][4] = {
        { 150, 0, 15, 63 },     /* worlds, oldest frame, longest replay: of the last 700,
                                 * of all */
        { 60, 0, 63, 127 },
        { 40, 1500, 63, 127 },
    };

    for (size_t i = 0; i < sizeof want / sizeof want[0]; i++) {
        past_show s = long_show(&scene, 3000, want[i][0], 3000 / want[i][0]);
        const uint32_t first = rewind_oldest(s.history);
        const uint32_t lately = longest_way(&s, 700), all = longest_way(&s, 3000 - first);
        printf("    %3u worlds: pictures %u to 2999, ways of %u, lately %u\n",
               (unsigned)want[i][0], (unsigned)first, (unsigned)all, (unsigned)lately);
        assert_true(first <= want[i][1]);
        assert_true(lately <= want[i][2]);
        assert_true(all <= want[i][3]);
        assert_int_equal(longest_way(&s, 200), 15);
        show_end(&s);
    }
}

/* If the budget cannot hold the whole history, the oldest frames are dropped. */
static void the_oldest_are_forgotten_at_last(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();

    for (size_t worlds = 2; worlds < 40; worlds *= 3) {
        past_show s = long_show(&scene, 2500, worlds, 20);
        const uint32_t first = rewind_oldest(s.history);
        assert_in_range(first, 1, 2500 - 16);
        try_all(&s, first);
        show_end(&s);
    }
}

static void a_budget_for_one_world_keeps_the_last_and_less_none(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    past_show s = show_of(&scene, 0);
    const size_t one = s.bytes + sizeof scene + 20 * sizeof(tp_input);

    run_on(&s, 100);
    assert_int_equal(rewind_oldest(s.history), UINT32_MAX);
    assert_int_equal(rewind_bytes(s.history), 0);
    assert_null(rewind_input(s.history, 99));
    assert_int_equal(go_back(&s, 50), UINT32_MAX);
    rewind_end(s.history);
    s.history = rewind_begin(one);
    run_on(&s, 60);                     /* 100, 116, 132, 148 */
    assert_true(rewind_bytes(s.history) <= one);
    try_all(&s, 148);
    show_end(&s);
}

static void what_is_forgotten_is_gone(void **state)
{
    (void)state;
    const tp_scene scene = scene_some();
    past_show s = show_of(&scene, MB);

    run_on(&s, 30);
    rewind_forget(s.history);
    assert_int_equal(rewind_bytes(s.history), 0);
    assert_int_equal(rewind_oldest(s.history), UINT32_MAX);
    assert_int_equal(rewind_world_bytes(s.history, 10), 0);
    s.picture = 500;
    run_on(&s, 30);
    s.picture = 900;                    /* leaves a gap */
    run_on(&s, 30);
    try_all(&s, 900);
    show_end(&s);
    rewind_end(NULL);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_picture_comes_back),
        cmocka_unit_test(what_follows_a_way_back_is_another_past),
        cmocka_unit_test(changes_of_the_scene_come_back_with_it),
        cmocka_unit_test(a_look_while_it_stands_comes_back),
        cmocka_unit_test(worlds_of_another_size_are_kept_apart),
        cmocka_unit_test(older_snapshots_are_thinned_first),
        cmocka_unit_test(the_oldest_are_forgotten_at_last),
        cmocka_unit_test(a_budget_for_one_world_keeps_the_last_and_less_none),
        cmocka_unit_test(what_is_forgotten_is_gone),
    };
    return cmocka_run_group_tests_name("past", tests, NULL, NULL);
}
