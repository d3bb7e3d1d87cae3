/* SPDX-License-Identifier: MIT */
/* Coastal water under changed parameters: the parts computed again; and the block then
 * equals a block from tp_coastal_init, byte for byte. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "tests/lib/coastal_water.h"
#include "waves/coastal_tables.h"

static uint64_t chance;
static uint16_t sample[24 * 18];
static const tp_grey map = { 24, 18, sample };

/* Three swells over a map, a straight slope, or no floor; the last wave has no
 * amplitude. */
static coastal_water any_coastal(int kind)
{
    coastal_water o = { .count = 4, .config = coastal_usual() };

    for (uint32_t i = 0; i < o.count; i++)
        o.wave[i] =
            coastal_wave(chance_double(&chance, 0.1, 1), chance_double(&chance, 8, 60),
                         chance_double(&chance, 0, 0.4), chance_double(&chance, 0, 360));
    o.wave[3].amplitude = 0;
    o.config.wind = chance_fx(&chance, 0, 0.1);
    o.config.wind_heading = chance_fx(&chance, 0, 360);
    for (size_t i = 0; i < sizeof sample / sizeof sample[0]; i++)
        sample[i] = (uint16_t)random_next(&chance);
    if (kind == 0)
        o.config.floor = (tp_floor){ .map = &map, .map_size = TP_FX(150),
                                     .map_low = TP_FX(-20), .map_high = TP_FX(2) };
    else if (kind == 1)
        o.config.floor = shore(12, 0.03, chance_double(&chance, 0, 360));
    return o;
}

static tp_status refresh(coastal_water *o)
{
    tp_deep_water_init(&o->deep, o->wave, o->count, TP_FX(9.81));
    return tp_coastal_refresh(o->coastal, &o->config, &o->deep, o->wave, o->count, NULL);
}

/* The memory is all 0 before, so that gaps between parts compare equal. */
static void build(coastal_water *o)
{
    tp_deep_water_init(&o->deep, o->wave, o->count, TP_FX(9.81));
    o->coastal = calloc(1, tp_coastal_bytes(&o->config, &o->deep));
    assert_non_null(o->coastal);
    assert_int_equal(
        tp_coastal_init(o->coastal, &o->config, &o->deep, o->wave, o->count, NULL),
        TP_OK);
}

static void assert_as_built(const coastal_water *o, const char *change)
{
    coastal_water want = *o;
    const size_t bytes = tp_coastal_bytes(&o->config, &o->deep);

    build(&want);
    if (memcmp(want.coastal, o->coastal, bytes) != 0)
        print_error("a change of %s changes coastal water\n", change);
    assert_memory_equal(want.coastal, o->coastal, bytes);
    coastal_end(&want);
}

/* -- every parameter ----------------------------------------------------------------- */

#define CONFIG(member)                                                                   \
    {                                                                                    \
#member, offsetof(coastal_water, config.member)                                  \
    }
#define WAVE(member)                                                                     \
    {                                                                                    \
        "wave1 " #member, offsetof(coastal_water, wave[1].member)                        \
    }
static const struct { const char *name; size_t at; } numbers[] = {
    CONFIG(floor.depth), CONFIG(floor.slope), CONFIG(floor.heading), CONFIG(floor.map_x),
    CONFIG(floor.map_z), CONFIG(floor.map_size), CONFIG(floor.map_low),
    CONFIG(floor.map_high), CONFIG(wind), CONFIG(wind_heading), CONFIG(k0), CONFIG(kx),
    CONFIG(ky), CONFIG(stretch), CONFIG(irregular), WAVE(amplitude), WAVE(length),
    WAVE(steepness), WAVE(heading), WAVE(phase), WAVE(speed),
};
enum { NUMBERS = sizeof numbers / sizeof numbers[0] };

static void a_refresh_makes_what_init_makes(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        coastal_water o = any_coastal(kind);
        build(&o);
        for (size_t i = 0; i < 2 * NUMBERS; i++) {
            tp_fx *number = (tp_fx *)(void *)((char *)&o + numbers[i % NUMBERS].at);
            *number += 1 + *number / 16;
            assert_int_equal(refresh(&o), TP_OK);
            assert_as_built(&o, numbers[i % NUMBERS].name);
        }
        coastal_end(&o);
    }
}

