/* SPDX-License-Identifier: MIT */
/*
 * The fast view into the water: light that waves focus on the floor, and the walls of a
 * tank or of an island.  See fast_refraction_stage.c.
 */
#include "features/underwater/underwater.h"
#include "features/underwater/fast_refraction.h"
#include "shade/colour.h"
#include "shade/material.h"

const uint32_t tp_fast_over[TP_UNDERWATER_ROW] = {
    0, 65536, 32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461, 5041,
    4681, 4369,
};

/* -- caustics ------------------------------------------------------------------------ */

/* The map of caustics as it lies on the floor at one height: place of its corner, m, and
 * the contrast there, 0..1024. */
typedef struct {
    const tp_caustic *map;
    tp_fx   x, z;
    int32_t contrast;
} caustics_at_height;

/* Returns the place on the map, cells, 16.16; mirrored at its edges, and between the
 * centres of the first and the last cell. */
TP_ALWAYS_INLINE uint32_t map_place(int32_t metres, uint32_t per_metre, int32_t side)
{
    int64_t at = (int64_t)metres * per_metre >> 16;

    at = at < 0 ? -at : at > side ? 2 * (int64_t)side - at : at;
    at -= 0x8000;
    return (uint32_t)(at < 0 ? 0 : at > side - 65536 ? side - 65536 : at);
}

/* Returns the fade at the map's edges, 0..256, within an eighth of the side. */
static int32_t edge_fade(uint32_t at, uint32_t cells)
{
    const int32_t last = (int32_t)(cells - 1) * 65536, here = (int32_t)at;
    const int32_t edge = here < last - here ? here : last - here;
    const int32_t share = edge / (int32_t)(cells * 32);
    return share < 256 ? share : 256;
}

/* Returns the caustics at the height y.  (x, z) is a place near by: the map fades at its
 * edges. */
static caustics_at_height caustics_find(const tp_caustic *map, tp_fx y, uint32_t x,
                                        uint32_t z)
{
    const int32_t side = (int32_t)map->cells * 65536;
    const int64_t deep = -(int64_t)y * map->per_depth >> 16;
    caustics_at_height c = {
        map, tp_fx_saturate(map->x + ((int64_t)map->lean_x * y >> 14)),
        tp_fx_saturate(map->z + ((int64_t)map->lean_z * y >> 14)), 0
    };

    if (y >= 0)
        return c;
    c.contrast = map->strength * (int32_t)(deep < 256 ? deep : 256) >> 8;
    if (map->fades) {
        const int32_t u = edge_fade(map_place((int32_t)(x - (uint32_t)c.x),
                                              map->per_metre_x, side), map->cells);
        const int32_t v = edge_fade(map_place((int32_t)(z - (uint32_t)c.z),
                                              map->per_metre_z, side), map->cells);
        c.contrast = c.contrast * (u < v ? u : v) >> 8;
    }
    return c;
}

/* Returns the factor of sunlight at a place, Q8, bilinear between cells. */
TP_ALWAYS_INLINE int32_t caustics_sample(const caustics_at_height *c, uint32_t x, uint32_t z)
{
    const uint32_t n = c->map->cells;
    const int32_t side = (int32_t)n * 65536;
    const uint32_t u = map_place((int32_t)(x - (uint32_t)c->x), c->map->per_metre_x, side);
    const uint32_t v = map_place((int32_t)(z - (uint32_t)c->z), c->map->per_metre_z, side);
    const uint32_t i = u >> 16, j = v >> 16;
    const uint16_t *cell = c->map->light + j * n + i;
    const uint32_t right = i + 1 < n ? 1 : 0, below = j + 1 < n ? n : 0;
    const int32_t fu = u >> 8 & 0xff, fv = v >> 8 & 0xff;
    const int32_t top = cell[0] * (256 - fu) + cell[right] * fu;
    const int32_t low = cell[below] * (256 - fu) + cell[below + right] * fu;
    const int32_t light = (top >> 8) + (((low >> 8) - (top >> 8)) * fv >> 8);
    const int32_t factor = 256 + ((light - 256) * c->contrast >> 8);

    return factor > 0 ? factor : 0;
}

/* Returns the samples from one reading of the map to the next: 2, or 4 where the block is
 * less than three cells long. */
static int32_t reading_interval(const tp_caustic *map, const tp_floor_place *first,
                                const tp_floor_place *last)
{
    const int64_t x = (int64_t)tp_abs((int32_t)(last->x - first->x) / 2) * map->per_metre_x;
    const int64_t z = (int64_t)tp_abs((int32_t)(last->z - first->z) / 2) * map->per_metre_z;

    return ((x > z ? x : z) >> 31) < 3 ? 4 : 2;
}

/* Multiplies a texel by light in Q8 and 16 more bits. */
TP_ALWAYS_INLINE uint32_t light_texel(uint32_t texel, uint32_t light)
{
    const int32_t gain = (int32_t)(light >> 16);

    return (uint32_t)tp_usat((int32_t)(texel >> 16 & 0xff) * gain, 8, 8) << 16
         | (uint32_t)tp_usat((int32_t)(texel >> 8 & 0xff) * gain, 8, 8) << 8
         | (uint32_t)tp_usat((int32_t)(texel & 0xff) * gain, 8, 8);
}

/* Returns the light of the floor at a place, Q8, at most 4. */
TP_ALWAYS_INLINE int32_t floor_light(const caustics_at_height *c, int32_t ambient,
                                     int32_t sun, uint32_t x, uint32_t z)
{
    const int32_t light = ambient + (sun * caustics_sample(c, x, z) >> 8);
    return light < 1023 ? light : 1023;
}

