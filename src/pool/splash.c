/* SPDX-License-Identifier: MIT */
/* Splashes of zero sum [C11] [D5], and the drive, random splashes that keep the water
 * moving [C16]. */
#include "base/base.h"
#include "pool/pool.h"

/* -- splashes ------------------------------------------------------------------------ */

/* The splash, a hat-shaped wave of zero sum [C11] [D5].  With s = rho^2 / (2 sigma^2) the
 * height is A (1 - s) exp(-s).  Its integral over the plane is 0.  Beyond s = 12 the height
 * is below A / 14000 and left out.
 *
 * On cells the sum is not 0, because some cells are walls or lie outside of the field.  A
 * plain bell exp(-s), scaled to cancel the sum, is subtracted from the hat.  The rounding
 * error of each cell is passed on to the next.  A cell at the end of its range may not
 * take its share: the missing rest is spread over the cells of the window, and last over
 * the whole field. */

#define S_MAX TP_FX(12)

typedef struct {
    tp_pool *pool;
    int64_t  u, w;              /* centre, in 1/256 of a cell */
    int64_t  over;              /* 1 / (2 sigma^2), sigma in cells, Q0.40 */
    int64_t  square_max;        /* 24 sigma^2 in 1/65536 of a square cell */
    int32_t  col, row;          /* first cell of the window; cells beyond the field wrap */
    int32_t  cols, rows;
    int64_t  ratio;             /* ratio of bell to hat, Q2.30 */
} splash;

/* Returns exp(-s) in Q2.30, s in 16.16, 0..12.  Tables give the integer part and the
 * sixteenths; the rest r < 1/16 is 1 - r + r^2 / 2 with an error of at most 4e-5. */
static int64_t exp_negative(int32_t s)
{
    static const int32_t whole[13] = {
        1073741824, 395007542, 145315153, 53458458, 19666267, 7234815, 2661540, 979126,
        360200, 132510, 48748, 17933, 6597,
    };
    static const int32_t sixteenth[16] = {
        1073741824, 1008685795, 947571421, 890159825, 836226660, 785561202, 737965472,
        693253480, 651250510, 611792418, 574725017, 539903458, 507191664, 476461840,
        447593904, 420475017,
    };
    const int64_t r = s & 0xfff;
    const int64_t part = ((int64_t)1 << 30) - (r << 14) + (r * r >> 3);

    return ((int64_t)whole[s >> 16] * sixteenth[s >> 12 & 15] >> 30) * part >> 30;
}

/* Returns s of a cell of the window; S_MAX for a cell beyond the reach of the hat. */
static int32_t cell_exponent(const splash *h, int32_t x, int32_t y)
{
    const int64_t du = (int64_t)(h->col + x) * 256 + 128 - h->u;
    const int64_t dw = (int64_t)(h->row + y) * 256 + 128 - h->w;
    const int64_t square = du * du + dw * dw;

    return square < h->square_max ? (int32_t)(square * h->over >> 40) : S_MAX;
}

static uint32_t wrapped(int32_t i, uint32_t cells)
{
    const int32_t n = (int32_t)cells;
    return (uint32_t)(i < 0 ? i + n : i < n ? i : i - n);
}

/* Adds `lsb` to a cell of the window.  Returns the part that fitted into its range. */
static int32_t add_height_to_cell(const splash *h, int32_t x, int32_t y, int32_t lsb)
{
    return tp_pool_add_cell_height(h->pool, wrapped(h->col + x, h->pool->cols),
                                   wrapped(h->row + y, h->pool->rows), lsb);
}

static bool is_wall(const splash *h, int32_t x, int32_t y)
{
    return tp_pool_is_wall_or_outside(h->pool, wrapped(h->col + x, h->pool->cols),
                                      wrapped(h->row + y, h->pool->rows));
}

/* Finds the ratio that makes the sum 0.  At most 2^18 cells of at most 2^30 each; the sum
 * of the bell is at least the bell at the centre cell. */
static void set_zero_sum_ratio(splash *h)
{
    int64_t hats = 0, bells = 0;

    for (int32_t y = 0; y < h->rows; y++) {
        for (int32_t x = 0; x < h->cols; x++) {
            const int32_t s = cell_exponent(h, x, y);
            if (s < S_MAX && !is_wall(h, x, y)) {
                bells += exp_negative(s);
                hats += (TP_FX_ONE - s) * exp_negative(s) >> 16;
            }
        }
    }
    TP_ASSERT(bells >> 16 > 0);
    h->ratio = hats * (1 << 14) / (bells >> 16);
    TP_ASSERT(h->ratio >= -(int64_t)2 * TP_Q30_ONE && h->ratio <= TP_Q30_ONE);
}

