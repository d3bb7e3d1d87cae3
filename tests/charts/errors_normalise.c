/* SPDX-License-Identifier: MIT */
/* Unit normals against double precision, over slopes spread evenly within 1. */
#include <stdlib.h>
#include "world/pools.h"
#include "shade/material.h"
#include "tests/charts/spread.h"
#include "tests/charts/used.h"

#define PI    3.14159265358979323846
#define NOISE 1e-13         /* above the error of double precision */

enum { BLOCKS = 256, ONE = 4096 };

/* Value of 1 in a method's results. */
static double one_of(const kernel *k)
{
    static const struct {
        const char *method;
        double      one;
    } coarse[] = {
        { "unit-14", 16384 }, { "steep", 16384 },
        { "packed-", 16384 }, { "packed", 511 }, { "slopes", ONE },
    };

    for (size_t i = 0; i < sizeof coarse / sizeof *coarse; i++)
        if (begins(k->point, coarse[i].method))
            return coarse[i].one;
    return TP_Q30_ONE;
}

typedef struct {
    spread angle, length, whole;        /* degrees; of the length 1; of the vector */
} normalise_errors;

static void judge_one(normalise_errors *e, const int32_t *slope, const int32_t *got,
                      double one)
{
    const double x = -slope[0] / (double)ONE, z = -slope[1] / (double)ONE;
    const double root = sqrt(1 + x * x + z * z), t[3] = { x / root, 1 / root, z / root };
    const double n[3] = { got[0] / one, got[1] / one, got[2] / one };
    const double c[3] = { n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2],
                          n[0] * t[1] - n[1] * t[0] };
    const double d[3] = { n[0] - t[0], n[1] - t[1], n[2] - t[2] };

    const double sine = sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);

    spread_add(&e->angle, sine < NOISE ? 0
               : 180 / PI * atan2(sine, n[0] * t[0] + n[1] * t[1] + n[2] * t[2]));
    spread_add(&e->length, sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) - 1);
    spread_add(&e->whole, sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]));
}

/* -- scenes that use a method -------------------------------------------------------- */

/* The exact light stage interpolates in the table of roots if the water shines, mirrors or
 * is clear; the light stage of plain water takes the nearest entry. */
static bool is_lit(const tp_scene *s, int32_t lit)
{
    return (s->water.specular > 0 || s->water.reflection > 0 || s->water.clarity > 0)
           == lit;
}

/* Walls, drops and land keep packed normals. */
static bool has_packed(const tp_scene *s, int32_t unused)
{
    (void)unused;
    return tp_has_tank(s) || s->drops.count > 0 || s->floor.slope > 0 || s->floor.map[0];
}

/* Meshes bend their normals by normal maps and normalise the result. */
static bool has_mesh(const tp_scene *s, int32_t unused)
{
    (void)unused;
    return s->boat.mesh[0] != 0;
}

static bool never(const tp_scene *s, int32_t unused)
{
    (void)s, (void)unused;
    return false;
}

static void say_who(const kernel *k)
{
    static const struct {
        const char *method;
        used_test  *test;
        int32_t     of;
    } engines[] = {
        { "tp_normalise", NULL, 0 }, { "steep", is_lit, 1 },
        { "steep-near", is_lit, 0 }, { "unit-14", has_mesh, 0 },
        { "packed-32", has_packed, 0 },
    };

    for (size_t i = 0; i < sizeof engines / sizeof *engines; i++)
        if (strcmp(k->point, engines[i].method) == 0) {
            used_row(k->chart, k->point, engines[i].test, engines[i].of);
            return;
        }
    used_row(k->chart, k->point, never, 0);
}

/* Fills the input; packed normals are one word, the format of meshes. */
static void give(const kernel *k, const int32_t *slope, int32_t *in)
{
    memcpy(in, slope, 2 * KERNEL_UNITS * sizeof *in);
    for (uint32_t i = 0; begins(k->point, "packed") && i < 2 * KERNEL_UNITS; i += 2)
        in[i] = (int32_t)tp_dir_pack(tp_normalise(-slope[i], ONE, -slope[i + 1]));
}

/* Checks packed-unit: the method must return the engine's bits. */
static void prove_bits(const kernel *k, const int32_t *in, const int32_t *out)
{
    for (uint32_t i = 0; strcmp(k->point, "packed-unit") == 0 && i < KERNEL_UNITS; i++) {
        const tp_vec_q14 n = tp_vec_q14_unpack((tp_packed_dir)in[2 * i]);
        if (out[3 * i] != n.x || out[3 * i + 1] != n.y || out[3 * i + 2] != n.z) {
            fprintf(stderr, "normalise: packed-unit has other bits\n");
            exit(EXIT_FAILURE);
        }
    }
}

void judge_normalise(const kernel *k, const int32_t *counted, const int32_t *counted_out)
{
    static int32_t slope[2 * KERNEL_UNITS], in[2 * KERNEL_UNITS], out[3 * KERNEL_UNITS];
    const double one = one_of(k);
    normalise_errors e = { 0 };

    (void)counted, (void)counted_out;
    for (uint32_t block = 0, n = 0; block < BLOCKS; block++) {
        for (uint32_t i = 0; i < KERNEL_UNITS; i++, n++) {
            slope[2 * i] = kernel_spread(n, KERNEL_STEP, ONE);
            slope[2 * i + 1] = kernel_spread(n, KERNEL_CROSS, ONE);
        }
        give(k, slope, in);
        k->run(in, out);
        prove_bits(k, in, out);
        for (uint32_t i = 0; i < KERNEL_UNITS; i++)
            judge_one(&e, slope + 2 * i, out + 3 * i, one);
    }
    error_row(k, "angle_max", e.angle.most);
    error_row(k, "length_max", e.length.most);
    spread_rows(k, &e.whole);
    say_who(k);
}
