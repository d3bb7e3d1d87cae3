/* SPDX-License-Identifier: MIT */
/* A thousand drops for a minute, over water with swell, and a clock whose target jumps from
 * end to end with every picture.  The test prints the maxima. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/drops/drops.h"
#include "world/world.h"
#include "tests/lib/random.h"

#define MINUTE 3600             /* ticks */
#define GRAVITY TP_FX(9.81)

static uint64_t chance;

typedef struct {
    uint32_t drops, rings;      /* largest numbers at once */
    tp_fx    highest, fastest;  /* m, m/s */
    tp_fx    surface;           /* highest sum of the rings, m */
} figures;

/* A swell of 0.5 m height and 25 m length along x. */
static tp_fx level_at(tp_fx x, uint64_t tick)
{
    const tp_turn turns = (tp_turn)((int64_t)x * 2621) - (tp_turn)tick * 17895697u;
    return tp_fx_sin(turns) / 2;
}

static void look(const tp_drops *drops, uint64_t tick, figures *f)
{
    const tp_drop *const list = tp_drops_list(drops);

    assert_true(drops->count <= drops->capacity && drops->rings <= drops->ring_capacity);
    assert_true(drops->impacts <= 7 * drops->released);
    f->drops = drops->count > f->drops ? drops->count : f->drops;
    f->rings = drops->rings > f->rings ? drops->rings : f->rings;
    for (uint32_t i = 0; i < drops->count; i++) {
        const tp_fx speed = tp_abs(list[i].fall_q24) / 256;
        assert_true(list[i].radius > 0);
        assert_true(list[i].place.y >= level_at(list[i].place.x, tick));
        f->highest = list[i].place.y > f->highest ? list[i].place.y : f->highest;
        f->fastest = speed > f->fastest ? speed : f->fastest;
    }
}

static void ripple(const tp_drops *drops, int64_t now, tp_ring_now *rings, figures *f)
{
    uint32_t count = 0;

    for (uint32_t i = 0; i < drops->rings; i++)
        count += tp_ring_evaluate(&tp_drops_rings(drops)[i], now, &rings[count]);
    for (int k = 0; k < 16; k++) {
        const tp_height_slope at = tp_ring_height_slope(
            rings, count, chance_fx(&chance, -25, 25), chance_fx(&chance, -25, 25));
        f->surface = at.height > f->surface ? at.height : f->surface;
    }
}

static void print(const tp_drops *drops, const figures *f)
{
    printf("# drops: %u released, %u impacts, at most %u in the air and %u rings, %u and "
           "%u found no place\n", (unsigned)drops->released, (unsigned)drops->impacts,
           (unsigned)f->drops, (unsigned)f->rings, (unsigned)drops->dropped,
           (unsigned)drops->rings_dropped);
    printf("# drops: none higher than %.3f m or faster than %.3f m/s; rings sum up to "
           "%.4f m\n", f->highest / 65536.0, f->fastest / 65536.0, f->surface / 65536.0);
}

static void a_thousand_drops_fall_for_a_minute(void **state)
{
    (void)state;
    const tp_scene_drops c = {
        .count = 1000, .rings = 1000, .y = TP_FX(10), .radius = TP_FX(0.05),
        .density = TP_FX(1000), .drag = TP_FX(0.47), .bounce = TP_FX(0.7), .impacts = 7,
        .interval = TP_FX(0.004), .scatter_radius = TP_FX(20), .efficiency = TP_FX(0.3),
        .ring_speed = TP_FX(1.2), .ring_decay = TP_FX(2),
        .ring_spread = TP_FX_ONE, .ring_rise_time = TP_FX(0.1),
    };
    tp_drops *const drops = malloc(tp_drops_bytes(&c));
    tp_ring_now *const rings = malloc(1000 * sizeof *rings);
    figures f = { 0 };

    assert_non_null(drops);
    assert_non_null(rings);
    tp_drops_init(drops, &c);
    for (uint64_t tick = 1; tick <= MINUTE; tick++) {
        tp_drops_move_releasing_sphere(drops, 0, 0);
        tp_drops_release(drops, &c, tick == 1 ? 1000 : 0);
        tp_drops_release_by_interval(drops, &c);
        for (uint32_t i = 0; i < drops->count; i++) {
            tp_impact impact;
            const tp_fx x = tp_drops_list(drops)[i].place.x;
            if (tp_drops_step_drop(drops, &c, i, GRAVITY, level_at(x, tick), tick, &impact))
                tp_drops_add_ring(drops, &c, &impact);
        }
        tp_drops_rings_remove_spent(drops, (int64_t)tick * 65536, TP_FX(100));
        look(drops, tick, &f);
        if (tick % 8 == 0)
            ripple(drops, (int64_t)tick * 65536, rings, &f);
    }
    print(drops, &f);
    assert_int_equal(f.drops, 1000);
    assert_true(f.highest <= TP_FX(10));
    assert_true(f.fastest <= TP_FX(14.36));     /* sqrt(2 g 10.5 m), to the trough */
    assert_true(drops->impacts > 10000);
    free(drops);
    free(rings);
}

