/* SPDX-License-Identifier: MIT */
/* Distances and widths of a fan's rows; see the header for the law. */
#include "view/fan.h"
#include "waves/deep_water.h"
#include "waves/softfloat.h"

#define LEAST_HEIGHT TP_FX(0.5)
#define FARTHEST  (16000 * TP_FX_ONE)
#define SET_BACK  (2 * TP_FX_ONE)

/* Growth of the spacing beyond r*, in powers of r more than before; powers of 2.  Beyond
 * rings and pools without swells nothing is left to hold, and few rows are enough. */
#define SWELLS_TAIL 2
#define DETAIL_TAIL 8

/* -- size ---------------------------------------------------------------------------- */

/* Rows per column lie between 1/2 and 4. */
static uint32_t least_cols(uint32_t vertices)
{
    return tp_isqrt64(vertices / 4);
}

uint32_t tp_fan_most_cols(uint32_t vertices)
{
    return tp_isqrt64(2 * (uint64_t)vertices);
}

uint32_t tp_fan_most_rows(uint32_t vertices)
{
    return vertices / least_cols(vertices);
}

/* -- hyperbolic functions ------------------------------------------------------------ */

/* Returns e^u and e^-u of u in 8.24, up to 16, as Q.20, in *inverse and as result. */
static int64_t exp_pair(int32_t u, int64_t *inverse)
{
    const uint32_t e = tp_exp_neg((uint32_t)u);
    const int zeros = tp_clz(e);

    *inverse = e >> 12;
    return (int64_t)tp_recip_norm(e << zeros) << zeros >> 11;
}

static int64_t sinh_q20(int32_t u)
{
    int64_t low, high = exp_pair(u < 0 ? -u : u, &low);
    return u < 0 ? (low - high) / 2 : (high - low) / 2;
}

static int64_t cosh_q20(int32_t u)
{
    int64_t low, high = exp_pair(u < 0 ? -u : u, &low);
    return (high + low) / 2;
}

/* Returns u with height sinh(u) = d, 8.24. */
static int32_t asinh_q24(tp_fx d, tp_fx height)
{
    const int64_t sinh = ((int64_t)tp_abs(d) << 20) / height;
    int32_t u = 0;

    for (int32_t bit = 1 << 27; bit > 0; bit >>= 1)
        if (u + bit < 16 << 24 && sinh_q20(u + bit) <= sinh)
            u += bit;
    return d < 0 ? -u : u;
}

static tp_fx metres(tp_fx height, int64_t share_q20)
{
    return (tp_fx)(height * share_q20 >> 20);
}

/* -- the law ------------------------------------------------------------------------- */

/* Returns u of a distance, at most that of the last row. */
static int32_t u_of_distance(const tp_fan_law *law, int64_t distance, int32_t end)
{
    const int32_t u =
        distance < law->last ? asinh_q24((tp_fx)distance, law->height) : end;
    return u < end ? u : end;
}

/* Returns the length in u of all rows for the law that leaves the waves at u = `at`, and
 * sets the distance r*. */
static int64_t rows_length(const tp_fan_law *law, int32_t at, tp_fx *waves_end)
{
    const int64_t r = metres(law->height, cosh_q20(at));
    const int64_t end = (int64_t)tp_isqrt64((uint64_t)((int64_t)law->last * law->last
                                            + (int64_t)law->height * law->height));
    const int64_t share = end > r ? (r << 16) / end : TP_FX_ONE;

    int64_t left = share * share >> 16;
    *waves_end = (tp_fx)r;
    for (int k = 2; k < law->tail; k *= 2)
        left = left * left >> 16;
    return (int64_t)at - law->start + ((TP_FX_ONE - left) << 8) / law->tail;
}

/* Returns u of the distance where the spacing is half a wave, for a law whose rows are
 * dense up to there: at least `low`, `high` if the spacing is smaller everywhere. */
static int32_t wave_end(const tp_fan_law *law, int32_t low, int32_t high, tp_fx half_wave)
{
    tp_fx waves_end;

    while (high - low > 16) {
        const int32_t at = low + (high - low) / 2;
        const int64_t length = rows_length(law, at, &waves_end);
        if (length * waves_end < (int64_t)(law->rows - 1) * half_wave * (1 << 24))
            low = at;
        else
            high = at;
    }
    return low;
}

/* Sets r*: the larger of the swells' and of the details'.  The swells' spacing at r* is
 * half the longest swell, and the details' is half a detail unless they end before.  If
 * the end comes to the last row, all rows are dense. */
static void set_waves_end(tp_fan_law *law, int32_t end, const tp_fan_view *view)
{
    const int32_t low = law->start > 0 ? law->start : 0;
    int32_t at = low;

    law->waves_end = TP_FX_MAX;
    law->dense = law->length = end - law->start;
    if (end <= low)
        return;
    if (view->half_longest > 0)
        at = wave_end(law, low, end, view->half_longest);
    if (view->detail > 0) {
        const int32_t last = u_of_distance(law, view->detail_end, end);
        const int32_t held = wave_end(law, low, end, view->detail / 2);
        const int32_t kept = held < last ? held : last;
        at = kept > at ? kept : at;
    }
    if (at >= end - 16 || (at == low && view->detail == 0))
        return;
    law->length = (int32_t)rows_length(law, at, &law->waves_end);
    law->dense = at - law->start;
}

