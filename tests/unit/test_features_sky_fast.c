/* SPDX-License-Identifier: MIT */
/* The fast rungs of the sky and of haze compared with the exact stages, for any cuts of
 * spans. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/sky/sky.h"
#include "tests/lib/shading.h"

static uint64_t chance;
static test_sky sky;

/* A random camera of `focal` px, with a dome or a cube. */
static tp_shade shade_of(tp_env_kind kind, int32_t focal)
{
    tp_shade s = shade_any(&chance);

    if (kind == TP_ENV_DOME)
        sky_dome(&sky, &s, &chance);
    else if (kind == TP_ENV_CUBE)
        s.env = (tp_env){ .kind = kind, .cube = &sky.cube, .recip = sky.recip };
    s.focal = focal * 16;
    s.per_focal = (uint32_t)(((uint64_t)1 << 32) / (uint32_t)s.focal);
    return s;
}

static void paint(uint32_t (*colour)(ref_dir d, void *with), void *with)
{
    tp_shade s = shade_any(&chance);
    sky_cube(&sky, &s, colour, with);
}

/* -- cuts of spans --------------------------------------------------------------------- */

static void assert_cut(stage *fast, const tp_shade *s, const test_run *r, int32_t cut)
{
    tp_run whole = r->run;
    tp_run left = run_part(&r->run, 0, cut), right = run_part(&r->run, cut, TP_RUN);

    fast(s, &whole);
    fast(s, &left);
    fast(s, &right);
    assert_memory_equal(whole.colour, left.colour, (size_t)cut * 4);
    assert_memory_equal(whole.colour + cut, right.colour, (size_t)(TP_RUN - cut) * 4);
}

static void where_a_run_of_sky_is_cut_does_not_show(void **state)
{
    (void)state;
    paint(sky_noise, &chance);
    for (int n = 0; n < 3000; n++) {
        const bool cube = n & 1;
        tp_shade s = shade_of(cube ? TP_ENV_CUBE : TP_ENV_DOME, chance_int(&chance, 60, 1000));
        test_run r;
        s.env.beyond = (uint32_t)chance_int(&chance, 0, 4096);
        sky.cube.lod = chance_int(&chance, -600, 200);
        run_any(&r, 0, &chance);
        assert_cut(cube ? tp_stage_sky_cube_fast : tp_stage_sky_dome_fast, &s, &r,
                   chance_int(&chance, 1, TP_RUN - 1));
    }
}

/* -- the dome -------------------------------------------------------------------------- */

static void compare_domes(const char *what, int32_t focal, double most)
{
    colour_error off = { .what = what };

    for (int n = 0; n < 3000; n++) {
        const tp_shade s = shade_of(TP_ENV_DOME, focal);
        test_run r;
        run_any(&r, 0, &chance);
        tp_run fast = r.run;
        tp_stage_sky_dome_hdr(&s, &r.run);
        tp_stage_sky_dome_fast(&s, &fast);
        for (int i = 0; i < TP_RUN; i++)
            if (r.run.vy[i] < -100)
                colour_error_add(&off, fast.colour[i], ref_colour_unpack(r.run.colour[i]));
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) < most);
}

static void domes_keep_their_colours(void **state)
{
    (void)state;
    compare_domes("640 columns", 554, 1);
    compare_domes("320 columns", 277, 1.2);
}

/* Looks at the sun: the disc and its glow have the colours and the size of the exact
 * sky. */
static void the_sun_keeps_its_shape(void **state)
{
    (void)state;
    colour_error off = { .what = "sun" };

    for (int n = 0; n < 600; n++) {
        tp_shade s = shade_of(TP_ENV_DOME, 277);
        const tp_dir3 back = s.world.back;
        s.world.lx = -(back.x >> 16);
        s.world.ly = -(back.y >> 16);
        s.world.lz = -(back.z >> 16);
        if (s.world.ly < 3000)
            continue;
        test_run r;
        run_any(&r, 0, &chance);
        r.run.x = 320 / TP_RUN * TP_RUN;
        r.run.y = 240 + chance_int(&chance, -30, 30);
        tp_run fast = r.run;
        tp_stage_sky_dome_hdr(&s, &r.run);
        tp_stage_sky_dome_fast(&s, &fast);
        for (int i = 0; i < TP_RUN; i++)
            colour_error_add(&off, fast.colour[i], ref_colour_unpack(r.run.colour[i]));
    }
    colour_error_print(&off);
    assert_true(off.count > 0 && colour_error_rms(&off) < 2.5);
}

/* -- stars ----------------------------------------------------------------------------- */

/* Black sky with stars of the size that begin_stars gives. */
static tp_shade starry_shade(int32_t focal)
{
    tp_shade s = shade_of(TP_ENV_DOME, focal);
    const uint32_t radius = 32768 * 85 / 100 / (uint32_t)focal;

    s.env.stars = 64;
    s.env.star = (1u << 24) / (radius * radius);
    return s;
}

