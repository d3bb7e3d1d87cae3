/* SPDX-License-Identifier: MIT */
/* Tables of each wave over depth: [B2]-[B9] and [B11]-[B15].
 *
 * Heights grow by Ks Kr and are capped at 0.39 h and at Miche's limit.  Miche's limit is
 * raised for a wave above the limit in deep water already: the scene asks for such a wave.
 * The node at 2048 m is deep water to the bit, and so are places without a floor.
 *
 * Loops [A11] [B13]: all waves at a point have the same depth.  The steepness sum is
 * therefore taken at each node, sum k QrSx (1 + lambda r) <= 0.951 (0.95 and its
 * roundings).  If the sum is larger, one factor narrows all orbits of the node. */
#include "waves/coastal_tables.h"

#define STEEPEST   TP_FX(0.951)
#define KEPT_RATE  TP_FX(0.1)       /* Ks and Kd of [B19], 1/m */
#define RATIO_MAX  TP_FX(8)
#define TWO_PI     TP_FX(6.283185307)
#define DEEP       (TP_COASTAL_DEPTHS - 1)

tp_coastal_floor_node *tp_coastal_floor_nodes(const tp_coastal_water *coastal)
{
    return tp_coastal_at_byte(coastal, coastal->floor_nodes);
}

tp_coastal_wave_node *tp_coastal_wave_nodes(const tp_coastal_water *coastal,
                                            const tp_coastal_wave *wave)
{
    return tp_coastal_at_byte(coastal, wave->wave_nodes);
}

/* Returns sqrt(k^2 - kz^2) for |kz| <= k; else 0. */
static int64_t cross_shore_wave_number(int64_t k_q32, int64_t kz_q32)
{
    uint64_t k = (uint64_t)k_q32, kz = (uint64_t)(kz_q32 < 0 ? -kz_q32 : kz_q32);
    int up = 0, down = 0;

    if (kz >= k)
        return 0;
    for (; k >> 31 != 0; k >>= 1, kz >>= 1)
        down++;
    for (; k >> 30 == 0; k <<= 1, kz <<= 1)
        up++;
    const int64_t root = tp_isqrt64(k * k - kz * kz);
    return (root + (((int64_t)1 << up) >> 1)) >> up << down;
}

/* Returns the wave vector over a floor that rises towards `up`.  The sign of the component
 * towards `up` is the sign in deep water: a wave that leaves the shore keeps leaving. */
tp_coastal_wave_number tp_coastal_wave_vector(const tp_coastal_swell *swell, tp_way up,
                                              int64_t k_q32)
{
    const tp_way along = { -up.z, up.x };

    if (up.x == 0 && up.z == 0)
        return (tp_coastal_wave_number){ tp_coastal_scale_q30(k_q32, swell->way.x),
                                         tp_coastal_scale_q30(k_q32, swell->way.z) };
    const int64_t kz =
        tp_coastal_scale_q30(swell->k_inf_q32, tp_way_dot(swell->way, along));
    const int64_t across = cross_shore_wave_number(k_q32, kz);
    const int64_t kx = tp_way_dot(swell->way, up) < 0 ? -across : across;
    return (tp_coastal_wave_number){
        tp_coastal_scale_q30(kx, up.x) + tp_coastal_scale_q30(kz, along.x),
        tp_coastal_scale_q30(kx, up.z) + tp_coastal_scale_q30(kz, along.z),
    };
}

/* Returns part / whole as Q30; |part| <= whole but for roundings.  Both are first shifted
 * down to 31 bits. */
static tp_q30 q30_share(int64_t part, int64_t whole)
{
    TP_ASSERT(part < 2 * whole && part > -2 * whole);
    for (; whole >> 31 != 0; whole >>= 1)
        part /= 2;
    return (tp_q30)(part * TP_Q30_ONE / whole);
}

/* -- amplitude ----------------------------------------------------------------------- */

/* Returns half of Miche's height, but at least the same share of Miche's height as a
 * wave of this amplitude has in deep water.  Both heights saturate at 2^31: the
 * product has 62 bits. */
static tp_fx miche_amplitude(const tp_coastal_swell *w, int64_t k_q32, tp_fx h)
{
    const int64_t here = tp_miche_height(k_q32, h);
    const int64_t deep = tp_miche_height(w->k_inf_q32, 1 << TP_COASTAL_LAST);
    const int64_t share = deep > 0 ? here * w->amplitude / deep : 0;
    const int64_t most = here / 2 > share ? here / 2 : share;
    return tp_fx_saturate(most);
}