void tp_fast_caustics_light(const tp_shade *shade, const tp_floor_block *block,
                            const tp_floor_place *place, uint32_t *texel)
{
    const int32_t sun = block->sun, ambient = block->light - sun, last = block->samples - 1;
    const caustics_at_height c = caustics_find(shade->caustic, block->floor_y, place[0].x,
                                               place[0].z);
    const int32_t interval = reading_interval(c.map, &place[0], &place[last]);
    int32_t here = floor_light(&c, ambient, sun, place[0].x, place[0].z);

    for (int32_t k = 0; k < last; ) {
        const int32_t end = k + interval < last ? k + interval : last;
        const int32_t next = floor_light(&c, ambient, sun, place[end].x, place[end].z);
        const uint32_t step = (uint32_t)(next - here) * tp_fast_over[end - k];
        uint32_t light = (uint32_t)here << 16;
        for (; k < end; k++, light += step)
            texel[k] = light_texel(texel[k], light);
        here = next;
    }
    texel[last] = light_texel(texel[last], (uint32_t)here << 16);
}

/* -- walls --------------------------------------------------------------------------- */

#define NO_WALL (1 << 16)       /* share of a way that ends before a wall, Q16 */

/* Returns the share, Q16, of the way `along` at which a wall is met. */
static int32_t share_to_wall(tp_fx from, int32_t along, tp_fx low, tp_fx high)
{
    const tp_fx gap = along > 0 ? tp_fx_sub_sat(high, from) : tp_fx_sub_sat(from, low);
    const uint32_t far = (uint32_t)tp_abs(along);

    if (gap <= 0)
        return 0;
    if ((uint32_t)gap >= far)
        return NO_WALL;
    const int shift = tp_clz(far);
    return (int32_t)((int64_t)gap * tp_recip_rough(far << shift) >> (46 - shift));
}

/* A column whose ray meets a wall. */
typedef struct {
    tp_vec3 at;                 /* the point of the wall, m */
    tp_fx   path, far;          /* to that point: in the water; from the eye; m */
    bool    across_z;           /* the wall lies across z */
    bool    high;               /* the wall at the higher coordinate */
} wall_point;

/* Returns the light of a wall: its normal points against the ray. */
static uint32_t wall_light(const tp_shade *shade, const wall_point *p)
{
    const tp_underwater *in = shade->underwater;
    const int32_t sun = p->across_z ? in->sun_z : in->sun_x;
    const int32_t nl = tp_clamp(p->high ? -sun : sun, 0, 16384);
    const int32_t direct = (256 - shade->ambient) * nl >> 14;
    int32_t factor = 256;

    if (shade->caustic && direct > 0) {
        const caustics_at_height c = caustics_find(shade->caustic, p->at.y,
                                                   (uint32_t)p->at.x, (uint32_t)p->at.z);
        factor = caustics_sample(&c, (uint32_t)p->at.x, (uint32_t)p->at.z);
    }
    return (uint32_t)(shade->ambient + (direct * factor >> 8));
}

static uint32_t wall_colour(const tp_shade *shade, const wall_point *p, uint32_t own)
{
    const tp_underwater *in = shade->underwater;
    const uint32_t texel = tp_wall_material_sample(
        &in->wall, p->across_z ? p->at.x : p->at.z, (tp_fx)(0u - (uint32_t)p->at.y), p->far,
        false);

    return tp_absorb_apply(&in->absorb, tp_colour_brighten(texel, wall_light(shade, p)), own,
                           p->path);
}

/* Finds the wall that a column's ray meets before the floor; false: none. */
static bool find_wall(const tp_underwater *in, const tp_floor_block *block, tp_fx x, tp_fx z,
                      int32_t way_x, int32_t way_z, wall_point *p)
{
    const int32_t to_x = share_to_wall(x, way_x, in->x0, in->x1);
    const int32_t to_z = share_to_wall(z, way_z, in->z0, in->z1);
    const int32_t share = to_x < to_z ? to_x : to_z;

    if (share >= NO_WALL)
        return false;
    *p = (wall_point){
        { tp_fx_add_sat(x, (tp_fx)((int64_t)way_x * share >> 16)),
          tp_fx_add_sat(block->at_y,
                        (tp_fx)(((int64_t)block->floor_y - block->at_y) * share >> 16)),
          tp_fx_add_sat(z, (tp_fx)((int64_t)way_z * share >> 16)) },
        (tp_fx)((int64_t)block->path * share >> 16), 0, to_z <= to_x,
        (to_z <= to_x ? way_z : way_x) > 0
    };
    p->far = tp_fx_add_sat(block->far - block->path, p->path);
    return true;
}

static bool is_outside(const tp_underwater *in, tp_fx x, tp_fx z)
{
    return x < in->x0 || x > in->x1 || z < in->z0 || z > in->z1;
}

void tp_fast_walls(const tp_shade *shade, const tp_floor_block *block,
                   const tp_floor_place *place, const uint32_t *own, uint32_t *mixed)
{
    const tp_underwater *in = shade->underwater;
    wall_point p;

    for (int32_t j = 0; j < block->samples; j++) {
        const tp_fx x = (tp_fx)place[j].s, z = (tp_fx)place[j].t;
        const bool beyond = in->island && is_outside(in, x, z);
        if (!beyond && !is_outside(in, (tp_fx)place[j].x, (tp_fx)place[j].z))
            continue;
        const uint32_t body = tp_fast_own_colour(in->deep, own[tp_fast_column(block, j)],
                                                 block->lit);
        if (beyond)
            mixed[j] = body;
        else if (find_wall(in, block, x, z, (int32_t)(place[j].x - place[j].s),
                           (int32_t)(place[j].z - place[j].t), &p))
            mixed[j] = wall_colour(shade, &p, body);
    }
}
