/* SPDX-License-Identifier: MIT */
/* quality.spray=fast: the same bits in every tiling, close to the exact rung, no streak
 * where the exact rung has none, bounded memory, and the same world. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/spray/spray.h"
#include "tests/lib/measure.h"
#include "tests/lib/tilings.h"

enum { WIDTH = 160, HEIGHT = 112, PIXELS = WIDTH * HEIGHT };

static uint64_t chance;
static const tp_assets none;
static const tp_config config = {
    .width = WIDTH, .height = HEIGHT, .tile_height = HEIGHT, .format = TP_FORMAT_XRGB8888
};

/* Still water below an eye at 10 m that looks to -z, in haze. */
static tp_scene scene_of(int32_t count, int32_t rung)
{
    tp_scene s = marks_still(10);

    s.spray.count = count;
    s.spray.size = TP_FX(0.1);
    s.sky.haze = 60 * TP_FX_ONE;
    s.quality.spray = rung;
    return s;
}

/* Throws `count` specks into the view, up to 60 m far. */
static void throw_specks(tp_world *world, int32_t count)
{
    tp_spray *spray = (tp_spray *)(uintptr_t)tp_world_spray(world);
    tp_speck *list = (tp_speck *)(uintptr_t)tp_spray_list(spray);

    for (int32_t i = 0; i < count; i++) {
        const double far = chance_double(&chance, 1, 60);
        const tp_vec3 at = { TP_FX(far * chance_double(&chance, -1, 1)),
                             TP_FX(10 + far * chance_double(&chance, -0.3, 0.6)),
                             TP_FX(-far) };
        const tp_vec3 last = { at.x - chance_fx(&chance, -0.2, 0.2),
                               at.y - chance_fx(&chance, -0.2, 0.2), at.z };
        list[spray->count++] = (tp_speck){ .place = at, .last = last, .kind = i % 8 == 7,
                                           .chance = (uint8_t)random_below(&chance, 256) };
    }
}

static void draw(const tp_scene *s, const tp_world *world, uint32_t *pixel)
{
    test_frame f = frame_of(s, &none, &config);

    frame_draw_picture(&f, world, pixel);
    frame_free(&f);
}

static void every_tiling_has_the_same_bits(void **state)
{
    uint32_t spray = 0;

    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = scene_of(200, TP_RUNG_FAST);
        s.water.clarity = n % 2 * TP_FX_ONE;
        s.camera.pitch = chance_fx(&chance, -30, 10);
        tp_world *world = scene_world(&s, &none);
        test_twice t = { 0 };
        throw_specks(world, 200);
        twice_begin(&t, &s, &none, &chance);
        twice_draw(&t, world);
        spray += t.reached.spray;
        twice_end(&t);
        free(world);
    }
    assert_int_equal(spray, 40);
}

/* Differences of channels in pixels that any rung gives spray, and the light that spray adds
 * to a channel in the mean. */
typedef struct {
    double squares, exact, fast;
    uint32_t channels;
    int largest;
} comparison;

static void compare(const uint32_t *bare, const uint32_t *exact, const uint32_t *fast,
                    comparison *c)
{
    for (int i = 0; i < PIXELS; i++)
        for (int k = 0; k < 24 && (exact[i] != bare[i] || fast[i] != bare[i]); k += 8) {
            const int e = (int)(exact[i] >> k & 255), off = (int)(fast[i] >> k & 255) - e;
            c->squares += off * off;
            c->exact += e - (int)(bare[i] >> k & 255);
            c->fast += e + off - (int)(bare[i] >> k & 255);
            c->largest = abs(off) > c->largest ? abs(off) : c->largest;
            c->channels++;
        }
}

/* Of 40 pictures of 150 specks: 5 levels rms where there is spray, 3 to 6 % less light. */
static void streaks_are_close_to_exact_ones(void **state)
{
    static uint32_t bare[PIXELS], exact[PIXELS], fast[PIXELS];
    comparison c = { 0 };

    (void)state;
    for (int n = 0; n < 40; n++) {
        tp_scene s = scene_of(150, TP_RUNG_EXACT);
        s.light.heading = chance_fx(&chance, 0, 360);
        tp_world *world = scene_world(&s, &none);
        draw(&s, world, bare);
        throw_specks(world, 150);
        draw(&s, world, exact);
        s.quality.spray = TP_RUNG_FAST;
        draw(&s, world, fast);
        compare(bare, exact, fast, &c);
        free(world);
    }
    const double rms = sqrt(c.squares / c.channels), light = c.fast / c.exact;
    printf("    %u channels with spray: %.2f levels rms, largest %d, light %.3f\n",
           (unsigned)c.channels, rms, c.largest, light);
    assert_true(c.channels > 20000);
    assert_true(rms < 6 && light > 0.9 && light < 1.1);
}