/* Compares the lit samples alone, 10000 channels or more: few samples have a star. */
static void compare_stars(const char *what, int32_t focal, double most)
{
    colour_error off = { .what = what };

    for (int n = 0; n < 100000 && off.count < 10000; n++) {
        const tp_shade s = starry_shade(focal);
        test_run r;
        run_any(&r, 0, &chance);
        memset(r.run.colour, 0, sizeof r.run.colour);
        tp_run fast = r.run;
        tp_stage_view(&s, &r.run);
        tp_stage_stars(&s, &r.run);
        tp_stage_stars_fast(&s, &fast);
        for (int i = 0; i < TP_RUN; i++)
            if (r.run.colour[i] | fast.colour[i])
                colour_error_add(&off, fast.colour[i], ref_colour_unpack(r.run.colour[i]));
    }
    colour_error_print(&off);
    assert_true(off.count >= 10000 && colour_error_rms(&off) < most);
}

/* A star that moved by a pixel would be off by its brightness: 56 to 255 levels. */
static void stars_stay_in_place(void **state)
{
    (void)state;
    compare_stars("stars, 554", 554, 16);
    compare_stars("stars, 277", 277, 16);
    compare_stars("stars, 120", 120, 16);
}

static void where_a_run_of_stars_is_cut_does_not_show(void **state)
{
    (void)state;
    for (int n = 0; n < 2000; n++) {
        const tp_shade s = starry_shade(chance_int(&chance, 110, 800));
        test_run r;
        run_any(&r, 0, &chance);
        assert_cut(tp_stage_stars_fast, &s, &r, chance_int(&chance, 1, TP_RUN - 1));
    }
}

/* -- the cube -------------------------------------------------------------------------- */

static void compare_cubes(const char *what, int32_t focal, double most)
{
    colour_error off = { .what = what };

    for (int n = 0; n < 3000; n++) {
        const tp_shade s = shade_of(TP_ENV_CUBE, focal);
        test_run r;
        run_any(&r, 0, &chance);
        sky.cube.lod = 5 * 256 - tp_log2_q8((uint32_t)focal);
        tp_run fast = r.run;
        tp_stage_sky_cube(&s, &r.run);
        tp_stage_sky_cube_fast(&s, &fast);
        for (int i = 0; i < TP_RUN; i++)
            colour_error_add(&off, fast.colour[i], ref_colour_unpack(r.run.colour[i]));
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) < most);
}

/* Upright stripes of a twentieth of a radian, with sharp edges. */
static uint32_t stripe(ref_dir d, void *with)
{
    (void)with;
    return (int)floor(atan2(d.z, d.x) * 20) & 1 ? 0xc8d0e0 : 0x5080b0;
}

static void cubes_keep_their_colours(void **state)
{
    (void)state;
    paint(quick_smooth, NULL);
    compare_cubes("smooth cube, 277", 277, 1.2);
    compare_cubes("smooth cube, 110", 110, 1.2);
    paint(stripe, NULL);
    compare_cubes("striped cube, 277", 277, 4);
    compare_cubes("striped cube, 110", 110, 5);
}

/* Light above white is added as in the exact stage. */
static uint32_t bright(ref_dir d, void *with)
{
    return quick_smooth(d, with) | (uint32_t)(60 + 50 * d.y) << 24;
}

static void light_above_white_is_kept(void **state)
{
    (void)state;
    colour_error off = { .what = "bright cube" };

    paint(bright, NULL);
    for (int n = 0; n < 2000; n++) {
        tp_shade s = shade_of(TP_ENV_CUBE, 277);
        test_run r;
        s.env.beyond = (uint32_t)chance_int(&chance, 0, 1024);
        run_any(&r, 0, &chance);
        tp_run fast = r.run;
        tp_stage_sky_cube_hdr(&s, &r.run);
        tp_stage_sky_cube_fast(&s, &fast);
        for (int i = 0; i < TP_RUN; i++)
            colour_error_add(&off, fast.colour[i], ref_colour_unpack(r.run.colour[i]));
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) < 2);
}

/* -- haze ------------------------------------------------------------------------------ */

static tp_horizon horizon;

/* Returns a key at a depth in metres; the near plane is at 1/2 m. */
static uint32_t key_at(double depth)
{
    return (uint32_t)(0.5 / depth * 4294967295.0) | 1;
}

static void begin_haze(const tp_shade *s, double half_distance)
{
    horizon.haze = (tp_haze){ (uint32_t)(half_distance * 65536 * 64 / 32768), 1,
                              s->env.kind != TP_ENV_GRADIENT };
    if (horizon.haze.around)
        tp_horizon_make(horizon.colour, s);
}

static stage *exact_haze(const tp_shade *s)
{
    return s->env.kind == TP_ENV_DOME ? tp_stage_haze_dome
         : s->env.kind == TP_ENV_CUBE ? tp_stage_haze_cube : tp_stage_haze;
}

/* Sets the depths of water around `middle`; crests of up to `crests` nearer waves, 8 to 40
 * samples wide, hide parts of it. */