/* Adds the hat to the cells.  Returns the sum of the added heights.  The mean s of
 * the bell is below 3 for any walls: |hat - ratio bell| < 4, and a product by the
 * peak is below 2^62. */
static int64_t add_hat(const splash *h, int32_t peak)
{
    const int64_t half = (int64_t)1 << 29;
    const int32_t full = tp_pool_max_lsb(h->pool);
    int64_t carry = 0, sum = 0;

    for (int32_t y = 0; y < h->rows; y++) {
        for (int32_t x = 0; x < h->cols; x++) {
            const int32_t s = cell_exponent(h, x, y);
            if (s >= S_MAX || is_wall(h, x, y))
                continue;
            const int64_t hat = (TP_FX_ONE - s) * exp_negative(s) >> 16;
            carry += peak * (hat - (h->ratio * exp_negative(s) >> 30));
            const int64_t lsb = (carry + half) >> 30;
            carry -= lsb * ((int64_t)1 << 30);
            sum += add_height_to_cell(h, x, y, (int32_t)tp_clamp_abs(lsb, full));
        }
    }
    return sum;
}

/* Subtracts `sum` from the cells of the window, at most `max_per_cell` from each.
 * Returns the rest. */
static int64_t subtract_from_cells(const splash *h, int64_t sum, int64_t max_per_cell)
{
    for (int32_t y = 0; y < h->rows; y++) {
        for (int32_t x = 0; x < h->cols && sum != 0; x++) {
            if (cell_exponent(h, x, y) < S_MAX)
                sum += add_height_to_cell(h, x, y,
                                          (int32_t)-tp_clamp_abs(sum, max_per_cell));
        }
    }
    return sum;
}

/* Extends the window to all cells, at any distance. */
static void extend_window_to_field(splash *h)
{
    h->col = h->row = 0;
    h->cols = (int32_t)h->pool->cols;
    h->rows = (int32_t)h->pool->rows;
    h->over = 0;
    h->square_max = INT64_MAX;
}

/* Finds the columns (or rows) from `middle` - reach to `middle` + reach.  A field that
 * is not tiled clips the window; in a tiled field each column appears once.  Returns
 * the first column. */
static int32_t clip_window(int32_t middle, int32_t reach, uint32_t cells, bool tiled,
                           int32_t *count)
{
    const int32_t n = (int32_t)cells;
    int32_t first = middle - reach, last = middle + reach;

    if (tiled && 2 * reach >= n) {
        first = middle - n / 2;
        last = first + n - 1;
    } else if (!tiled) {
        first = first < 0 ? 0 : first;
        last = last < n ? last : n - 1;
    }
    *count = last - first + 1;
    return first;
}

/* Makes a splash around (u, w), Q32.32 in cells, inside the field and not in a wall.  sigma
 * is in cells, 16.16, clamped to 1.5..128.  |peak| is within the range, in LSB. */
static void pool_add_splash_cells(tp_pool *pool, uint64_t u, uint64_t w, tp_fx sigma,
                                  int32_t peak)
{
    TP_ASSERT(u >> 32 < pool->cols && w >> 32 < pool->rows);
    TP_ASSERT(peak >= -tp_pool_max_lsb(pool) && peak <= tp_pool_max_lsb(pool));
    const bool tiled = pool->edges == TP_EDGES_TILE;
    const int64_t wide = tp_clamp(sigma, TP_FX(1.5), TP_FX(128));
    const int64_t sigma2 = wide * wide >> 16;               /* sigma^2 in 16.16 */
    const int32_t reach = (int32_t)(5 * wide >> 16) + 1;    /* sqrt(24) sigma < 5 sigma */
    splash h = { .pool = pool, .u = (int64_t)(u >> 24), .w = (int64_t)(w >> 24),
                 .over = ((int64_t)1 << 55) / sigma2, .square_max = 24 * sigma2 };

    h.col = clip_window((int32_t)(u >> 32), reach, pool->cols, tiled, &h.cols);
    h.row = clip_window((int32_t)(w >> 32), reach, pool->rows, tiled, &h.rows);
    set_zero_sum_ratio(&h);
    int64_t sum = add_hat(&h, peak);
    const int64_t cells = (int64_t)h.cols * h.rows;
    sum = subtract_from_cells(&h, sum, tp_abs((int32_t)(sum / cells)) + 1);
    sum = subtract_from_cells(&h, sum, tp_pool_max_lsb(pool));
    if (sum != 0) {
        extend_window_to_field(&h);
        subtract_from_cells(&h, sum, 2 * (int64_t)tp_pool_max_lsb(pool));
    }
    tp_pool_start_carry_rounding(pool, peak);
}

