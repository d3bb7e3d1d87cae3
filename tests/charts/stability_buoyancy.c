/* SPDX-License-Identifier: MIT */
/* The surface above a place [E1]: errors of each search method over q, the sum of
 * steepnesses. */
#include "tests/charts/stability.h"
#include "tests/charts/used.h"

#define CHART "stability-buoyancy"

enum { WAVES = 2, SIDE = 16, TIMES = 24, TRUE_STEPS = 4000 };

#define BETWEEN TP_FX(3.21875)  /* distance of the places, m */
#define LATER   7               /* distance of the times, ticks */

typedef struct {
    double x, y, z;
} buoyancy_spot;

/* f - mean of [A3]; with a power of 1 the sine itself. */
static double profile(const tp_swell *w, double sine)
{
    return w->power > 1 ? 2 * pow((sine + 1) / 2, w->power) - w->mean_q24 / 16777216.0
                        : sine;
}

/* Displaced point in double precision from the engine's own wave numbers, so the only error
 * measured is the search. */
static buoyancy_spot moved(const tp_deep_water *deep, const tp_turn *phases, double x,
                           double z)
{
    const double turn = 2 * STABILITY_PI, whole = 4294967296.0;
    buoyancy_spot s = { x, 0, z };

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        double th = turn * (((double)w->turns_x * x + (double)w->turns_z * z
                             + phases[i]) / whole);
        s.x += w->orbit_x * STABILITY_LSB * cos(th);
        s.z += w->orbit_z * STABILITY_LSB * cos(th);
        s.y += w->amplitude * STABILITY_LSB * profile(w, sin(th));
    }
    return s;
}

/* Height by plain steps, each reducing the distance by q, until the point no longer
 * moves. */
static double height_above(const tp_deep_water *deep, const tp_turn *phases, double x,
                           double z)
{
    double at_x = x, at_z = z;

    for (int i = 0; i < TRUE_STEPS; i++) {
        const buoyancy_spot s = moved(deep, phases, at_x, at_z);
        if (hypot(s.x - x, s.z - z) < 1e-13)
            break;
        at_x += x - s.x;
        at_z += z - s.z;
    }
    return moved(deep, phases, at_x, at_z).y;
}

static tp_surface_point found(const tp_deep_water *deep, const tp_turn *phases, tp_fx x,
                              tp_fx z, stability_search how, uint32_t n, tp_fx rest[2])
{
    return how == STABILITY_PLAIN ? tp_deep_water_sample_iterated(deep, phases, x, z, n)
                                  : tp_deep_water_sample(deep, phases, x, z,
                                                 how == STABILITY_WARM ? rest : NULL);
}

/* Measures one place over all times; a warm search begins with a cold search, which counts
 * too. */
static void look(const tp_deep_water *deep, tp_fx x, tp_fx z, stability_search how,
                 uint32_t n, stability_off *off)
{
    tp_fx rest[2] = { x, z };

    for (uint64_t tick = 0; tick < TIMES; tick++) {
        tp_turn phases[TP_WAVES];
        tp_deep_water_phases(deep, tick * LATER, 0, phases);
        const tp_vec3 p = found(deep, phases, x, z, how, n, rest).position;
        off->along = fmax(off->along, hypot(p.x - x, p.z - z) * STABILITY_LSB);
        if (stability_sum(deep) >= 1)
            continue;
        const double  y = height_above(deep, phases, x * STABILITY_LSB, z * STABILITY_LSB);
        off->up = fmax(off->up, fabs(p.y * STABILITY_LSB - y));
    }
}

stability_off stability_inversion(const tp_deep_water *deep, stability_search how,
                                  uint32_t n)
{
    stability_off off = { 0, 0 };

    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++)
            look(deep, i * BETWEEN, j * BETWEEN, how, n, &off);
    return off;
}

double stability_bound(const tp_deep_water *deep, stability_search how, uint32_t n)
{
    if (how != STABILITY_PLAIN)
        return hypot(2, 2) * STABILITY_LSB;
    return pow(stability_sum(deep), n) * deep->max_displacement * STABILITY_LSB;
}

/* -- the map ------------------------------------------------------------------------- */

static void rows(const char *method, const tp_deep_water *deep, stability_search how,
                 uint32_t n, const char *used)
{
    const double q = stability_sum(deep);
    const stability_off off = stability_inversion(deep, how, n);

    printf(CHART ",%s;%.3g,along,%.3g\n", method, q, off.along);
    if (q < 1)
        printf(CHART ",%s;%.3g,up,%.3g\n", method, q, off.up);
    else                                        /* there are several heights */
        printf(CHART ",%s;%.3g,up,-\n", method, q);
    printf(CHART ",%s;%.3g,bound,%.3g\n", method, q, stability_bound(deep, how, n));
    printf(CHART ",%s;%.3g,used,%s\n", method, q, used);
}

static void rows_of_scenes(void)
{
    const char *name;

    for (size_t i = 0; used_scene(i, &name); i++) {
        const tp_scene *scene = used_scene(i, &name);
        tp_deep_water deep;
        tp_deep_water_init(&deep, scene->wave, TP_WAVES, scene->water.gravity);
        if (scene->boat.mesh[0] && deep.steepness_sum > 0)
            rows(name, &deep, STABILITY_COLD, 0, name);
    }
}

/* Plain steps also cover sums above the clamp of the engine's deep water. */
static void rows_of_plain(uint32_t steps)
{
    char name[16];

    snprintf(name, sizeof name, "plain-%u", (unsigned)steps);
    for (int i = 1; i <= 26; i++) {
        const tp_deep_water deep = stability_sea_unheld(WAVES, 0, i / 20.0);
        rows(name, &deep, STABILITY_PLAIN, steps, "-");
    }
}

void stability_buoyancy(void)
{
    for (uint32_t steps = 1; steps <= 16; steps *= 2)
        rows_of_plain(steps);
    for (int i = 1; i <= 19; i++) {
        const tp_deep_water deep = stability_sea(WAVES, 0, i / 20.0);
        rows("engine", &deep, STABILITY_COLD, 0, "-");
        rows("engine-warm", &deep, STABILITY_WARM, 0, "-");
    }
    rows_of_scenes();
}
