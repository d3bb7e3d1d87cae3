/* SPDX-License-Identifier: MIT */
/* Cover, ranks and light of foam; see the header. */
#include "foam.h"
#include "features/foam/foam.h"
#include "map.h"
#include "waves/coastal_tables.h"
#include "world/pools.h"

#define OPAQUE (15 / 16.0)      /* largest opacity */
#define LACE   (236 / 256.0)    /* white share of full cover */
#define BAND   0.25             /* opacity of the bubbles below full cover */
#define FAR_MOST  (216 / 255.0) /* largest far cover */
#define OLD_MEAN  (16 / 255.0)  /* mean of the field from which on there is all old foam */
#define RADIAN 0.017453292519943295769 /* radians of a degree */
#define COARSE 5                /* mipmap level from which the threshold covers all ranks */

/* Rank of a green: the share of darker texels, with half of the equal texels. */
static void make_ranks(ref_foam *foam, const tp_texture *t)
{
    const uint32_t texels = 1u << (t->log2_w + t->log2_h);
    uint32_t count[256] = { 0 };
    double below = 0;

    for (uint32_t i = 0; i < texels; i++)
        count[t->level[0][i] >> 8 & 255]++;
    for (int green = 0; green < 256; green++) {
        foam->rank[green] = (below + count[green] / 2.0) / texels;
        below += count[green];
    }
    foam->mean = foam->rank[t->level[t->levels - 1][0] >> 8 & 255];
}

/* Lattice origin at the drawn moment, `back` of a tick before the world's tick, m. */
static double lattice_origin(int64_t drift, tp_fx speed, double back)
{
    return ldexp((double)drift, -32) - ref_number(speed) * back / TP_TICKS_PER_SECOND;
}

/* Sets the cover beyond the window, by the field's mean: half of the mean on all water but
 * the waves' fronts, less if the mean is small; and 1.375 to 1.25 of it by the slopes. */
static void set_far_foam(ref_foam *f, const tp_world *world, double mean)
{
    const tp_deep_water *deep = &world->deep;
    const double old = fmin(1, mean / OLD_MEAN) / 2;
    double square = 0, x = 0, z = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        x += deep->swell[i].slope_x;
        z += deep->swell[i].slope_z;
        square += (pow(ldexp(deep->swell[i].slope_x, -30), 2)
                   + pow(ldexp(deep->swell[i].slope_z, -30), 2)) / 2;
    }
    f->far_old = old * mean;
    if (square == 0 || hypot(x, z) == 0)
        return;
    f->far_fresh = (1.375 - old / 2) * mean / pow(square, 2);
    f->way_x = x / hypot(x, z);
    f->way_z = z / hypot(x, z);
    f->slope = 2 * sqrt(square);
}

/* Sets the cover by the depth of the floor: the means are the world's, as data. */
static void set_surf(ref_foam *f, const tp_world *world, const tp_scene *scene,
                     const tp_foam *foam)
{
    const tp_coastal_water *coastal = tp_world_coastal(world);
    const tp_deep_water *deep = &world->deep;
    double most = 0;
    tp_foam_maker make;

    f->by_depth = true;
    f->deep = ref_number(tp_coastal_breaking_foam_depth(coastal));
    for (uint32_t i = 0; i < deep->count; i++) {
        const double ticks = 1 / ldexp((double)deep->swell[i].turns_tick, -64);
        if (ref_number(deep->swell[i].amplitude) > most)
            f->swing = fmin(1, ticks / TP_TICKS_PER_SECOND
                               / (4 * ref_number(scene->foam.fade)));
        most = fmax(most, ref_number(deep->swell[i].amplitude));
    }
    tp_foam_maker_begin(&make, (tp_foam *)(uintptr_t)foam, &tp_program_all.water, world,
                        scene);
    for (int n = 0; n <= REF_SURF; n++)
        f->surf[n] = tp_foam_maker_mean_cover(
            &make, (tp_fx)(2 * f->deep * n / REF_SURF * 65536 + 1),
            foam->visits / TP_FOAM_TICKS) / 255.0;
}

/* Sets the direction of a straight beach if its water line passes the window's middle within
 * half of the radius; else returns false. */
