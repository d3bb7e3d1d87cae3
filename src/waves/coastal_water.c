/* SPDX-License-Identifier: MIT */
/* The surface of coastal water at a point: [B8]-[B19] of the models, evaluated from
 * tables. */
#include "waves/coastal_tables.h"
#include "waves/deep_water.h"

/* -- the surface --------------------------------------------------------------------- */

/* Phi is the models' phase of an orbit, 0 in the trough: a quarter turn more than the phase
 * of the sines of deep water [A7].  In deep water, where the tables end, a point equals the
 * point of the tp_deep_water.  The horizontal part of an orbit follows the local direction
 * of travel: particles move across their crests.  A crest breaks by its height before the
 * cap of [B15]: the cap limits the drawn height, and the gate opens as the depth falls
 * below the depth that the uncapped wave needs. */

#define QUARTER 0x40000000u

/* -- the floor under a point --------------------------------------------------------- */

typedef struct {
    tp_fx    depth;
    tp_fx    rise_x, rise_z;    /* slopes of a map */
    tp_coastal_table_place at;  /* table position; valid for a depth > 0 */
    size_t   node;              /* map node north-west of the point; fraction_x, fraction_z:
                                 * fractions to the next node, Q16 */
    int32_t  fraction_x, fraction_z;
} floor_place;

/* Returns the distance from the first node in nodes, Q16, clamped to the map.  |way| <= 128
 * steps and a step of at least 2^9 leave the product 57 bits.  map_per_step is rounded
 * down: the quotient of a way below `last` is below nodes - 1. */
static uint32_t node_coordinate(const tp_coastal_water *coastal, int64_t distance,
                                uint32_t nodes)
{
    const int64_t last = (int64_t)coastal->map_step * (nodes - 1);

    if (distance <= 0)
        return 0;
    if (distance >= last)
        return ((nodes - 1) << 16) - 1;
    return (uint32_t)((uint64_t)distance * coastal->map_per_step >> 32);
}

/* Interpolates between the four nodes around a point. */
static inline int32_t interpolate_nodes(int32_t a, int32_t b, int32_t c, int32_t d,
                                        const floor_place *p)
{
    return tp_coastal_mix(tp_coastal_mix(a, b, p->fraction_x),
                          tp_coastal_mix(c, d, p->fraction_x), p->fraction_z);
}

static void sample_floor_on_map(const tp_coastal_water *coastal, tp_fx x, tp_fx z,
                                floor_place *p)
{
    const uint32_t u = node_coordinate(coastal, x - coastal->map_x, coastal->map_cols);
    const uint32_t v = node_coordinate(coastal, z - coastal->map_z, coastal->map_rows);

    TP_ASSERT((u >> 16) + 1 < coastal->map_cols && (v >> 16) + 1 < coastal->map_rows);
    p->node = (size_t)(v >> 16) * coastal->map_cols + (u >> 16);
    p->fraction_x = (int32_t)(u & 0xffff);
    p->fraction_z = (int32_t)(v & 0xffff);
    const tp_coastal_floor_node *n = tp_coastal_floor_nodes(coastal) + p->node,
                                *s = n + coastal->map_cols;
    p->depth = interpolate_nodes(n[0].depth, n[1].depth, s[0].depth, s[1].depth, p);
    p->rise_x =
        interpolate_nodes(n[0].rise_x, n[1].rise_x, s[0].rise_x, s[1].rise_x, p) * 32;
    p->rise_z =
        interpolate_nodes(n[0].rise_z, n[1].rise_z, s[0].rise_z, s[1].rise_z, p) * 32;
}

static void locate_on_slope(const tp_coastal_water *coastal, tp_fx x, tp_fx z,
                            floor_place *p)
{
    const tp_fx along = tp_way_project((tp_way){ coastal->up_x, coastal->up_z }, x, z);
    const int64_t rise = (int64_t)coastal->slope * along;

    p->depth = tp_fx_saturate(coastal->depth - ((rise + 0x8000) >> 16));
}

static floor_place locate_point(const tp_coastal_water *coastal, tp_fx x, tp_fx z)
{
    floor_place p = { .depth = 0 };

    if (coastal->map_cols)
        sample_floor_on_map(coastal, x, z, &p);
    else
        locate_on_slope(coastal, x, z, &p);
    if (p.depth > 0)
        p.at = tp_coastal_table_find(p.depth);
    return p;
}

tp_floor_at tp_coastal_floor(const tp_coastal_water *coastal, tp_fx x, tp_fx z)
{
    const floor_place p = locate_point(coastal, x, z);

    if (coastal->map_cols)
        return (tp_floor_at){ p.depth, p.rise_x, p.rise_z };
    return (tp_floor_at){ p.depth, tp_q30_mul(coastal->slope, coastal->up_x),
                          tp_q30_mul(coastal->slope, coastal->up_z) };
}