/* Sets rows and columns: cells about as long as wide for a spacing of 1/20 of the
 * distance. */
static void set_size(tp_fan_law *law, int32_t end, const tp_fan_view *view,
                     uint32_t vertices)
{
    const int64_t far = (int64_t)view->half_longest * 20;
    int32_t at = u_of_distance(law, far, end);

    if (view->detail > 0) {
        const int32_t details = u_of_distance(law, view->detail_end, end);
        at = details > at ? details : at;
    }
    at = (at > law->start ? at - law->start : 0) + (at < end ? (1 << 24) / law->tail : 0);
    at = at > 1 << 21 ? at : 1 << 21;
    const uint64_t cols_per_row = ((uint64_t)law->wide << 17) / (uint32_t)at;
    uint32_t cols = tp_isqrt64(vertices * cols_per_row) >> 4;           /* Q4 */
    const uint32_t least = least_cols(vertices), most = tp_fan_most_cols(vertices);

    cols = cols < least ? least : cols > most ? most : cols;
    law->cols = cols;
    law->rows = vertices / cols;
}

/* Solves the law for waves up to `high`.  Near the eye, rows are no denser than the shortest
 * wave needs. */
static void solve(tp_fan_law *law, const tp_fan_view *view, tp_fx high, uint32_t vertices)
{
    const tp_projection *p = view->projection;
    const tp_fx half_wave = view->half_longest, up = tp_abs(p->eye.y);
    const tp_fx least = half_wave < view->shortest ? half_wave : view->shortest;

    *law = (tp_fan_law){ .right = tp_fan_rows_direction(&p->turn, false),
                         .tail = view->half_longest > 0 || view->detail == 0 ? SWELLS_TAIL
                                                                            : DETAIL_TAIL,
                         .height = up > LEAST_HEIGHT ? up : LEAST_HEIGHT };
    law->wide = tp_fan_half_width_per_depth(view, law->right);
    if (law->height < least)
        law->height = least;
    const int64_t corner = tp_isqrt64(((uint64_t)1 << 32)      /* per metre of distance */
                                      + (uint64_t)((int64_t)law->wide * law->wide));
    const int64_t most = ((int64_t)TP_FAN_WIDEST << 16) / corner;
    law->farthest = most < FARTHEST ? (tp_fx)most : FARTHEST;
    const tp_fan_range r = tp_fan_visible_range(view, law->right, high, law->farthest);

    law->last = (tp_fx)r.last;
    law->start = asinh_q24((tp_fx)r.first, law->height);
    const int32_t end = asinh_q24(law->last, law->height);
    set_size(law, end, view, vertices);
    set_waves_end(law, end, view);
}

/* -- rows ---------------------------------------------------------------------------- */

/* Sets the distance of row n and its distance from the next row. */
static tp_fx row_distance(const tp_fan_law *law, uint32_t n, tp_fx *along)
{
    const int64_t way = (int64_t)law->length * n / (law->rows - 1);
    const int64_t step = law->length / (int32_t)(law->rows - 1);

    if (way <= law->dense || law->waves_end == TP_FX_MAX) {
        const int32_t u = law->start + (int32_t)way;
        *along = (tp_fx)(metres(law->height, cosh_q20(u)) * step >> 24);
        return metres(law->height, sinh_q20(u));
    }
    const int64_t left = ((int64_t)1 << 24) - law->tail * (way - law->dense); /* Q24 */
    int64_t root = left > 1 ? left : 1;                                       /* Q24 */
    for (int k = 1; k < law->tail; k *= 2)
        root = tp_isqrt64((uint64_t)root << 24);
    const int64_t r = tp_clamp_abs(((int64_t)law->waves_end << 24) / root, TP_FAN_WIDEST);
    const int64_t over = (r << 16) / law->waves_end;         /* 16.16, below 2^31 */
    if (n + 1 == law->rows) {           /* the end, which `left` has no digits for */
        *along = TP_FX_MAX;
        return law->last;
    }
    *along = (tp_fx)(r * step >> 24);
    for (int k = 0; k < law->tail; k++)
        *along = tp_fx_saturate(*along * over >> 16);
    return (tp_fx)tp_isqrt64((uint64_t)((r - law->height) * (r + law->height)));
}

/* Returns a bound of the gain of all waves along one direction: that of the shortest. */
static tp_fx gain_bound(const tp_fan_view *view, int64_t spacing)
{
    const tp_fx most = TP_FX(1.3229);           /* sqrt(7 / 4) */
    const int64_t share = view->shortest > 0 ? spacing * (2 * TP_FX_ONE) / view->shortest : 0;
    const tp_fx gain = share < TP_FX_ONE / 2 ? tp_swell_spacing_gain(share) : most;

    return gain < most ? gain : most;
}

