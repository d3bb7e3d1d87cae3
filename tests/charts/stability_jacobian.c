/* SPDX-License-Identifier: MIT */
/* Onset of looping crests [A11]: the least eigenvalue of the Jacobian, 0 where the surface
 * folds, over the sum of steepnesses. */
#include "tests/charts/stability.h"
#include <string.h>
#include "tests/charts/used.h"
#include "waves/deep_water.h"

#define CHART "stability-jacobian"

enum { SIDE = 48, TIMES = 40, HALVINGS = 12 };

#define BETWEEN TP_FX(1.0625)   /* distance of the sweep's places, m */
#define LATER   433             /* distance of the sweep's times, ticks */

typedef struct {
    int64_t x, z, tick;
    double  least;
} jacobian_spot;

static double eigenvalue(const tp_swell_sum *sum)
{
    const double one = 18014398509481984.0;     /* 2^54 */
    double xx = 1 - (double)sum->bxx / one, zz = 1 - (double)sum->bzz / one;
    double xz = (double)sum->bxz / one;

    return (xx + zz) / 2 - sqrt((xx - zz) * (xx - zz) / 4 + xz * xz);
}

static double eigenvalue_at(const tp_deep_water *deep, const tp_turn *phases, int64_t x,
                            int64_t z)
{
    tp_turn a[TP_WAVES], b[TP_WAVES];

    for (uint32_t i = 0; i < deep->count; i++) {
        a[i] = phases[i] + tp_swell_turns(deep->swell[i].turns_x, (tp_fx)x);
        b[i] = tp_swell_turns(deep->swell[i].turns_z, (tp_fx)z);
    }
    const tp_swell_sum sum = tp_swell_sum_all(deep, a, b, 0, 1);
    return eigenvalue(&sum);
}

/* Least of the sweep's places at one time. */
static jacobian_spot swept(const tp_deep_water *deep, int64_t tick)
{
    jacobian_spot    best = { 0, 0, tick, 9 };
    tp_turn phases[TP_WAVES];

    tp_deep_water_phases(deep, (uint64_t)tick, 0, phases);
    for (int64_t j = 0; j < SIDE; j++)
        for (int64_t i = 0; i < SIDE; i++) {
            double e = eigenvalue_at(deep, phases, i * BETWEEN, j * BETWEEN);
            if (e < best.least)
                best = (jacobian_spot){ i * BETWEEN, j * BETWEEN, tick, e };
        }
    return best;
}

static bool better(const tp_deep_water *deep, jacobian_spot *best, int64_t dx, int64_t dz,
                   int64_t dt)
{
    const jacobian_spot s = { best->x + dx, best->z + dz, best->tick + dt, 0 };
    tp_turn phases[TP_WAVES];

    if (s.tick < 0)
        return false;
    tp_deep_water_phases(deep, (uint64_t)s.tick, 0, phases);
    const double e = eigenvalue_at(deep, phases, s.x, s.z);
    if (e >= best->least)
        return false;
    *best = s;
    best->least = e;
    return true;
}

/* Descends over places and time, halving the steps. */
static double settled(const tp_deep_water *deep, jacobian_spot at)
{
    int64_t step = BETWEEN / 2, ticks = 64;

    for (int n = 0; n < HALVINGS; n++, step /= 2, ticks = ticks > 1 ? ticks / 2 : 1) {
        const int64_t ways[6][3] = { { step }, { -step }, { 0, step }, { 0, -step },
                                     { 0, 0, ticks }, { 0, 0, -ticks } };
        bool moved = true;
        for (int turns = 0; moved && turns < 50; turns++) {
            moved = false;
            for (int k = 0; k < 6; k++)
                if (better(deep, &at, ways[k][0], ways[k][1], ways[k][2]))
                    moved = true;
        }
    }
    return at.least;
}

double stability_least(const tp_deep_water *deep)
{
    double least = 9;

    for (int n = 0; n < TIMES; n++)
        least = fmin(least, settled(deep, swept(deep, LATER * n)));
    return least;
}

/* -- the map ------------------------------------------------------------------------- */

static void row(const char *deep, int waves, double sum, const char *column, double value)
{
    printf(CHART ",%s;%d;%.3g,%s,%.3g\n", deep, waves, sum, column, value);
}

static void rows_of(const char *name, int waves, double fan)
{
    for (int i = 1; i <= 38; i++) {
        const double sum = i / 20.0;
        const tp_deep_water held = stability_sea(waves, fan, sum);
        const tp_deep_water unheld = stability_sea_unheld(waves, fan, sum);

        row(name, waves, sum, "crests", stability_crests(&unheld));
        row(name, waves, sum, "unheld", stability_least(&unheld));
        row(name, waves, sum, "engine", stability_least(&held));
        printf(CHART ",%s;%d;%.3g,used,-\n", name, waves, sum);
    }
}

static const tp_scene *scene_at(size_t i)
{
    const char *name;
    return used_scene(i, &name);
}

static bool is_same_sea(const tp_scene *scene, int32_t as)
{
    const tp_scene *other = scene_at((size_t)as);

    return scene->water.gravity == other->water.gravity
        && memcmp(scene->wave, other->wave, sizeof scene->wave) == 0;
}

static bool is_told(size_t i)
{
    for (size_t before = 0; before < i; before++)
        if (is_same_sea(scene_at(before), (int32_t)i))
            return true;
    return false;
}

/* Rows of the shipped scenes' own waves, treated as deep water, each once. */
static void rows_of_scenes(void)
{
    const char *name;

    for (size_t i = 0; used_scene(i, &name); i++) {
        const tp_scene *scene = used_scene(i, &name);
        tp_deep_water deep;
        tp_deep_water_init(&deep, scene->wave, TP_WAVES, scene->water.gravity);
        const double sum = deep.steepness * STABILITY_LSB;
        if (sum <= 0 || is_told(i))
            continue;
        const tp_deep_water unheld = stability_unheld(scene->wave, TP_WAVES,
                                               scene->water.gravity);
        row(name, (int)deep.count, sum, "crests", stability_crests(&unheld));
        row(name, (int)deep.count, sum, "unheld", stability_least(&unheld));
        row(name, (int)deep.count, sum, "engine", stability_least(&deep));
        printf(CHART ",%s;%d;%.3g,used,%s\n", name, (int)deep.count, sum,
               used_by(is_same_sea, (int32_t)i));
    }
}

void stability_jacobian(void)
{
    rows_of("one-way", 1, 0);
    rows_of("one-way", 2, 0);
    rows_of("one-way", 4, 0);
    rows_of("one-way", 8, 0);
    rows_of("fan", 4, 120);
    rows_of_scenes();
}
