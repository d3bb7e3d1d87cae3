/* SPDX-License-Identifier: MIT */
/* Limits of sums of swells: crests with loops, ambiguous inversion, waves shorter than the
 * mesh, clocks after years. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/lib/random.h"
#include "waves/deep_water.h"

#define LSB (1 / 65536.0)
#define Q30 1073741824.0
#define TURN (2 * 3.14159265358979323846 / 4294967296.0)

static uint64_t chance;

/* -- crests with loops [A11] ----------------------------------------------------------- */

/* Deep water of `count` waves with steepnesses that sum up to `sum`, all crests through the
 * origin; half of the cases have a single direction, the worst case. */
static tp_deep_water steep_sea(int count, double sum, tp_turn phases[TP_WAVES])
{
    const bool one_way = random_below(&chance, 2);
    tp_wave wave[TP_WAVES];
    tp_deep_water  deep;

    for (int i = 0; i < count; i++) {
        wave[i] = chance_wave(&chance);
        wave[i].length = chance_scale(&chance, 1, 100);
        wave[i].amplitude = wave[i].length / 20;
        wave[i].steepness = (tp_fx)(sum / count / LSB);
        if (one_way)
            wave[i].heading = wave[0].heading;
    }
    tp_deep_water_init(&deep, wave, (uint32_t)count, TP_FX(9.81));
    for (int i = 0; i < TP_WAVES; i++)
        phases[i] = 0x40000000;             /* sin th = 1: where the Jacobian is smallest */
    return deep;
}

/* Smaller eigenvalue of J [A11] at a rest position. */
static double least_eigenvalue(const tp_deep_water *deep, const tp_turn phases[TP_WAVES],
                               double x, double z)
{
    double xx = 1, xz = 0, zz = 1;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        const double turns = (double)w->turns_x * x + (double)w->turns_z * z;
        const double s = sin((fmod(turns, 4294967296.0) + phases[i]) * TURN);
        xx -= w->bend_xx / Q30 * s;
        xz -= w->bend_xz / Q30 * s;
        zz -= w->bend_zz / Q30 * s;
    }
    return (xx + zz) / 2 - sqrt((xx - zz) * (xx - zz) / 4 + xz * xz);
}

static void no_crest_loops_whatever_the_steepness(void **state)
{
    (void)state;
    printf("# steepness sum   smallest eigenvalue of the Jacobian, after the clamp\n");
    for (double sum = 0.5; sum <= 3.001; sum += 0.25) {
        double least = 1;
        for (int k = 0; k < 200; k++) {
            tp_turn phases[TP_WAVES];
            const tp_deep_water deep = steep_sea(chance_int(&chance, 3, 16), sum, phases);
            assert_int_equal(deep.clamped, sum > 0.96);
            for (int n = 0; n < 20; n++) {
                const double far = n == 0 ? 0 : 300;
                least = fmin(least, least_eigenvalue(&deep, phases,
                                                     chance_double(&chance, -far, far),
                                                     chance_double(&chance, -far, far)));
            }
        }
        printf("# %13.2f   %.4f\n", sum, least);
        assert_true(least >= 0);
        assert_true(least <= fmax(1 - sum, 0.05) + 1e-3);   /* worst position sampled */
    }
}

/* -- inversion at its bound [E1] ------------------------------------------------------- */

/* Points found are on the surface and near the requested position. */
static double inversion_error(double sum)
{
    double worst = 0;

    for (int k = 0; k < 300; k++) {
        tp_turn phases[TP_WAVES];
        const tp_deep_water deep = steep_sea(chance_int(&chance, 1, 16), sum, phases);
        const tp_fx x = chance_fx(&chance, -500, 500), z = chance_fx(&chance, -500, 500);
        tp_fx rest[2] = { x, z };
        for (uint32_t i = 0; i < TP_WAVES; i++)
            phases[i] = (tp_turn)random_next(&chance);
        const tp_surface_point p = tp_deep_water_sample(&deep, phases, x, z, rest);
        const tp_surface_point q =
            tp_deep_water_displace_point(&deep, phases, rest[0], rest[1]);
        assert_memory_equal(&p, &q, sizeof p);
        assert_true(abs(p.position.y) <= deep.height);
        worst = fmax(worst, hypot(p.position.x - x, p.position.z - z) * LSB);
    }
    return worst;
}