/* Specks behind the eye, under opaque water and beside the picture change nothing; above
 * the water the second is seen. */
static void hidden_specks_change_nothing(void **state)
{
    static uint32_t bare[PIXELS], fast[PIXELS];
    static const tp_vec3 at[] = { { 0, 10 * TP_FX_ONE, 5 * TP_FX_ONE },
                                  { 0, -TP_FX_ONE, -40 * TP_FX_ONE },
                                  { 90 * TP_FX_ONE, 10 * TP_FX_ONE, -9 * TP_FX_ONE } };
    tp_scene s = scene_of(3, TP_RUNG_FAST);
    s.spray.size = TP_FX_ONE;
    tp_world *world = scene_world(&s, &none);
    tp_spray *spray = (tp_spray *)(uintptr_t)tp_world_spray(world);
    tp_speck *list = (tp_speck *)(uintptr_t)tp_spray_list(spray);

    (void)state;
    draw(&s, world, bare);
    for (; spray->count < 3; spray->count++)
        list[spray->count] =
            (tp_speck){ .place = at[spray->count], .last = at[spray->count] };
    draw(&s, world, fast);
    assert_memory_equal(bare, fast, sizeof bare);
    list[1].place.y = list[1].last.y = TP_FX_ONE;
    draw(&s, world, fast);
    assert_memory_not_equal(bare, fast, sizeof bare);
    free(world);
}

/* Specks of seven rows each need more dashes than there is room for: the first ones are
 * drawn. */
static void a_full_list_drops_dashes(void **state)
{
    static uint32_t pixel[PIXELS];
    tp_scene s = scene_of(8, TP_RUNG_FAST);
    tp_world *world = scene_world(&s, &none);
    tp_spray *spray = (tp_spray *)(uintptr_t)tp_world_spray(world);
    test_frame f = frame_of(&s, &none, &config);

    (void)state;
    for (; spray->count < 8; spray->count++) {
        const tp_vec3 at = { ((int32_t)spray->count - 4) * TP_FX_ONE / 4, 10 * TP_FX_ONE,
                             -3 * TP_FX_ONE };
        ((tp_speck *)(uintptr_t)tp_spray_list(spray))[spray->count] =
            (tp_speck){ .place = at, .last = at, .chance = 255 };
    }
    frame_draw_picture(&f, world, pixel);
    const tp_streaks *d = tp_frame_module_memory(f.frame, TP_SPRAY_ID);
    assert_int_equal(d->count, 8);
    assert_int_equal(d->dashes->count, d->dashes->room);
    frame_free(&f);
    free(world);
}

/* Fast spray takes about the memory of exact spray, auto takes that of exact. */
static void memory_is_that_of_one_rung(void **state)
{
    size_t bytes[TP_RUNG_FAST + 1];

    (void)state;
    for (int32_t rung = TP_RUNG_AUTO; rung <= TP_RUNG_FAST; rung++) {
        const tp_scene s = scene_of(500, rung);
        tp_config c = config;
        c.assets = &none;
        c.program = &tp_program_all;
        bytes[rung] = tp_frame_bytes(&c, &s);
    }
    assert_int_equal(bytes[TP_RUNG_AUTO], bytes[TP_RUNG_EXACT]);
    assert_in_range(bytes[TP_RUNG_FAST], bytes[TP_RUNG_EXACT], bytes[TP_RUNG_EXACT] + 1024);
}

/* The world of spray off crests is the same with either rung drawn. */
static void worlds_do_not_differ(void **state)
{
    static uint32_t pixel[PIXELS];
    tp_world *world[2];
    tp_scene s = scene_plain();

    (void)state;
    s.boat.mesh[0] = '\0';
    s.wave[0].steepness = s.wave[1].steepness = s.wave[2].steepness = TP_FX(0.32);
    s.spray.count = 100;
    for (int k = 0; k < 2; k++) {
        s.quality.spray = k ? TP_RUNG_FAST : TP_RUNG_EXACT;
        world[k] = scene_world(&s, &none);
        for (int i = 0; i < 100; i++)
            tp_world_step(&tp_program_all, world[k], &s, NULL);
        draw(&s, world[k], pixel);
        tp_world_step(&tp_program_all, world[k], &s, NULL);
    }
    assert_true(tp_world_spray(world[0])->count > 0);
    assert_memory_equal(world[0], world[1], tp_world_bytes(&tp_program_all, &s, &none));
    free(world[0]);
    free(world[1]);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_tiling_has_the_same_bits),
        cmocka_unit_test(streaks_are_close_to_exact_ones),
        cmocka_unit_test(hidden_specks_change_nothing),
        cmocka_unit_test(a_full_list_drops_dashes),
        cmocka_unit_test(memory_is_that_of_one_rung),
        cmocka_unit_test(worlds_do_not_differ),
    };
    return cmocka_run_group_tests_name("features/spray fast", tests, NULL, NULL);
}