static bool set_shore(ref_foam *f, const tp_scene *scene)
{
    const double heading = ref_number(scene->floor.heading) * RADIAN;
    const double radius = f->cells * f->cell / 2, slope = ref_number(scene->floor.slope);
    const double x = f->drift_x + f->first_x * f->cell + radius;
    const double z = f->drift_z + f->first_z * f->cell + radius;
    const double depth =
        ref_number(scene->floor.depth) - slope * (x * sin(heading) - z * cos(heading));

    if (fabs(depth) >= slope * radius / 2)
        return false;
    f->shore_x = cos(heading);
    f->shore_z = sin(heading);
    return true;
}

void ref_foam_open(ref_scene *s, const tp_world *world)
{
    const tp_foam *foam = tp_world_foam(world);
    const tp_scene_map *map = &s->scene->foam.map;
    const double back = ref_number(world->lag);

    if (!foam)
        return;
    s->foam = (ref_foam){
        .cover = (const uint8_t *)(foam + 1), .cells = (int)foam->cells,
        .first_x = foam->first_x, .first_z = foam->first_z,
        .cell = ref_number(foam->cell),
        .drift_x = lattice_origin(foam->drift_x, map->drift_x, back),
        .drift_z = lattice_origin(foam->drift_z, map->drift_z, back),
        .fades = !tp_world_pool(world),
    };
    const bool floor = s->foam.fades && tp_has_floor(s->scene);
    const bool straight = floor && !s->assets->floor;
    if (s->foam.fades)
        set_far_foam(&s->foam, world,
                     straight ? 0 : tp_foam_open_mean(foam, world) / 65280.0);
    if (floor && tp_world_coastal(world) && !(straight && set_shore(&s->foam, s->scene)))
        set_surf(&s->foam, world, s->scene, foam);
    if (s->assets->foam)
        make_ranks(&s->foam, s->assets->foam);
}

/* -- cover --------------------------------------------------------------------------- */

/* Cover of the cell (i, j) of the window, 0..1. The cells are stored as a torus. */
static double cell_cover(const ref_foam *f, int i, int j)
{
    const int n = f->cells, most = n - 1;
    const int64_t col = (int64_t)f->first_x + (i < 0 ? 0 : i > most ? most : i);
    const int64_t row = (int64_t)f->first_z + (j < 0 ? 0 : j > most ? most : j);

    return f->cover[(row % n + n) % n * n + (col % n + n) % n] / 255.0;
}

static double mix(double a, double b, double share)
{
    return a + share * (b - a);
}

double ref_foam_cover(const ref_foam *f, double x0, double z0, double *weight)
{
    const double u = (x0 - f->drift_x) / f->cell - f->first_x;
    const double w = (z0 - f->drift_z) / f->cell - f->first_z;
    const double r = f->cells / 2.0, square = pow(u / r - 1, 2) + pow(w / r - 1, 2);

    *weight = 0;
    if (!(u >= 0 && w >= 0 && u < f->cells && w < f->cells))
        return 0;
    *weight = f->fades ? ref_clamp((1 - square) * 16 / 7, 0, 1) : 1;
    const int i = (int)floor(u - 0.5), j = (int)floor(w - 0.5);
    return mix(mix(cell_cover(f, i, j), cell_cover(f, i + 1, j), u - 0.5 - i),
               mix(cell_cover(f, i, j + 1), cell_cover(f, i + 1, j + 1), u - 0.5 - i),
               w - 0.5 - j);
}

/* Cover times its weight. */
static double weighed_cover(const ref_foam *f, double x, double z)
{
    double weight, cover = ref_foam_cover(f, x, z, &weight);
    return cover * weight;
}

/* Cover beyond the window along a straight beach: the stretch of 7/8 of the window's radius
 * repeats; over its last eighth it passes into that before its beginning. */
static double shore_cover(const ref_foam *f, double x0, double z0)
{
    const double side = f->cells * f->cell, stretch = side * 7 / 16;
    const double x = x0 - f->drift_x - f->first_x * f->cell - side / 2;
    const double z = z0 - f->drift_z - f->first_z * f->cell - side / 2;
    const double along = x * f->shore_x + z * f->shore_z;
    const double back = stretch * floor(along / stretch + 0.5);
    const double left = back + stretch / 2 - along;
    const double here = weighed_cover(f, x0 - back * f->shore_x, z0 - back * f->shore_z);
    const double before = weighed_cover(f, x0 - (back + stretch) * f->shore_x,
                                        z0 - (back + stretch) * f->shore_z);

    return mix(before, here, fmin(1, left / (stretch / 8)));
}