bool tp_pool_add_splash(tp_pool *pool, tp_fx x, tp_fx z, tp_fx sigma, tp_fx height)
{
    uint32_t col, row;
    uint64_t u, w;

    if (!tp_pool_open_cell_at_point(pool, x, z, &col, &row))
        return false;
    tp_pool_locate(pool, x, z, &u, &w);
    pool_add_splash_cells(pool, u, w, tp_fx_div(sigma, pool->cell),
                             tp_pool_from_metres(pool, height));
    return true;
}

/* Returns metres x full / range, rounded to nearest, halves up.  A 32-bit cell is Q8.24:
 * 256 times as fine as 16.16. */
int32_t tp_pool_from_metres(const tp_pool *pool, tp_fx metres)
{
    const int64_t full = tp_pool_max_lsb(pool);
    const int64_t twice = 2 * (int64_t)pool->range;
    const int64_t up = 2 * (int64_t)metres * full + pool->range;
    int64_t lsb;

    if (pool->cells == TP_CELLS_32)
        lsb = (int64_t)metres * 256;
    else
        lsb = up / twice - (up % twice < 0);
    return (int32_t)tp_clamp_abs(lsb, full);
}

/* -- the drive ----------------------------------------------------------------------- */

/* The drive: random splashes that keep the water moving [C16].  Each step whose heights
 * have an rms below `drive_min` injects one splash at a random place.
 *
 * A splash of too small a height never lifts the rms into the band.  The height of the
 * splashes therefore adapts, once in a window of 64 ticks.  If at least half of its steps
 * injected, the height grows by an eighth.  Otherwise, if the rms is above `drive_max`, the
 * height shrinks again, but not below the configured height. */

static const tp_fx drive_sigma = TP_FX(2.5);     /* cells; waves of some 11 cells */

/* sum_of_squares adds the squares of all heights.  sum_of_squares_at_rms gives the same
 * sum for a pool with the height `rms` in each cell.  32-bit heights are cut to Q8.16:
 * 2^18 cells of (2^22)^2 are below 2^63. */
static int64_t sum_of_squares(const tp_pool *pool)
{
    const uint32_t count = tp_pool_count(pool);
    const int shift = pool->cells == TP_CELLS_32 ? 8 : 0;
    int64_t sum = 0;

    for (uint32_t i = 0; i < count; i++) {
        const int64_t h = tp_pool_cell_height(pool, i) >> shift;
        sum += h * h;
    }
    return sum;
}

static int64_t sum_of_squares_at_rms(const tp_pool *pool, tp_fx rms)
{
    const int64_t lsb = tp_pool_from_metres(pool, rms);
    const int64_t h = pool->cells == TP_CELLS_32 ? lsb >> 8 : lsb;
    return h * h * tp_pool_count(pool);
}

static uint32_t random_index(tp_pool *pool, uint32_t end)
{
    return (uint32_t)((uint64_t)tp_random(&pool->random) * end >> 32);
}

static void inject_random_splash(tp_pool *pool)
{
    TP_ASSERT(pool->drive_peak >= 0 && pool->drive_peak <= tp_pool_max_lsb(pool));
    const uint32_t col = random_index(pool, pool->cols);
    const uint32_t row = random_index(pool, pool->rows);
    const uint64_t half = (uint64_t)1 << 31;

    pool->drive_hits++;
    if (tp_pool_is_wall_or_outside(pool, col, row))
        return;                                 /* the next step tries another place */
    pool_add_splash_cells(pool, ((uint64_t)col << 32) + half,
                             ((uint64_t)row << 32) + half, drive_sigma, pool->drive_peak);
    pool->injections++;
}

static void adapt_splash_height(tp_pool *pool, bool above_band)
{
    const int32_t asked = tp_pool_from_metres(pool, pool->drive_amplitude),
                  full = tp_pool_max_lsb(pool);
    const int32_t step = pool->drive_peak / 8 + 1;

    if (2 * pool->drive_hits >= tp_pool_drive_window_steps(pool))
        pool->drive_peak = pool->drive_peak < full - step ? pool->drive_peak + step : full;
    else if (above_band)
        pool->drive_peak =
            pool->drive_peak - step > asked ? pool->drive_peak - step : asked;
    pool->drive_ticks = pool->drive_hits = 0;
}

void tp_pool_splash_if_quiet(tp_pool *pool)
{
    const int64_t sum = sum_of_squares(pool);

    if (sum < sum_of_squares_at_rms(pool, pool->drive_min))
        inject_random_splash(pool);
    if (++pool->drive_ticks == tp_pool_drive_window_steps(pool))
        adapt_splash_height(pool, sum > sum_of_squares_at_rms(pool, pool->drive_max));
}
