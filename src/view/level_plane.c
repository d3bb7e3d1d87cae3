/* SPDX-License-Identifier: MIT */
/* Level water in the picture; see the header for the idea. */
#include "view/wave_models.h"
#include "waves/deep_water.h"

static int64_t shifted(int64_t x, int right)
{
    return right >= 0 ? x >> right : x * ((int64_t)1 << -right);
}

/* -- sums ---------------------------------------------------------------------------- */

/* Returns d . n as a sum over X and Y. focal is below 2^14 px, so a sum has 46 bits. */
static tp_level_linear make_ray_dot_linear(const tp_projection *projection, tp_dir3 n)
{
    tp_q30 right = tp_dir3_dot(projection->turn.x, n),
           up = tp_dir3_dot(projection->turn.y, n);
    tp_q30 ahead = tp_dir3_dot(projection->ahead, n);

    return (tp_level_linear){
        ((int64_t)projection->focal * ahead >> 16)
            + (((int64_t)(8 - projection->u0) * right
                + (int64_t)(projection->v0 - 8) * up)
               >> 4),
        right,
        -(int64_t)up,
    };
}

/* Returns near / depth as a sum: near / (h focal) times -d.y.  `over` has the quotient's
 * 31 upper bits: with h and focal in 16.16 and near / over in Q.30, zi in Q1.43 is down
 * over / 2^right. */
static tp_level_linear make_zi_linear(const tp_projection *projection,
                                      const tp_level_linear *down)
{
    uint64_t under = (uint64_t)projection->eye.y * (uint32_t)projection->focal;
    int      up = under >> 32 ? tp_clz((uint32_t)(under >> 32))
                              : 32 + tp_clz((uint32_t)under);
    uint64_t over = (uint64_t)projection->zi_near
                  * tp_recip_norm((uint32_t)(under << up >> 32));
    int      right = 66 - up;

    for (; over >> 31; right--)
        over >>= 1;
    return (tp_level_linear){
        shifted((down->at >> 14) * (int64_t)over, right - 14),
        shifted(down->x * (int64_t)over, right), shifted(down->y * (int64_t)over, right),
    };
}

/* Returns the inside of the plane through the eye and a side of the water; `sign`:
 * direction of the side along x or z. */
static tp_level_linear make_side_linear(const tp_projection *projection, int sign,
                                        bool along_z)
{
    tp_fx h = projection->eye.y * -sign, w = -TP_LEVEL_FAR;
    return make_ray_dot_linear(projection,
                               along_z ? tp_normalise(0, w, h) : tp_normalise(h, w, 0));
}

void tp_level_begin(tp_level *level, const tp_projection *projection)
{
    const tp_vec3 *eye = &projection->eye;

    TP_ASSERT(eye->y >= TP_LEVEL_HEIGHT);
    level->down = make_ray_dot_linear(projection, (tp_dir3){ 0, -TP_Q30_ONE, 0 });
    level->east = make_ray_dot_linear(projection, (tp_dir3){ TP_Q30_ONE, 0, 0 });
    level->south = make_ray_dot_linear(projection, (tp_dir3){ 0, 0, TP_Q30_ONE });
    level->zi = make_zi_linear(projection, &level->down);
    for (int k = 0; k < 4; k++)
        level->side[k] = make_side_linear(projection, k & 1 ? 1 : -1, k >= 2);
    level->side[4] = (tp_level_linear){
        ((int64_t)255 << (23 + TP_LEVEL_ZI)) - level->zi.at, -level->zi.x, -level->zi.y,
    };
    level->height = eye->y;
    level->x = eye->x;
    level->z = eye->z;
    level->rolled = level->down.x != 0;
}

/* at has 46 bits; 16 more bits give the row in Q.16. */
tp_level_line tp_level_zero_line(const tp_level_linear *sum)
{
    TP_ASSERT(sum->y > 0);
    return (tp_level_line){ -tp_quotient(sum->at * 65536, sum->y) * 16384,
                            -tp_quotient(sum->x * ((int64_t)1 << 30), sum->y) };
}

/* -- positions ----------------------------------------------------------------------- */

/* 1 / down is r 2^(up - 95); Q.30 pixels are treated as integers; h r has 59 bits. */
tp_level_scale tp_level_metres_per_pixel(const tp_level *level, int64_t ray_down)
{
    TP_ASSERT(ray_down > 0);
    uint32_t high = (uint32_t)((uint64_t)ray_down >> 32);
    int      up = high ? tp_clz(high) : 32 + tp_clz((uint32_t)ray_down);
    uint64_t factor = (uint64_t)level->height
                    * tp_recip_norm((uint32_t)((uint64_t)ray_down << up >> 32));
    int      shift = 81 - up;
    int      least = 33 - tp_clz((uint32_t)(factor >> 32));

    least = factor >> 32 ? least : 1;
    factor >>= least;
    shift -= least;
    return (tp_level_scale){ (int32_t)factor, tp_clamp(shift, 0, 63) };
}