/* -- one wave at a point ------------------------------------------------------------- */

typedef struct {
    tp_ellipse orbit;
    tp_way  way;
    tp_turn phi;
} motion;

/* Interpolates the phase in excess of deep water: Q16 turns in the nodes, Q0.32 as
 * result. */
static tp_turn interpolate_turns(int64_t a, int64_t b, int32_t part)
{
    return (tp_turn)(uint64_t)(a * TP_FX_ONE + (b - a) * part);
}

/* Interpolates the phases of four nodes; rows are in Q24.  2^31, 2^8 and a fraction of
 * 2^17 make 56 bits. */
static tp_turn interpolate_node_turns(const tp_coastal_wave_node *n,
                                      const tp_coastal_wave_node *s, const floor_place *p)
{
    const int64_t north = n[0].turns * (int64_t)256
                          + (((int64_t)n[1].turns - n[0].turns) * p->fraction_x >> 8);
    const int64_t south = s[0].turns * (int64_t)256
                          + (((int64_t)s[1].turns - s[0].turns) * p->fraction_x >> 8);
    return (tp_turn)(uint64_t)(north * 256 + ((south - north) * p->fraction_z >> 8));
}

/* Tilts the orbit over a floor that rises along the direction of travel [B11].
 * set_node_direction of coastal_tables.c does the same for a straight floor. */
static void tilt_orbit(const tp_coastal_water *coastal, const floor_place *p, motion *m)
{
    const int64_t rise = ((int64_t)p->rise_x * m->way.x + (int64_t)p->rise_z * m->way.z)
                         >> 16;                                     /* Q30, below 2^34 */
    const uint32_t *fall = coastal->fall + p->at.depth;
    const uint32_t kept = (uint32_t)(fall[0] - ((uint64_t)(fall[0] - fall[1])
                                                * (uint32_t)p->at.depth_fraction >> 16));
    if (rise <= 0 || kept < 1 << 16)
        return;
    const int64_t r = rise >> 8, one = 1 << 22;                     /* Q22 */
    const uint32_t length = tp_isqrt64((uint64_t)(one * one + r * r));
    const int zeros = tp_clz(length);
    const uint32_t over = tp_recip_norm(length << zeros);           /* 2^63 / length */
    const uint64_t sin = (uint64_t)r * over >> (33 - zeros);        /* Q30 */
    m->orbit.sin = (tp_q30)(sin * kept >> 32);
    m->orbit.cos = tp_cos_of_sin(m->orbit.sin);
}

static void apply_map_to_motion(const tp_coastal_water *coastal,
                                const tp_coastal_wave *wave, const floor_place *p,
                                motion *m)
{
    const tp_coastal_wave_node *n = tp_coastal_wave_nodes(coastal, wave) + p->node;
    const tp_coastal_wave_node *s = n + coastal->map_cols;

    m->phi += interpolate_node_turns(n, s, p);
    m->way.x = wave->way_x
               + interpolate_nodes(n[0].way_x, n[1].way_x, s[0].way_x, s[1].way_x, p)
                     * (1 << 17);
    m->way.z = wave->way_z
               + interpolate_nodes(n[0].way_z, n[1].way_z, s[0].way_z, s[1].way_z, p)
                     * (1 << 17);
    tilt_orbit(coastal, p, m);
}

static void apply_slope_to_motion(const tp_coastal_table *table, const floor_place *p,
                                  motion *m)
{
    const tp_coastal_depth_entry *d = table->depth + p->at.depth;
    const int32_t *turns = table->turns + p->at.phase, part = p->at.depth_fraction;

    m->phi += interpolate_turns(turns[0], turns[1], p->at.phase_fraction);
    m->way.x = tp_coastal_mix(d[0].way_x, d[1].way_x, part);
    m->way.z = tp_coastal_mix(d[0].way_z, d[1].way_z, part);
    if ((d[0].tilt_sin | d[1].tilt_sin) == 0)
        return;
    m->orbit.sin =
        tp_coastal_mix(d[0].tilt_sin * (1 << 16), d[1].tilt_sin * (1 << 16), part);
    m->orbit.cos =
        tp_coastal_mix(d[0].tilt_cos * (1 << 16), d[1].tilt_cos * (1 << 16), part);
}