/* One wave appears while another disappears: the same number of swells at other indices. */
static void waves_may_change_places(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        coastal_water o = any_coastal(kind);
        build(&o);
        o.wave[3].amplitude = o.wave[0].amplitude;
        o.wave[0].amplitude = 0;
        assert_int_equal(refresh(&o), TP_OK);
        assert_as_built(&o, "which waves move");
        coastal_end(&o);
    }
}

/* -- parts kept unchanged ------------------------------------------------------------ */

enum { BEDS = 1, RAYS0 = 2, RAYS1 = 4, RAYS2 = 8, TABLES = 16, ALL = 31 };

/* Flips a bit in each part; counts the parts that are right after the refresh, hence
 * computed again. */
static int made_again(coastal_water *o)
{
    tp_coastal_floor_node *node = tp_coastal_floor_nodes(o->coastal);
    tp_coastal_wave_node *ray[3];
    int32_t *mark[5] = { &node[40].depth };
    int32_t before[5];
    int made = 0;

    for (int i = 0; i < 3; i++) {
        ray[i] = tp_coastal_wave_nodes(o->coastal, &o->coastal->wave[i]);
        mark[1 + i] = &ray[i][40].turns;
    }
    mark[4] = &tp_coastal_tables(o->coastal)[1].depth[20].up;
    for (int i = 0; i < 5; i++) {
        before[i] = *mark[i];
        *mark[i] ^= 1 << 20;
    }
    assert_int_equal(refresh(o), TP_OK);
    for (int i = 0; i < 5; i++) {
        made |= *mark[i] != (before[i] ^ 1 << 20) ? 1 << i : 0;
        *mark[i] = made >> i & 1 ? *mark[i] : before[i];
    }
    return made;
}

static void what_depends_on_no_changed_number_is_left_as_it_is(void **state)
{
    (void)state;
    coastal_water o = any_coastal(0);
    build(&o);
    assert_int_equal(made_again(&o), 0);
    o.wave[1].speed++;
    o.wave[1].phase++;
    o.wave[3].length++;                 /* no amplitude */
    o.config.floor.slope += 99;         /* the map replaces the slope */
    assert_int_equal(made_again(&o), 0);
    o.wave[1].amplitude += 99;
    assert_int_equal(made_again(&o), TABLES);
    o.config.wind += 99;
    assert_int_equal(made_again(&o), TABLES);
    o.config.stretch -= 99;
    assert_int_equal(made_again(&o), TABLES);
    o.wave[2].heading += TP_FX(20);
    assert_int_equal(made_again(&o), RAYS2 | TABLES);
    o.wave[0].length += TP_FX(9);
    assert_int_equal(made_again(&o), RAYS0 | TABLES);
    o.config.floor.map_low -= TP_FX(5);
    assert_int_equal(made_again(&o), ALL);
    assert_as_built(&o, "all that is above");
    coastal_end(&o);
}

/* -- refused changes ----------------------------------------------------------------- */

static void coastal_water_of_another_size_is_refused_unchanged(void **state)
{
    (void)state;
    static const tp_grey wider = { 200, 18, sample }, none = { 0, 18, sample };
    coastal_water o = any_coastal(0);
    build(&o);
    const coastal_water was = o;
    o.wave[3].amplitude = 1;                            /* one more swell */
    assert_int_equal(refresh(&o), TP_E_ARG);
    o = was;
    o.config.floor.map = &wider;
    assert_int_equal(refresh(&o), TP_E_ARG);
    o.config.floor.map = &none;
    assert_int_equal(refresh(&o), TP_E_ARG);
    o.config.floor.map = NULL;
    assert_int_equal(refresh(&o), TP_E_ARG);
    o = was;
    o.config.floor.map_size = TP_FX_ONE - 1;
    assert_int_equal(refresh(&o), TP_E_ARG);
    o = was;
    assert_as_built(&o, "nothing");
    coastal_end(&o);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_refresh_makes_what_init_makes),
        cmocka_unit_test(waves_may_change_places),
        cmocka_unit_test(what_depends_on_no_changed_number_is_left_as_it_is),
        cmocka_unit_test(coastal_water_of_another_size_is_refused_unchanged),
    };
    return cmocka_run_group_tests_name("waves/coastal_refresh", tests, NULL, NULL);
}