/* Returns the ratio of wave height to depth, H / h, before the cap of [B15].  ks, kr: the
 * factors of shoaling and refraction. */
static tp_fx height_depth_ratio(const tp_coastal_swell *w, tp_fx ks, tp_fx kr, tp_fx h)
{
    const int64_t shoaled = (int64_t)tp_fx_mul(w->amplitude, ks) * kr >> 15;
    const int64_t ratio = shoaled * TP_FX_ONE / h;
    return ratio < RATIO_MAX ? (tp_fx)ratio : RATIO_MAX;
}

static int16_t round_to_q14(tp_q30 x)
{
    return (int16_t)((x + 0x8000) >> 16);
}

/* Returns the strength of breaking by steepness [B14], Q1.14: a smooth step from 0 at
 * k A = pi / 7, the breaking steepness, to 1 at k A = 0.5, where slopes are 30 degrees. */
static int16_t steep_breaking_strength(int64_t k_q32, tp_fx amplitude)
{
    const int64_t kr = k_q32 * amplitude >> 32;
    const tp_fx over = tp_clamp((tp_fx)kr - TP_FX(0.4488), 0, TP_FX(0.0512));
    return (int16_t)(tp_smoothstep(over * 1250 / 64) >> 2);     /* 1 / 0.0512 = 19.5 */
}

/* Returns QA A/A_inf Sx, clamped to 0.95 / k.  QA <= 303 m and A < 2^26 have 51 bits.
 * Their quotient is below 2^25 (512 m, above any 0.95 / k) before the 37 bits of Sx >=
 * 1. */
static tp_fx horizontal_semi_axis(const tp_coastal_swell *w, tp_fx amplitude, int64_t k_q32,
                                  int64_t sx)
{
    TP_ASSERT(k_q32 > 0 && w->amplitude > 0);
    const int64_t most = ((int64_t)TP_FX(0.95) << 32) / k_q32;
    const int64_t round =
        ((int64_t)w->reach * amplitude + w->amplitude / 2) / w->amplitude;
    if (round >= most)
        return (tp_fx)most;
    const int64_t along = (round * sx + (1 << 23)) >> 24;
    return (tp_fx)(along < most ? along : most);
}

/* -- nodes --------------------------------------------------------------------------- */

/* Sets the direction of travel over a straight floor, and the tilt of the orbit. */
static void set_node_direction_and_tilt(const tp_coastal_water *coastal,
                                        tp_coastal_depth_entry *node, uint32_t fall_q32,
                                        const tp_coastal_swell *w, int64_t k_q32)
{
    const tp_way up = { coastal->up_x, coastal->up_z };
    const tp_coastal_wave_number k = tp_coastal_wave_vector(w, up, k_q32);
    const tp_way way = { q30_share(k.x_q32, k_q32), q30_share(k.z_q32, k_q32) };
    const int64_t rise = (int64_t)coastal->slope * tp_way_dot(way, up) >> 16; /* Q30 */
    const uint64_t length = tp_isqrt64(((uint64_t)1 << 60) + (uint64_t)(rise * rise));
    tp_q30 sin = 0;

    if (rise > 0)
        sin = (tp_q30)((rise * TP_Q30_ONE / (int64_t)length * (fall_q32 >> 2)) >> 30);
    node->way_x = way.x;
    node->way_z = way.z;
    node->tilt_sin = round_to_q14(sin);
    node->tilt_cos = round_to_q14(tp_cos_of_sin(sin));
}

/* Returns the last node: deep water. */
static tp_coastal_depth_entry deep_node(const tp_coastal_swell *w)
{
    return (tp_coastal_depth_entry){
        .along = w->reach, .up = w->amplitude, .way_x = w->way.x, .way_z = w->way.z,
        .tilt_cos = 1 << 14, .steep = steep_breaking_strength(w->k_inf_q32, w->amplitude),
        .shorter = 1 << 14,
    };
}

