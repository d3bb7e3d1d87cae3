/* SPDX-License-Identifier: MIT */
/* Normals against the exact normal [A10] at the same place of the world in double
 * precision; the rest point is solved for in double precision too. */
#include <string.h>
#include "tests/charts/errors.h"
#include "tests/charts/normals.h"
#include "tests/charts/used.h"
#include "tools/reference/deep_water.h"
#include "waves/deep_water.h"

#define LSB (1 / 65536.0)

/* Angle between the surface's normal and the normal of slopes in 16.16, degrees. */
static double degrees_off(const ref_point *p, const int32_t slope[2])
{
    const double n[3] = { -slope[0] * LSB, 1, -slope[1] * LSB };
    const double x = p->ny * n[2] - p->nz * n[1], y = p->nz * n[0] - p->nx * n[2];
    const double z = p->nx * n[1] - p->ny * n[0];
    const double dot = p->nx * n[0] + p->ny * n[1] + p->nz * n[2];

    return atan2(sqrt(x * x + y * y + z * z), dot) * 180 / PI;
}

/* True if the scene uses the method, by the method's first letter: waves with or without
 * cross terms in their normals; a pool, whose slopes span one cell; ripple maps, with 8
 * bits. Waves over a floor or in wind are coastal water and do not count. */
static bool takes(const tp_scene *scene, int32_t method)
{
    tp_deep_water deep;

    tp_deep_water_init(&deep, scene->wave, used_coast(scene) ? 0 : TP_WAVES,
                       scene->water.gravity);
    switch (method) {
    case 'e': return deep.count > 0 && deep.crossed;
    case 'c': return deep.count > 0 && !deep.crossed;
    case 'f': return scene->pool.cols > 0 || scene->field.cols > 0;
    case 'm': return scene->ripple.map.texture[0] != '\0' && scene->ripple.bump > 0;
    default:  return false;
    }
}

/* Returns 0 for a method that no scene can use. */
static int32_t method_of(const char *point)
{
    static const char *const engine[] = { "exact", "cheap", "five-1", "map-8" };

    for (size_t i = 0; i < sizeof engine / sizeof *engine; i++)
        if (strcmp(point, engine[i]) == 0)
            return point[0];
    return 0;
}

void judge_normals(const kernel *k, const int32_t *in, const int32_t *out)
{
    const ref_deep_water deep =
        ref_deep_water_make(normals_wave, NORMALS_WAVES, NORMALS_GRAVITY);
    double phase[TP_WAVES], worst = 0, sum = 0;

    (void)in;
    ref_phases(&deep, NORMALS_TICK, phase);
    for (uint32_t i = 0; i < KERNEL_UNITS; i++, out += 2) {
        const ref_point p =
            ref_sample_deep_water(&deep, phase, normals_x(i) * LSB, normals_z(i) * LSB);
        const double off = degrees_off(&p, out);
        worst = fmax(worst, off);
        sum += off * off;
    }
    error_row(k, "normal_max", worst);
    error_row(k, "normal_rms", sqrt(sum / KERNEL_UNITS));
    used_row(k->chart, k->point, takes, method_of(k->point));
}