/* Cover of open water: old foam but on the waves' fronts, and fresh foam by the slope. */
static double open_cover(const ref_foam *f, const ref_water *w)
{
    const double square = w->slope_x * w->slope_x + w->slope_z * w->slope_z;
    const double up = w->slope_x * f->way_x + w->slope_z * f->way_z;

    return up < 0 ? 0 : fmin(f->far_old + f->far_fresh * square * up * up, FAR_MOST);
}

/* Cover by the depth of the floor: the mean of the surf, more on the waves' backs and less
 * on their fronts, and the share of open water. */
static double surf_cover(const ref_scene *s, const ref_water *w)
{
    const ref_foam *f = &s->foam;
    const double depth = ref_coastal_floor(s->surface.coastal, w->x0, w->z0).depth;
    const double at = ref_clamp(depth / (2 * f->deep), 0, 1) * REF_SURF;
    const int n = at < REF_SURF ? (int)at : REF_SURF - 1;
    const double up = w->slope_x * f->way_x + w->slope_z * f->way_z;
    const double back = f->slope > 0 ? ref_clamp(up / f->slope, -1, 1) : 0;

    if (depth <= 0)
        return 0;
    return fmin(1, mix(f->surf[n], f->surf[n + 1], at - n) * (1 + f->swing * back)
                   + ref_clamp(depth / f->deep - 1, 0, 1) * open_cover(f, w));
}

/* Cover of the water beyond the window. */
static double far_cover(const ref_scene *s, const ref_water *w)
{
    const ref_foam *f = &s->foam;

    if (f->by_depth)
        return surf_cover(s, w);
    if (f->shore_x != 0 || f->shore_z != 0)
        return shore_cover(f, w->x0, w->z0);
    return open_cover(f, w);
}

/* -- bubbles ------------------------------------------------------------------------- */

/* The ramp is `soft` ranks wide. No cover shifts the ramp above all ranks; full cover
 * shifts it below nearly all. At most four times the cover is white: foam comes and goes
 * without a jump. */
double ref_foam_white(double cover, double rank, int level)
{
    const double coarse = ref_clamp((double)level / COARSE, 0, 1);
    const double soft = mix(80 / 256.0, 1, coarse), span = mix(168 / 256.0, 0.5, coarse);
    const double up = rank + soft / 2 - span * (1 - 2 * LACE * cover);

    return ref_clamp(up / soft, 0, fmin(1, 4 * cover));
}

static double green_rank(const ref_foam *foam, double green)
{
    const int low = (int)ref_clamp(floor(green), 0, 254);
    return mix(foam->rank[low], foam->rank[low + 1], green - low);
}

/* Rank of the drifting texture, `size` as large, above the rank of its mean; 0 for levels
 * that are not read. */
static double rank_above_mean(const ref_scene *s, const ref_water *w, int size, int *level)
{
    const tp_texture *t = s->assets->foam;
    tp_scene_map map = s->scene->foam.map;

    map.size *= size;
    const double lod = ref_water_lod(s, (1 << t->log2_w) / ref_number(map.size), w->at);
    *level = ref_level(s, t, lod);
    if (*level >= COARSE)
        return 0;
    const ref_colour texel = ref_sample_map(s, t, &map, w->x0, w->z0, w->at, true);
    return green_rank(&s->foam, texel.c[1])
         - mix(0.5, s->foam.mean, (double)*level / COARSE);
}

double ref_foam_patched(double cover, double rank)
{
    return cover + 1.6 * rank * cover * (1 - cover);
}

double ref_foam_lace(double cover, double white)
{
    return OPAQUE * white + (1 - OPAQUE * white) * BAND * cover;
}

double ref_foam_opacity(const ref_scene *s, const ref_water *w)
{
    const ref_foam *foam = &s->foam;
    double weight, cover;
    int level = COARSE;

    if (!foam->cover)
        return 0;
    cover = ref_foam_cover(foam, w->x0, w->z0, &weight);
    cover = mix(far_cover(s, w), cover, weight);
    if (cover <= 0)
        return 0;
    if (s->assets->foam)
        cover = ref_foam_patched(cover, rank_above_mean(s, w, 4, &level));
    const double rank = s->assets->foam ? rank_above_mean(s, w, 1, &level) : 0;
    return ref_foam_lace(cover, ref_foam_white(cover, rank, level));
}

/* Bubbles scatter light: the foam is half way between the water's light and full light. */
ref_colour ref_foam_colour(const ref_scene *s, double nl)
{
    return ref_scale(ref_colour_unpack((uint32_t)s->scene->foam.colour),
                     (1 + s->ambient + (1 - s->ambient) * nl) / 2);
}