static tp_coastal_depth_entry make_node(const tp_coastal_water *coastal,
                                        const tp_coastal_swell *w, tp_fx h, int64_t k_q32,
                                        const tp_coastal_config *config)
{
    const tp_orbit_scale s = tp_orbit_scale_make(h, config->kx, config->ky);
    const tp_fx ks = tp_depth_shoaling_factor(w->k_inf_q32, k_q32, h);
    const tp_fx kr = coastal->map_cols ? TP_FX_ONE
                   : tp_depth_refraction_factor(w->k_inf_q32, k_q32, w->kz_q32);
    const tp_fx miche = miche_amplitude(w, k_q32, h);
    const tp_fx held = tp_depth_amplitude(w->amplitude, ks, kr, h);
    const tp_fx amplitude = held < miche ? held : miche;
    const bool round = w->surging && !coastal->map_cols;

    return (tp_coastal_depth_entry){
        .along = horizontal_semi_axis(w, amplitude, k_q32, round ? 1 << 24 : s.x_q24),
        .up = (tp_fx)((amplitude * s.y_q24 + (1 << 23)) >> 24),
        .ratio = height_depth_ratio(w, ks, kr, h),
        .lip = (tp_fx)((int64_t)amplitude * tp_orbit_depth_decay(KEPT_RATE, h) >> 32),
        .way_x = w->way.x, .way_z = w->way.z, .tilt_cos = 1 << 14,
        .steep = steep_breaking_strength(k_q32, amplitude),
        .shorter = (int16_t)(k_q32 > 0 ? (w->k_inf_q32 << 14) / k_q32 : 1 << 14),
    };
}

/* Returns k along (1 + |push|), 16.16: the wave's part of the steepness
 * sum.  k along < 2^48. */
static int32_t node_steepness(const tp_coastal_depth_entry *node, int64_t k_q32,
                              tp_fx lambda)
{
    const int64_t q = k_q32 * node->along >> 32;
    return (int32_t)(q + (q * tp_wind_phase_shift(lambda, node->up) >> 30)) + 1;
}

/* Stores the steepness in `turns` until tp_coastal_limit_steepness_sum reads it; the phases
 * come later. */
void tp_coastal_make_table(tp_coastal_water *coastal, uint32_t i,
                           const tp_coastal_swell *swell, const tp_coastal_config *config)
{
    tp_coastal_wave *wave = &coastal->wave[i];
    tp_coastal_table *table = &tp_coastal_tables(coastal)[i];

    for (uint32_t n = 1; n < TP_COASTAL_DEPTHS; n++) {
        const tp_fx h = tp_coastal_node_depth(n, 3);
        const int64_t k = n < DEEP ? tp_coastal_local_wave_number(swell->k_inf_q32, h)
                                   : swell->k_inf_q32;
        tp_coastal_depth_entry *node = &table->depth[n];
        *node = n < DEEP ? make_node(coastal, swell, h, k, config) : deep_node(swell);
        if (coastal->slope > 0 && n < DEEP)
            set_node_direction_and_tilt(coastal, node, coastal->fall[n], swell, k);
        table->turns[n] = node_steepness(node, k, wave->lambda);
        const int times = tp_wind_iterations(tp_wind_phase_shift(wave->lambda, node->up));
        if (times > wave->iterations)
            wave->iterations = times;
    }
    table->depth[0] = table->depth[1];      /* 0 m: a copy of node 1, but without motion */
    table->depth[0].along = table->depth[0].up = table->depth[0].lip = 0;
    table->turns[0] = 0;
}

void tp_coastal_limit_steepness_sum(tp_coastal_water *coastal)
{
    for (uint32_t n = 1; n < TP_COASTAL_DEPTHS; n++) {
        int64_t sum = 0;
        for (uint32_t i = 0; i < coastal->count; i++)
            sum += tp_coastal_tables(coastal)[i].turns[n];
        for (uint32_t i = 0; i < coastal->count && sum > STEEPEST; i++) {
            tp_coastal_depth_entry *node = &tp_coastal_tables(coastal)[i].depth[n];
            node->along = (tp_fx)((int64_t)node->along * TP_FX(0.95) / sum);
        }
    }
}

/* -- phases -------------------------------------------------------------------------- */

/* Returns the wave number towards the shore at a depth less the number in deep water. */
static int64_t cross_shore_wave_number_excess(const tp_coastal_swell *w, tp_fx h)
{
    return cross_shore_wave_number(tp_coastal_local_wave_number(w->k_inf_q32, h),
                                   w->kz_q32)
           - cross_shore_wave_number(w->k_inf_q32, w->kz_q32);
}

/* [B8] [B9] as the difference from deep water.  With h = depth - slope x the integral
 * over x becomes an integral over h.  Simpson's rule adds up the steps between nodes, a
 * 32nd of an octave apart, from the deep end.  Rad in Q32 over 2 pi slope (both 16.16)
 * is turns in Q16: for slopes from 2^-12 on, and an integral below 4 rad at a slope of
 * 1, less than 2^27. */