static motion evaluate_wave_phase_and_orbit(const tp_coastal_water *coastal, uint32_t i,
                                            const tp_turn *phases, tp_fx x0, tp_fx z0,
                                            const floor_place *p)
{
    const tp_coastal_wave *wave = &coastal->wave[i];
    const tp_coastal_table *table = &tp_coastal_tables(coastal)[i];
    const tp_coastal_depth_entry *d = table->depth + p->at.depth;
    motion m = {
        .phi = phases[i] + tp_swell_turns(wave->turns_x, x0)
               + tp_swell_turns(wave->turns_z, z0) + QUARTER,
        .orbit.along = tp_coastal_mix(d[0].along, d[1].along, p->at.depth_fraction),
        .orbit.up = tp_coastal_mix(d[0].up, d[1].up, p->at.depth_fraction),
        .orbit.cos = TP_Q30_ONE,
    };

    if (coastal->map_cols)
        apply_map_to_motion(coastal, wave, p, &m);
    else
        apply_slope_to_motion(table, p, &m);
    if (wave->lambda)
        m.phi = tp_wind_phase(m.phi, tp_wind_phase_shift(wave->lambda, m.orbit.up),
                              wave->iterations);
    return m;
}

/* -- breaking ------------------------------------------------------------------------ */

/* Noise at a point.  Across the direction of travel a cell is half a wave long, along the
 * direction two waves.  If there is another wave, one beat between the two waves moves the
 * noise on by eight cells.  Both coordinates wrap: 2^16 turns across are 2^17 cells, 16
 * turns along are eight cells. */
static tp_fx sample_noise(const tp_coastal_water *coastal, uint32_t i,
                          const tp_turn *phases, tp_fx x0, tp_fx z0)
{
    const tp_coastal_wave *wave = &coastal->wave[i];
    const uint64_t x = (uint64_t)(int64_t)x0, z = (uint64_t)(int64_t)z0;
    const uint64_t kx = (uint64_t)wave->turns_x, kz = (uint64_t)wave->turns_z;
    const uint64_t across = kx * z - kz * x, along = kx * x + kz * z;   /* Q48 */
    const tp_turn beat = phases[i + 1 < coastal->count ? i + 1 : 0] - phases[i];

    return tp_noise((uint32_t)(across >> 31),
                    (uint32_t)((along >> 33) + (beat >> 13)), i * 0x632be5abu);
}

/* Returns the gate of [B15], 16.16: 0 closed, 1 fully open. */
static tp_fx breaking_gate(const tp_coastal_water *coastal, uint32_t i,
                           const tp_turn *phases, tp_fx x0, tp_fx z0,
                           const floor_place *p)
{
    const tp_coastal_depth_entry *d = tp_coastal_tables(coastal)[i].depth + p->at.depth;
    tp_fx ratio = tp_coastal_mix(d[0].ratio, d[1].ratio, p->at.depth_fraction);

    if (ratio < TP_COASTAL_RATIO_LEAST)
        return 0;
    if (coastal->irregular) {
        const tp_fx noise = sample_noise(coastal, i, phases, x0, z0);
        ratio += tp_fx_mul(ratio, tp_fx_mul(coastal->irregular, noise) / 2);
    }
    return tp_breaking_gate(ratio);
}

/* Returns the foam of a gate, 0..255: none in the trough half, full on the crest,
 * quadratic in between. */
static uint32_t breaking_foam(tp_fx gate, int32_t phase)
{
    const uint32_t far = phase < 0 ? 0u - (uint32_t)phase : (uint32_t)phase;
    const uint32_t near = far > QUARTER ? (far - QUARTER) >> 15 : 0;    /* 0..2^15 */
    return ((uint32_t)gate * (near * near >> 15) >> 15) * 255 >> 16;
}

/* Returns the offset of one wave that may break, and raises *foam to the foam of the wave.
 * Without `with_overhang` the offset leaves out overhanging crests. */
static tp_offset breaking_wave_offset(const tp_coastal_water *coastal, uint32_t i,
                                      const tp_turn *phases, const floor_place *p,
                                      const motion *m, tp_fx x0, tp_fx z0,
                                      bool with_overhang, uint32_t *foam)
{
    const tp_coastal_wave *wave = &coastal->wave[i];
    const tp_coastal_depth_entry *d = tp_coastal_tables(coastal)[i].depth + p->at.depth;
    const tp_fx gate = breaking_gate(coastal, i, phases, x0, z0, p);
    const tp_fx steep = tp_coastal_mix(d[0].steep, d[1].steep, p->at.depth_fraction) * 4;
    const int32_t phase = (int32_t)(m->phi - tp_orbit_lowest_phase(&m->orbit));
    const uint32_t here = breaking_foam(gate > steep ? gate : steep, phase) * wave->foam
                          >> 8;

    *foam = here > *foam ? here : *foam;
    if (!with_overhang || gate == 0 || wave->stretch == 0)
        return tp_orbit_offset(&m->orbit, m->phi);
    const tp_fx lip = tp_coastal_mix(d[0].lip, d[1].lip, p->at.depth_fraction);
    const tp_breaker breaker = {
        .orbit = m->orbit, .stretch = tp_fx_mul(lip, wave->stretch),
        .lip = tp_fx_mul(lip, wave->plunge), .kept_stretch = gate, .kept_lip = gate,
    };
    return tp_breaking_shape(&breaker, m->phi).offset;
}