/* Without further releases all drops and rings end. */
static void all_drops_and_rings_come_to_an_end(void **state)
{
    (void)state;
    const tp_scene_drops c = {
        .count = 1000, .rings = 1000, .y = TP_FX(10), .radius = TP_FX(0.05),
        .density = TP_FX(1000), .drag = TP_FX(0.47), .bounce = TP_FX(0.8), .impacts = 7,
        .scatter_radius = TP_FX(20), .efficiency = TP_FX(0.3), .ring_speed = TP_FX(1.2),
        .ring_decay = TP_FX(2),
        .ring_spread = TP_FX_ONE, .ring_rise_time = TP_FX(0.1),
    };
    tp_drops *const drops = malloc(tp_drops_bytes(&c));
    uint64_t tick = 0, dry = 0;

    assert_non_null(drops);
    tp_drops_init(drops, &c);
    tp_drops_release(drops, &c, 1000);
    while (drops->count > 0 || drops->rings > 0) {
        tick++;
        for (uint32_t i = 0; i < drops->count; i++) {
            tp_impact impact;
            if (tp_drops_step_drop(drops, &c, i, GRAVITY, 0, tick, &impact))
                tp_drops_add_ring(drops, &c, &impact);
        }
        tp_drops_rings_remove_spent(drops, (int64_t)tick * 65536, TP_FX(100));
        dry = drops->count > 0 ? tick : dry;
        assert_true(tick < 6000);
    }
    printf("# drops: a thousand are gone after %.2f s, their rings after %.2f s\n",
           (double)dry / 60, (double)tick / 60);
    assert_int_equal(drops->impacts, 7000);
    free(drops);
}

static void a_clock_flipped_every_picture_runs_evenly(void **state)
{
    (void)state;
    tp_clock clock;
    double least = 9, most = 0, last = 0;

    tp_clock_init(&clock, TP_FX_ONE);
    for (int n = 1; n <= 216000; n++) {
        tp_clock_set_target(&clock, n % 2 ? TP_CLOCK_FASTEST : TP_CLOCK_SLOWEST);
        tp_clock_advance(&clock);
        const double now = (double)tp_clock_ticks(&clock)
                         + (double)clock.fraction_q40 / 1099511627776.0;
        least = fmin(least, now - last);
        most = fmax(most, now - last);
        assert_true(now - last >= 0.125 && now - last <= 4);
        assert_in_range(tp_clock_fraction(&clock), 0, TP_FX_ONE - 1);
        last = now;
    }
    printf("# clock: flipped for an hour it moves %.4f to %.4f ticks a picture, %.0f in "
           "all\n", least, most, last);
}

/* With any targets, time never stands still and never jumps. */
static void any_targets_keep_time_within_its_ends(void **state)
{
    (void)state;
    tp_clock clock;
    uint64_t last = 0;

    tp_clock_init(&clock, TP_FX_ONE);
    for (int n = 0; n < 216000; n++) {
        if (random_below(&chance, 30) == 0)
            tp_clock_set_target(&clock, (tp_fx)(uint32_t)random_next(&chance));
        tp_clock_advance(&clock);
        const uint64_t now = (tp_clock_ticks(&clock) << 16)
                           + (uint32_t)tp_clock_fraction(&clock);
        assert_in_range(now - last, TP_CLOCK_SLOWEST - 1, TP_CLOCK_FASTEST + 1);
        last = now;
    }
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_thousand_drops_fall_for_a_minute),
        cmocka_unit_test(all_drops_and_rings_come_to_an_end),
        cmocka_unit_test(a_clock_flipped_every_picture_runs_evenly),
        cmocka_unit_test(any_targets_keep_time_within_its_ends),
    };
    return cmocka_run_group_tests_name("drops, a minute", tests, NULL, NULL);
}