void tp_coastal_make_phases_by_depth(tp_coastal_water *coastal, uint32_t i,
                                     const tp_coastal_swell *swell)
{
    const tp_way up = { coastal->up_x, coastal->up_z };
    const int sign = tp_way_dot(swell->way, up) < 0 ? -1 : 1;
    const int64_t over = (int64_t)coastal->slope * TWO_PI;
    int32_t *turns = tp_coastal_tables(coastal)[i].turns;
    int64_t sum = 0, high = 0;

    turns[TP_COASTAL_PHASES - 1] = 0;
    for (uint32_t n = TP_COASTAL_PHASES - 1; n-- > 0;) {
        const tp_fx h = tp_coastal_node_depth(n, 5), top = tp_coastal_node_depth(n + 1, 5);
        if (coastal->slope <= 0) {
            turns[n] = 0;
            continue;
        }
        const int64_t low = cross_shore_wave_number_excess(swell, h);
        const int64_t six =
            low + 4 * cross_shore_wave_number_excess(swell, h + (top - h) / 2) + high;
        sum += (six * (top - h) / 6 + 0x8000) >> 16;
        high = low;
        turns[n] = (int32_t)(sign * (sum * TP_FX_ONE / over));
    }
}

/* -- bounds -------------------------------------------------------------------------- */

/* Returns a bound of the sine of the tilt over a map, Q14, from the steepest slope: r
 * / sqrt(1 + r^2). */
int32_t tp_coastal_floor_tilt_sine_bound(const tp_coastal_water *coastal)
{
    const tp_coastal_floor_node *beds = tp_coastal_floor_nodes(coastal);
    int64_t most = 0;

    for (size_t i = 0; i < (size_t)coastal->map_cols * coastal->map_rows; i++) {
        const int64_t x = beds[i].rise_x, z = beds[i].rise_z, square = x * x + z * z;
        most = square > most ? square : most;
    }
    const int64_t length = tp_isqrt64((uint64_t)(most + (1 << 22)));    /* Q11 */
    return (int32_t)((tp_isqrt64((uint64_t)most) + 1) * 16384 / length);
}

/* Adds the bounds of a wave.  Stretch and lip count only at depths where the gate can open.
 * A margin covers direction vectors longer than 1 by rounding. */
static void add_displacement_bounds(tp_coastal_water *coastal, uint32_t i,
                                    int32_t tilt_sine_bound)
{
    const tp_coastal_wave *wave = &coastal->wave[i];
    const tp_fx open = tp_fx_div(TP_FX(0.6), TP_FX_ONE + coastal->irregular / 2) - 1;
    tp_fx reach = 0, height = 0;

    for (uint32_t n = 1; n < TP_COASTAL_DEPTHS; n++) {
        const tp_coastal_depth_entry *node = &tp_coastal_tables(coastal)[i].depth[n];
        const bool near = node->ratio > open || node[-1].ratio > open
                          || (n + 1 < TP_COASTAL_DEPTHS && node[1].ratio > open);
        const tp_fx lip = near ? tp_fx_mul(node->lip, wave->stretch + wave->plunge) : 0;
        const int32_t sin = coastal->map_cols ? tilt_sine_bound : node->tilt_sin;
        const tp_fx along = node->along + lip;
        const tp_fx up = node->up + (tp_fx)((int64_t)node->along * sin >> 14) + lip;
        reach = along > reach ? along : reach;
        height = up > height ? up : height;
    }
    coastal->max_displacement += reach + reach / 1024 + 8;
    coastal->height += height + 8;
}

/* Finds the first node below the deepest node where a wave may break, by depth
 * or by steepness. */
static void set_first_nonbreaking_node(tp_coastal_water *coastal, uint32_t i)
{
    const tp_coastal_depth_entry *depth = tp_coastal_tables(coastal)[i].depth;
    uint32_t n = TP_COASTAL_DEPTHS;

    while (n > 0 && depth[n - 1].ratio < TP_COASTAL_RATIO_LEAST && depth[n - 1].steep == 0)
        n--;
    coastal->wave[i].calm = n;
}

void tp_coastal_add_bounds(tp_coastal_water *coastal, uint32_t i, int32_t tilt_sine_bound)
{
    set_first_nonbreaking_node(coastal, i);
    add_displacement_bounds(coastal, i, tilt_sine_bound);
}