static void the_height_query_holds_at_and_over_its_bound(void **state)
{
    (void)state;
    static const double sums[] = { 0.3, 0.7, 0.9, 0.95, 1, 2, 3 };
    printf("# steepness sum   place missed by, m, at the worst\n");
    for (size_t i = 0; i < sizeof sums / sizeof *sums; i++) {
        const double worst = inversion_error(sums[i]);
        printf("# %13.2f   %.6f\n", sums[i], worst);
        if (sums[i] <= 0.9)
            assert_true(worst <= 0.001);
        assert_true(worst < 10);            /* never far away */
    }
}

/* -- clocks ---------------------------------------------------------------------------- */

/* Bits 32 to 63 of a product, from parts of 16 bits. */
static tp_turn product(uint64_t a, uint64_t b)
{
    uint32_t word[4] = { 0 };           /* 16 bits each, and their carry */

    for (int i = 0; i < 4; i++) {
        uint32_t carry = 0;
        for (int k = 0; i + k < 4; k++) {
            const uint32_t part = (uint32_t)(a >> 16 * i & 0xffff)
                                * (uint32_t)(b >> 16 * k & 0xffff);
            const uint64_t sum = (uint64_t)part + word[i + k] + carry;
            word[i + k] = (uint32_t)(sum & 0xffff);
            carry = (uint32_t)(sum >> 16);
        }
    }
    return word[3] << 16 | word[2];
}

/* n x increment modulo a turn, by long multiplication, compared with the core after ten
 * years. */
static void phases_after_ten_years_are_exact(void **state)
{
    (void)state;
    const uint64_t years = 10ull * 36525 / 100 * 24 * 3600 * TP_TICKS_PER_SECOND;
    uint32_t worst = 0;

    for (int k = 0; k < 2000; k++) {
        tp_turn phases[TP_WAVES];
        const tp_wave wave = chance_wave(&chance);
        const uint64_t tick = years + random_below(&chance, 1000);
        tp_deep_water deep;
        tp_deep_water_init(&deep, &wave, 1, TP_FX(9.81));
        tp_deep_water_phases(&deep, tick, 0, phases);
        if (deep.count == 0)
            continue;
        const tp_turn exact = deep.swell[0].phase - product(tick, deep.swell[0].turns_tick);
        const uint32_t off = (uint32_t)abs((int32_t)(phases[0] - exact));
        worst = off > worst ? off : worst;
    }
    printf("# worst phase after ten years: %u of 2^-32 turn off\n", (unsigned)worst);
    assert_true(worst <= 1);
}

/* Between two ticks phases advance uniformly: half a tick back is half the phase step. */
static void phases_between_ticks_lie_between(void **state)
{
    (void)state;
    for (int k = 0; k < 500; k++) {
        tp_turn before[TP_WAVES], half[TP_WAVES], after[TP_WAVES];
        const tp_wave wave = chance_wave(&chance);
        const uint64_t tick = 1 + random_below(&chance, 1 << 30);
        tp_deep_water deep;
        tp_deep_water_init(&deep, &wave, 1, TP_FX(9.81));
        tp_deep_water_phases(&deep, tick - 1, 0, before);
        tp_deep_water_phases(&deep, tick, TP_FX_ONE / 2, half);
        tp_deep_water_phases(&deep, tick, 0, after);
        assert_true(abs((int32_t)(half[0] - before[0]) - (int32_t)(after[0] - half[0]))
                    <= 2);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_crest_loops_whatever_the_steepness),
        cmocka_unit_test(the_height_query_holds_at_and_over_its_bound),
        cmocka_unit_test(phases_after_ten_years_are_exact),
        cmocka_unit_test(phases_between_ticks_lie_between),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("stability of swells", tests, NULL, NULL);
}