/* -- points -------------------------------------------------------------------------- */

/* Returns 2^14 times the quotient; a short division where it fits. */
static int64_t spacing_quotient(tp_fx spacing, int32_t shorter)
{
    TP_ASSERT(spacing >= 0 && shorter > 0);
    return spacing < 1 << 17 ? spacing * (1 << 14) / shorter
                             : (int64_t)spacing * (1 << 14) / shorter;
}

/* Returns the share of a wave at a depth that points of a spacing hold. */
static tp_fx spacing_weight(const tp_coastal_water *coastal, uint32_t i,
                            const tp_coastal_spacing *spacing, const floor_place *p)
{
    const tp_coastal_depth_entry *d = tp_coastal_tables(coastal)[i].depth + p->at.depth;
    const int32_t part = p->at.depth_fraction;
    const int32_t shorter = tp_coastal_mix(d[0].shorter, d[1].shorter, part);

    if (spacing->along[i] <= TP_FX(0.02) && spacing->across[i] <= TP_FX(0.02))
        return TP_FX_ONE;
    if (shorter <= 0)
        return 0;
    const int64_t along = spacing_quotient(spacing->along[i], shorter);
    const int64_t across = spacing_quotient(spacing->across[i], shorter);
    return tp_fx_mul(tp_swell_spacing_weight(along), tp_swell_spacing_weight(across));
}

static tp_coastal_point sample_point(const tp_coastal_water *coastal,
                                     const tp_turn *phases,
                                     const tp_coastal_spacing *spacing, tp_fx x0, tp_fx z0,
                                     bool with_overhang)
{
    const floor_place p = locate_point(coastal, x0, z0);
    const uint32_t count = p.depth > 0 ? coastal->count : 0; /* dry land does not move */
    tp_coastal_point point = { .position = { 0, 0, 0 }, .depth = p.depth };
    uint32_t foam = 0;

    for (uint32_t i = 0; i < count; i++) {
        const tp_fx weight = spacing ? spacing_weight(coastal, i, spacing, &p) : TP_FX_ONE;
        if (weight == 0)
            continue;
        const motion m = evaluate_wave_phase_and_orbit(coastal, i, phases, x0, z0, &p);
        tp_offset o = p.at.depth >= coastal->wave[i].calm
                                ? tp_orbit_offset(&m.orbit, m.phi)
                                : breaking_wave_offset(coastal, i, phases, &p, &m, x0, z0,
                                                       with_overhang, &foam);
        if (weight != TP_FX_ONE)
            o = (tp_offset){ tp_fx_mul(o.along, weight), tp_fx_mul(o.up, weight) };
        point.position.x += tp_q30_mul(o.along, m.way.x);
        point.position.y += o.up;
        point.position.z += tp_q30_mul(o.along, m.way.z);
    }
    point.position.x = tp_fx_add_sat(x0, point.position.x);
    point.position.z = tp_fx_add_sat(z0, point.position.z);
    point.breaking = (uint8_t)foam;
    return point;
}

tp_coastal_point tp_coastal_displace_point(const tp_coastal_water *coastal,
                                           const tp_turn phases[TP_WAVES], tp_fx x0,
                                           tp_fx z0)
{
    return sample_point(coastal, phases, NULL, x0, z0, true);
}

tp_coastal_point tp_coastal_displace_no_overhang(const tp_coastal_water *coastal,
                                                 const tp_turn phases[TP_WAVES], tp_fx x0,
                                                 tp_fx z0)
{
    return sample_point(coastal, phases, NULL, x0, z0, false);
}

tp_coastal_point tp_coastal_displace_filtered(const tp_coastal_water *coastal,
                                              const tp_turn phases[TP_WAVES],
                                              const tp_coastal_spacing *spacing, tp_fx x0,
                                              tp_fx z0)
{
    return sample_point(coastal, phases, spacing, x0, z0, true);
}

tp_fx tp_coastal_max_displacement(const tp_coastal_water *coastal)
{
    return coastal->max_displacement;
}

tp_fx tp_coastal_max_height(const tp_coastal_water *coastal)
{
    return coastal->height;
}

tp_fx tp_coastal_breaking_foam_depth(const tp_coastal_water *coastal)
{
    return (tp_fx)tp_clamp_abs((int64_t)tp_coastal_max_height(coastal) * 8,
                               2048 * TP_FX_ONE);
}