/* Returns half the width of the view on a row; waves may raise the row.  `gain` bounds the
 * gain of the row's waves.  The columns' origin lies behind the eye by a quarter of the
 * height, at most SET_BACK, and rows are wider than the view by a quarter of that. */
static int64_t row_half_width(const tp_fan_law *law, const tp_fan_view *view, tp_fx d,
                              tp_fx gain)
{
    const tp_dir3 ahead = view->projection->ahead;
    const int64_t forward = ((int64_t)ahead.x * law->right.z
                             - (int64_t)ahead.z * law->right.x) >> 30;
    const int64_t height = (int64_t)view->high * gain >> 16;
    int64_t depth = (d * forward - (int64_t)view->projection->eye.y * ahead.y
                     + height * tp_abs(ahead.y)) >> 30;

    const int64_t back = law->height / 4 < SET_BACK ? law->height / 4 : SET_BACK;
    depth = (depth > 0 ? depth : 0) + back;
    return tp_clamp_abs((depth * law->wide >> 16) + back / 4
                        + ((int64_t)view->aside * gain >> 16), TP_FAN_WIDEST);
}

/* Sets the distance of row n and its spacing along; returns half the width. */
static int64_t place_row(const tp_fan_law *law, const tp_fan_view *view, uint32_t n,
                         tp_fx *distance, tp_fx *along, tp_fx *gain)
{
    const int32_t gaps = (int32_t)law->cols - 1;

    *distance = row_distance(law, n, along);
    const int64_t half = row_half_width(law, view, *distance, TP_FX_ONE);
    *gain = tp_fx_mul(gain_bound(view, *along), gain_bound(view, 2 * half / gaps));
    return row_half_width(law, view, *distance, *gain);
}

/* A coarse nearest row raises its waves by their gain; the law is then solved again with
 * higher waves, so that the row still begins below the picture. */
tp_fan_law tp_fan_law_solve(const tp_fan_view *view, uint32_t vertices)
{
    if (view->walls)
        return view->walls->law(view, vertices);
    tp_fan_law law;
    tp_fx distance, along, gain;

    solve(&law, view, view->high, vertices);
    place_row(&law, view, 0, &distance, &along, &gain);
    const tp_fx high = tp_fx_saturate((int64_t)view->high * gain >> 16);
    if (high - view->high > TP_FX(0.125))
        solve(&law, view, high, vertices);
    return law;
}

/* Sets all numbers of the view that this file and fan_view.c read, but the eye's x and z;
 * `ahead` is -turn.z.  Returns true if a number has changed. */
TP_NEVER_INLINE bool update_key(int32_t key[TP_FAN_KEY], const tp_fan_view *view,
                                       uint32_t vertices)
{
    const tp_projection *p = view->projection;
    const tp_rotation *turn = &p->turn;
    const tp_rectangle *sides = &view->sides;
    const int32_t numbers[TP_FAN_KEY] = {
        (int32_t)view->width, (int32_t)view->height, (int32_t)vertices,
        view->half_longest, view->shortest, view->high, view->aside, view->land,
        view->detail, (int32_t)(view->detail_end >> 32),
        (int32_t)(uint32_t)view->detail_end, view->walls != NULL,
        sides->x0, sides->x1, sides->z0, sides->z1, p->eye.y, p->focal,
        turn->x.x, turn->x.y, turn->x.z, turn->y.x, turn->y.y, turn->y.z,
        turn->z.x, turn->z.y, turn->z.z,
    };

    TP_ASSERT(view->width > 0);
    if (memcmp(key, numbers, sizeof numbers) == 0)
        return false;
    memcpy(key, numbers, sizeof numbers);
    return true;
}

bool tp_fan_law_update(tp_fan_law *law, int32_t made_for[TP_FAN_KEY],
                       const tp_fan_view *view, uint32_t vertices)
{
    if (!update_key(made_for, view, vertices))
        return false;
    *law = tp_fan_law_solve(view, vertices);
    return true;
}

tp_fan_row tp_fan_law_row(const tp_fan_law *law, const tp_fan_view *view, uint32_t n)
{
    TP_ASSERT(n < law->rows && law->cols > 1);
    if (law->walls)
        return law->walls->row(law, view, n);
    const tp_vec3 eye = view->projection->eye;
    const int32_t gaps = (int32_t)law->cols - 1;
    tp_fan_row row;
    tp_fx d, gain;
    const int64_t half = place_row(law, view, n, &d, &row.along, &gain),
                  rx = law->right.x, rz = law->right.z;

    row.step_x = (tp_fx)((2 * half * rx >> 30) / gaps);
    row.step_z = (tp_fx)((2 * half * rz >> 30) / gaps);
    row.across = (tp_fx)(2 * half / gaps);
    row.x = tp_fx_saturate(eye.x + (d * rz >> 30) - (int64_t)row.step_x * gaps / 2);
    row.z = tp_fx_saturate(eye.z - (d * rx >> 30) - (int64_t)row.step_z * gaps / 2);
    return row;
}