static void set_depths(test_run *r, double middle, int32_t crests)
{
    const double slope = chance_double(&chance, -0.002, 0.002);

    for (int i = 0; i < TP_RUN; i++)
        r->key[i] = key_at(middle / (1 + slope * i));
    for (int32_t n = chance_int(&chance, 0, crests); n > 0; n--) {
        const double nearer = chance_double(&chance, 1, 4);
        const int32_t from = chance_int(&chance, 0, TP_RUN - 1);
        const int32_t end = from + chance_int(&chance, 8, 40);
        for (int32_t i = from; i < end && i < TP_RUN; i++)
            r->key[i] = key_at(middle / nearer);
    }
}

static void compare_haze(tp_env_kind kind, int32_t crests, double most)
{
    static const char *const names[] = { "gradient haze", "dome haze", "cube haze" };
    colour_error off = { .what = names[kind] };

    for (int n = 0; n < 2000; n++) {
        tp_shade s = shade_of(kind, 277);
        test_run r;
        run_any(&r, 0, &chance);
        set_depths(&r, chance_double(&chance, 100, 6000), crests);
        begin_haze(&s, 1000);
        r.run.mine = &horizon;
        tp_run fast = r.run;
        exact_haze(&s)(&s, &r.run);
        tp_stage_haze_fast(&s, &fast);
        for (int i = 0; i < TP_RUN; i++)
            colour_error_add(&off, fast.colour[i], ref_colour_unpack(r.run.colour[i]));
    }
    colour_error_print(&off);
    assert_true(colour_error_rms(&off) < most);
}

static void haze_keeps_its_colours(void **state)
{
    (void)state;
    paint(quick_smooth, NULL);
    for (int kind = TP_ENV_GRADIENT; kind <= TP_ENV_CUBE; kind++) {
        compare_haze((tp_env_kind)kind, 0, 2);
        compare_haze((tp_env_kind)kind, 3, 2);
    }
}

/* Blocks are counted from the picture's left edge: tiles begin at their edges. */
static void where_a_tile_begins_does_not_show(void **state)
{
    (void)state;
    paint(quick_smooth, NULL);
    for (int n = 0; n < 2000; n++) {
        const tp_shade s = shade_of((tp_env_kind)(n % 3), 277);
        test_run r;
        run_any(&r, 0, &chance);
        set_depths(&r, chance_double(&chance, 100, 6000), n % 2 ? 0 : 3);
        begin_haze(&s, 1000);
        r.run.mine = &horizon;
        assert_cut(tp_stage_haze_fast, &s, &r, 16 * chance_int(&chance, 1, TP_RUN / 16 - 1));
    }
}

static void near_samples_keep_their_bits(void **state)
{
    (void)state;
    for (int n = 0; n < 500; n++) {
        const tp_shade s = shade_of(TP_ENV_DOME, 277);
        test_run r;
        run_any(&r, 0, &chance);
        set_depths(&r, chance_double(&chance, 1, 50), 0);
        begin_haze(&s, 1000);
        r.run.mine = &horizon;
        tp_run fast = r.run;
        tp_stage_haze_fast(&s, &fast);
        assert_memory_equal(fast.colour, r.run.colour, sizeof fast.colour);
        tp_stage_haze_dome(&s, &fast);
        assert_memory_equal(fast.colour, r.run.colour, sizeof fast.colour);
    }
}

/* White under a white horizon stays white for any shares: no sum overflows. */
static void white_in_white_haze_stays_white(void **state)
{
    (void)state;
    for (int n = 0; n < 3000; n++) {
        tp_shade s = shade_of(TP_ENV_GRADIENT, 277);
        test_run r;
        run_any(&r, 0, &chance);
        set_depths(&r, chance_double(&chance, 100, 6000), 0);
        s.env.kind = TP_ENV_GRADIENT;
        s.sky = &(const uint32_t){ 0xffffff };
        for (int i = 0; i < TP_RUN; i++)
            r.run.colour[i] = 0xffffff;
        begin_haze(&s, 1000);
        r.run.mine = &horizon;
        tp_stage_haze_fast(&s, &r.run);
        for (int i = 0; i < TP_RUN; i++)
            assert_true((r.run.colour[i] & 255) >= 253 && (r.run.colour[i] >> 8 & 255) >= 253
                        && r.run.colour[i] >> 16 >= 253 && r.run.colour[i] >> 24 == 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(where_a_run_of_sky_is_cut_does_not_show),
        cmocka_unit_test(domes_keep_their_colours),
        cmocka_unit_test(the_sun_keeps_its_shape),
        cmocka_unit_test(stars_stay_in_place),
        cmocka_unit_test(where_a_run_of_stars_is_cut_does_not_show),
        cmocka_unit_test(cubes_keep_their_colours),
        cmocka_unit_test(light_above_white_is_kept),
        cmocka_unit_test(haze_keeps_its_colours),
        cmocka_unit_test(where_a_tile_begins_does_not_show),
        cmocka_unit_test(near_samples_keep_their_bits),
        cmocka_unit_test(white_in_white_haze_stays_white),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("features/sky fast", tests, NULL, NULL);
}
