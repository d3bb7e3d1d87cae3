/* SPDX-License-Identifier: MIT */
/* Breaking crests compared with the models' vectors, and with the promises of
 * [B16]-[B19]. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "tools/reference/finite_depth.h"
#include "tools/reference/surf.h"
#include "tests/lib/random.h"
#include "waves/coastal_water.h"
#include "tests/lib/vectors.h"

#define K0 TP_FX(0.1)
#define KX TP_FX(0.11)
#define KY TP_FX(0.09)

static uint64_t chance;

/* r, h, gamma, k, St_max, Ks, Kd, Phi, Phi_min, p, Stretch, Displacement, Orientation,
 * gate, X, Y */
static tp_breaker row_breaker(const double *v)
{
    const tp_fx gate = tp_breaking_gate(row_fx(2 * v[0] / v[1]));
    return (tp_breaker){
        .orbit = tp_orbit_ellipse(row_fx(v[0]), row_fx(v[1]), row_turn(v[2]),
                                  ref_to_q32(v[3]), K0, KX, KY),
        .stretch = row_fx(v[4]),
        .lip = 2 * row_fx(v[0]),
        .kept_stretch = tp_fx_mul(gate, row_fx(exp(-v[5] * v[1]))),
        .kept_lip = tp_fx_mul(gate, row_fx(exp(-v[6] * v[1]))),
    };
}

/* True at the joints and on the crest: there the slopes of all three parts jump, and Phi as
 * turns may lie on the other side. */
static bool near_a_joint(double p)
{
    const double joint[] = { -PI, -PI / 3, 7 * PI / 8, PI };
    for (int i = 0; i < 4; i++) {
        if (fabs(p - joint[i]) < 1e-3)
            return true;
    }
    return false;
}

static void crests_follow_their_vectors_to_two_millimetres(void **state)
{
    (void)state;
    vector_table r = rows_of("breaking");
    measure stretch = { .what = "stretch", .unit = "mm" };
    measure displacement = { .what = "displacement", .unit = "mm" };
    measure angle = { .what = "orientation", .unit = "mrad" };
    measure lowest = { .what = "lowest", .unit = "mrad" };
    measure gate = { .what = "gate", .unit = "" };
    measure x = { .what = "X", .unit = "mm" }, y = { .what = "Y", .unit = "mm" };
    const double turn = 2 * PI / 4294967296.0;
    int left_out = 0;

    while (rows_next(&r)) {
        const double *v = r.at;
        const tp_breaker b = row_breaker(v);
        const tp_breaking at = tp_breaking_shape(&b, row_turn(v[7]));
        if (near_a_joint(v[9])) {
            left_out++;
            continue;
        }
        measure_add(&stretch, 1000 * row_error(at.stretch, v[10]), r.rows, 0, 0);
        measure_add(&displacement, 1000 * row_error(at.displacement, v[11]), r.rows, 0,
                    0);
        measure_add(&angle, 1000 * (at.orientation * turn - v[12]), r.rows, 0, 0);
        measure_add(&lowest,
                    1000 * ((int32_t)tp_orbit_lowest_phase(&b.orbit) * turn - v[8]),
                    r.rows, 0, 0);
        measure_add(&gate, tp_breaking_gate(row_fx(2 * v[0] / v[1])) / 65536.0 - v[13],
                    r.rows, 0, 0);
        measure_add(&x, 1000 * row_error(at.offset.along, v[14]), r.rows, 0, 0);
        measure_add(&y, 1000 * row_error(at.offset.up, v[15]), r.rows, 0, 0);
    }
    assert_int_equal(r.rows, 250);
    printf("    %d rows lie within 1e-3 rad of a joint\n", left_out);
    measure *const all[] = { &stretch, &displacement, &angle, &lowest, &gate, &x, &y };
    for (int i = 0; i < 7; i++) {
        measure_print(all[i]);
        assert_true(all[i]->worst < (i == 4 ? 0.001 : 2));
    }
}