/* -- outlines ------------------------------------------------------------------------ */

/* Returns the first pixel between a and b with b's sign of the sum; the sign changes
 * once. */
static int32_t find_sign_change(const tp_level_linear *sum, int32_t y, int32_t a, int32_t b)
{
    bool negative = tp_level_evaluate(sum, b, y) < 0;

    while (b - a > 1) {
        int32_t middle = (a + b) / 2;
        if ((tp_level_evaluate(sum, middle, y) < 0) == negative)
            b = middle;
        else
            a = middle;
    }
    return b;
}

void tp_level_clip_span(const tp_level *level, unsigned mask, int32_t y, int32_t *x0,
                        int32_t *x1)
{
    for (int k = 0; k < TP_LEVEL_SIDES && *x0 < *x1; k++) {
        const tp_level_linear *side = &level->side[k];
        if (!(mask >> k & 1))
            continue;
        bool first = tp_level_evaluate(side, *x0, y) < 0;
        bool last = tp_level_evaluate(side, *x1 - 1, y) < 0;
        if (first && last)
            *x1 = *x0;
        else if (first)
            *x0 = find_sign_change(side, y, *x0, *x1 - 1);
        else if (last)
            *x1 = find_sign_change(side, y, *x0, *x1 - 1);
    }
}

unsigned tp_level_clip_mask(const tp_level *level, int32_t x0, int32_t y0, int32_t x1,
                            int32_t y1)
{
    unsigned mask = 0;

    for (int k = 0; k < TP_LEVEL_SIDES; k++) {
        const tp_level_linear *side = &level->side[k];
        int32_t x = side->x < 0 ? x1 - 1 : x0, y = side->y < 0 ? y1 - 1 : y0;
        mask |= (unsigned)(tp_level_evaluate(side, x, y) < 0) << k;
    }
    return mask;
}

/* -- waves --------------------------------------------------------------------------- */

/* Returns the weight of a wave for a step between sample points, in turns of the wave,
 * Q.32: 1 up to a quarter turn, 0 from half a turn on, smooth between. */
static tp_fx swell_sampling_weight(const tp_swell *w, const tp_fx step[2])
{
    int64_t turns = (w->turns_x >> 2) * (step[0] >> 4) + (w->turns_z >> 2) * (step[1] >> 4);
    int64_t most = (int64_t)1 << 31;

    turns = (turns < 0 ? -turns : turns) >> 10;
    return turns >= most ? 0 : turns <= most / 2 ? TP_FX_ONE
                         : tp_smoothstep((tp_fx)((most - turns) >> 14));
}

static void add_weighted_swell_terms(tp_swell_sum *sum, const tp_swell *w, tp_turn phase,
                                     tp_fx weight)
{
    const tp_q30 sine = tp_sin(phase), cosine = tp_cos(phase);
    int32_t s = sine >> 6, c = cosine >> 6, f = s, df = c;

    if (w->power > 1)
        tp_swell_sharpen(w, sine, cosine, &f, &df);
    if (weight != TP_FX_ONE) {
        s = tp_fx_mul(s, weight);
        c = tp_fx_mul(c, weight);
        f = tp_fx_mul(f, weight);
        df = tp_fx_mul(df, weight);
    }
    sum->x += (int64_t)w->orbit_x * c;
    sum->z += (int64_t)w->orbit_z * c;
    sum->y += (int64_t)w->amplitude * f;
    sum->hx += (int64_t)w->slope_x * df;
    sum->hz += (int64_t)w->slope_z * df;
    sum->bxx += (int64_t)w->bend_xx * s;
    sum->bxz += (int64_t)w->bend_xz * s;
    sum->bzz += (int64_t)w->bend_zz * s;
}

tp_surface_point tp_level_sample_surface(const tp_surface *surface, const tp_fx place[2],
                                         tp_fx step[2][2])
{
    tp_swell_sum sum = { 0 };
    bool some = false;

    for (uint32_t k = 0; k < surface->deep->count; k++) {
        const tp_swell *w = &surface->deep->swell[k];
        tp_fx share = swell_sampling_weight(w, step[0]),
              other = swell_sampling_weight(w, step[1]);
        share = share < other ? share : other;
        if (share == 0)
            continue;
        add_weighted_swell_terms(&sum, w,
                                 surface->phases[k] + tp_swell_turns(w->turns_x, place[0])
                                     + tp_swell_turns(w->turns_z, place[1]),
                                 share);
        some = true;
    }
    if (!some)
        return (tp_surface_point){ .position = { place[0], 0, place[1] } };
    return tp_swell_sum_point(&sum, place[0], place[1], TP_FX_ONE);
}