static tp_breaker any_breaker(void)
{
    const double length = chance_scale(&chance, 2, 200) / 65536.0;
    const tp_fx r = chance_fx(&chance, 0.01, length / 14);
    const tp_fx h = (tp_fx)(r / 0.39);
    return (tp_breaker){
        .orbit = tp_orbit_ellipse(r, h, (tp_turn)chance_int(&chance, 0, 0x0fffffff),
                             ref_to_q32(2 * PI / length), K0, KX, KY),
        .stretch = (tp_fx)(r * chance_double(&chance, 0, 2)), .lip = 2 * r,
        .kept_stretch = TP_FX_ONE, .kept_lip = chance_fx(&chance, 0, 1),
    };
}

/* A step of 2^-16 turn moves a particle at most by the largest slopes: 2 pi r Sx of the
 * orbit, 4 St of the stretch, 16 lips and as many turns of their displacement. */
static void the_shape_has_no_gap_anywhere_round_the_turn(void **state)
{
    (void)state;
    for (int n = 0; n < 40; n++) {
        const tp_breaker b = any_breaker();
        const double most = (7.0 * b.orbit.along + 4.0 * b.stretch + 40.0 * b.lip)
                          / 8192 + 40;
        tp_offset last = tp_breaking_shape(&b, 0).offset;
        for (uint32_t i = 1; i <= 8192; i++) {
            const tp_offset next = tp_breaking_shape(&b, i << 19).offset;
            assert_true(abs(next.along - last.along) <= most);
            assert_true(abs(next.up - last.up) <= most);
            last = next;
        }
    }
}

static void a_shut_gate_leaves_the_orbit(void **state)
{
    (void)state;
    for (int n = 0; n < 1000; n++) {
        tp_breaker b = any_breaker();
        b.kept_stretch = b.kept_lip = 0;
        const tp_turn phi = (tp_turn)random_next(&chance);
        const tp_offset got = tp_breaking_shape(&b, phi).offset;
        const tp_offset want = tp_orbit_evaluate(&b.orbit, phi);
        assert_int_equal(got.along, want.along);
        assert_int_equal(got.up, want.up);
    }
}

/* [B16]: no point of the orbit is lower than the point at Phi_min. */
static void the_lowest_phase_is_the_lowest(void **state)
{
    (void)state;
    for (int n = 0; n < 200; n++) {
        const tp_breaker b = any_breaker();
        const tp_turn lowest = tp_orbit_lowest_phase(&b.orbit);
        const tp_fx least = tp_orbit_evaluate(&b.orbit, lowest).up;
        for (uint32_t i = 0; i < 512; i++)
            assert_true(tp_orbit_evaluate(&b.orbit, lowest + (i << 23)).up >= least - 2);
    }
}

static void the_gate_opens_from_06_to_078(void **state)
{
    (void)state;
    tp_fx last = 0;

    assert_int_equal(tp_breaking_gate(TP_FX(0.6)), 0);
    assert_in_range(tp_breaking_gate(TP_FX(0.69)), TP_FX(0.499), TP_FX(0.501));
    assert_int_equal(tp_breaking_gate(TP_FX(0.78)), TP_FX_ONE);
    assert_int_equal(tp_breaking_gate(TP_FX_MAX), TP_FX_ONE);
    assert_int_equal(tp_breaking_gate(TP_FX_MIN), 0);
    for (tp_fx x = TP_FX(0.59); x < TP_FX(0.79); x += 7) {
        assert_true(tp_breaking_gate(x) >= last);
        last = tp_breaking_gate(x);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crests_follow_their_vectors_to_two_millimetres),
        cmocka_unit_test(the_shape_has_no_gap_anywhere_round_the_turn),
        cmocka_unit_test(a_shut_gate_leaves_the_orbit),
        cmocka_unit_test(the_lowest_phase_is_the_lowest),
        cmocka_unit_test(the_gate_opens_from_06_to_078),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("waves/breaking", tests, NULL, NULL);
}
