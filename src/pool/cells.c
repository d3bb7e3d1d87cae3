/* SPDX-License-Identifier: MIT */
/* The cells of a pool: access to single cells, statistics of all cells, the step, the
 * choice of the rounding mode (gear) after a change, and the check of stored cells. */
#include "base/base.h"
#include "pool/pool.h"

/* -- access, statistics, step -------------------------------------------------------- */

int32_t tp_pool_cell_height(const tp_pool *pool, uint32_t index)
{
    const void *const cells = tp_pool_const_pointer(pool, sizeof *pool);

    switch (pool->cells) {
    case TP_CELLS_8:  return ((const tp_pool_pair_8 *)cells)[index].h;
    case TP_CELLS_16: return ((const tp_pool_pair_16 *)cells)[index].h;
    default:          return ((const int32_t *)cells)[index];
    }
}

static int32_t cell_velocity(const tp_pool *pool, uint32_t col, uint32_t row)
{
    const void *const cells = tp_pool_const_pointer(pool, sizeof *pool);
    const uint32_t index = row * pool->cols + col;

    switch (pool->cells) {
    case TP_CELLS_8:  return ((const tp_pool_pair_8 *)cells)[index].v;
    case TP_CELLS_16: return ((const tp_pool_pair_16 *)cells)[index].v;
    default:          return tp_pool_net_inflow(pool, col, row);
    }
}

static bool has_cell(const tp_pool *pool, uint32_t col, uint32_t row)
{
    return col < pool->cols && row < pool->rows;
}

int32_t tp_pool_height_lsb(const tp_pool *pool, uint32_t col, uint32_t row)
{
    return has_cell(pool, col, row) ? tp_pool_cell_height(pool, row * pool->cols + col) : 0;
}

int32_t tp_pool_velocity(const tp_pool *pool, uint32_t col, uint32_t row)
{
    return has_cell(pool, col, row) ? cell_velocity(pool, col, row) : 0;
}

bool tp_pool_is_wall_or_outside(const tp_pool *pool, uint32_t col, uint32_t row)
{
    return !has_cell(pool, col, row) || tp_pool_is_wall(pool, row * pool->cols + col);
}

/* The velocity is kept: the height before the last step changes by the same amount.  Both
 * heights stay in the range, as [C5] and the interpolation between two steps require
 * [C11]. */
int32_t tp_pool_add_cell_height(tp_pool *pool, uint32_t col, uint32_t row, int32_t lsb)
{
    if (tp_pool_is_wall_or_outside(pool, col, row))
        return 0;
    void *const cells = tp_pool_pointer(pool, sizeof *pool);
    const uint32_t i = row * pool->cols + col;
    const int32_t full = tp_pool_max_lsb(pool), h = tp_pool_cell_height(pool, i);
    const int32_t v = cell_velocity(pool, col, row);
    const int32_t low = (v > 0 ? v - full : -full) - h;
    const int32_t added = tp_clamp(lsb, low, (v < 0 ? v + full : full) - h);

    switch (pool->cells) {
    case TP_CELLS_8:  ((tp_pool_pair_8 *)cells)[i].h = (int8_t)(h + added);    break;
    case TP_CELLS_16: ((tp_pool_pair_16 *)cells)[i].h = (int16_t)(h + added);  break;
    default:          ((int32_t *)cells)[i] = h + added;                       break;
    }
    pool->at_rest &= added == 0;
    return added;
}

/* Returns ln x in Q4.28 for 1 <= x < 2^16.  Computes the digits of the binary logarithm by
 * repeated squaring, then multiplies by ln 2. */
static uint64_t natural_log(uint32_t x)
{
    TP_ASSERT(x > 0 && x < 1u << 16);
    const uint64_t ln2 = 0xb17217f7;                        /* Q0.32 */
    const int      zeros = tp_clz(x);
    uint64_t digits = (uint64_t)(31 - zeros), m = (uint64_t)x << zeros;  /* m in Q1.31 */

    for (int i = 0; i < 28; i++) {
        m = (m * m + (1u << 30)) >> 31;
        digits = digits << 1 | m >> 32;
        m >>= m >> 32;
    }
    return digits * ln2 >> 32;
}

/* Subtracts `h_part` and `v_part` from the height and the velocity of a cell.  Skips
 * a wall, and a cell whose velocity, height, or height before the last step would
 * leave the range. */
static void subtract_from_cell(tp_pool *pool, uint32_t i, int64_t *h_sum, int64_t *v_sum,
                               int64_t h_part, int64_t v_part)
{
    const int32_t full = tp_pool_max_lsb(pool);
    const int32_t here = tp_pool_cell_height(pool, i);
    const int32_t speed = cell_velocity(pool, i % pool->cols, i / pool->cols);
    const int64_t next = here - h_part, now = speed - v_part;

    if (tp_pool_is_wall(pool, i) || next > full || next < -full || next - now > full
        || next - now < -full || now > full || now < -full)
        return;
    *h_sum -= h_part;
    *v_sum -= v_part;
    if (pool->cells == TP_CELLS_8)
        ((tp_pool_pair_8 *)tp_pool_pointer(pool, sizeof *pool))[i] =
            (tp_pool_pair_8){ (int8_t)next, (int8_t)now };
    else
        ((tp_pool_pair_16 *)tp_pool_pointer(pool, sizeof *pool))[i] =
            (tp_pool_pair_16){ (int16_t)next, (int16_t)now };
}

/* Brings the sums of heights and of velocities to 0.  Gear B truncates and leaves a
 * sum of velocities.  Gear A would keep this sum for 2^m ticks, and the water level
 * would rise.  Measured with splashes of 20 LSB, each at the moment when gear B
 * begins, at m = 10: without this function the mean reached 90 of 127 and 452 of 32767
 * LSB, with it 0.97 and 1.19. */
static void zero_height_and_velocity_sums(tp_pool *pool)
{
    const uint32_t count = tp_pool_count(pool);
    int64_t h = 0, v = 0;

    for (uint32_t i = 0; i < count; i++) {
        h += tp_pool_cell_height(pool, i);
        v += cell_velocity(pool, i % pool->cols, i / pool->cols);
    }
    const int64_t h_mean = h / count, v_mean = v / count;
    for (uint32_t i = 0; i < count && (h_mean | v_mean) != 0; i++)
        subtract_from_cell(pool, i, &h, &v, h_mean, v_mean);
    for (uint32_t i = 0; i < count && (h | v) != 0; i++)
        subtract_from_cell(pool, i, &h, &v, (h > 0) - (h < 0), (v > 0) - (v < 0));
}

/* Runs gear A for TA = ceil(2^(m+1) ln(A / 8)) steps [C11].  An earlier, higher wave keeps
 * its longer time. */
void tp_pool_start_carry_rounding(tp_pool *pool, int32_t peak_lsb)
{
    const int32_t full = tp_pool_max_lsb(pool);
    const uint32_t peak = (uint32_t)tp_abs(tp_clamp(peak_lsb, -full, full));

    if (pool->cells == TP_CELLS_32 || peak <= 8)
        return;
    const uint64_t time = ((natural_log(peak) - natural_log(8)) << (pool->damping + 1))
                        + (1u << 28) - 1;
    if (pool->gear == 0 && !pool->at_rest && pool->tick > 0)
        zero_height_and_velocity_sums(pool);
    if (time >> 28 > pool->gear)
        pool->gear = (uint32_t)(time >> 28);
}

tp_pool_state tp_pool_stats(const tp_pool *pool)
{
    tp_pool_state state = { .at_rest = pool->at_rest != 0 };

    for (uint32_t row = 0; row < pool->rows; row++) {
        for (uint32_t col = 0; col < pool->cols; col++) {
            const int32_t h = tp_pool_height_lsb(pool, col, row);
            const int32_t v = tp_pool_velocity(pool, col, row);
            state.sum += h;
            state.highest = tp_abs(h) > state.highest ? tp_abs(h) : state.highest;
            state.fastest = tp_abs(v) > state.fastest ? tp_abs(v) : state.fastest;
        }
    }
    return state;
}

void tp_pool_step_kind(tp_pool *pool, const tp_pool_kind *kind, tp_pool_drive *drive)
{
    TP_ASSERT(pool->cells <= TP_CELLS_32 && pool->damping >= 4 && pool->damping <= 10);
    TP_ASSERT(kind != NULL);
    const bool due = tp_pool_is_due(pool);

    if (due && pool->drive_min > 0 && drive)
        drive(pool);
    if (due && !pool->at_rest)
        kind->step(pool);
    pool->tick++;
}

const tp_pool_kind *tp_pool_find_kind(const tp_pool *pool)
{
    static const tp_pool_kind *const all[] = {
#define X(name) &tp_pool_##name,
        TP_POOL_KINDS(X)
#undef X
    };

    return all[tp_pool_kind_number((tp_cells)pool->cells, pool->walls != 0,
                                   pool->sponge != 0)];
}

void tp_pool_step(tp_pool *pool)
{
    tp_pool_step_kind(pool, tp_pool_find_kind(pool), tp_pool_splash_if_quiet);
}

/* -- stored cells -------------------------------------------------------------------- */

/* Check of a pool that was stored outside of the program.
 *
 * Cells of 8 and 16 bits: the height and the height before the last step lie within the
 * range [C5].  Cells of 32 bits: the same holds, and a flux is at most half of the range,
 * the most that one giver can spare [C17].  A flux into a wall is 0.  A step leads from
 * valid cells to valid cells, and none of its sums leaves 32 bits. */

static bool is_within_limit(int64_t x, int64_t most)
{
    return x >= -most && x <= most;
}

/* Compares all fields of the head except the fields that steps change. */
static bool is_same_config(const tp_pool *pool, const tp_pool *fresh)
{
    tp_pool head = *fresh;

    head.drive_peak = pool->drive_peak;
    head.drive_ticks = pool->drive_ticks;
    head.drive_hits = pool->drive_hits;
    head.random = pool->random;
    head.injections = pool->injections;
    head.gear = pool->gear;
    head.at_rest = pool->at_rest;
    head.no_flux = pool->no_flux;
    return memcmp(&head, pool, offsetof(tp_pool, interval) + sizeof head.interval) == 0;
}

static bool is_same_part(const tp_pool *pool, const tp_pool *fresh, uint32_t offset,
                         uint32_t bytes)
{
    return offset == 0
           || memcmp(tp_pool_const_pointer(pool, offset),
                     tp_pool_const_pointer(fresh, offset), bytes)
                  == 0;
}

static bool are_cells_valid(const tp_pool *pool)
{
    const int32_t full = tp_pool_max_lsb(pool);

    for (uint32_t row = 0; row < pool->rows; row++) {
        for (uint32_t col = 0; col < pool->cols; col++) {
            const int32_t h = tp_pool_height_lsb(pool, col, row);
            const int32_t v = tp_pool_velocity(pool, col, row);
            const int32_t most = tp_pool_is_wall_or_outside(pool, col, row) ? 0 : full;
            if (!is_within_limit(h, most) || !is_within_limit(v, most)
                || !is_within_limit(h - v, most))
                return false;
        }
    }
    return true;
}

/* True if water can flow between a cell and its neighbour to the right (or below, for
 * `down`): neither is a wall, and both are in the pool or the pool is tiled. */
static bool can_flow(const tp_pool *pool, uint32_t col, uint32_t row, bool down)
{
    const bool last = down ? row + 1 == pool->rows : col + 1 == pool->cols;
    const uint8_t *walls = tp_pool_const_pointer(pool, pool->walls);

    if (pool->walls != 0)
        return walls[row * pool->cols + col] & (down ? TP_OPEN_DOWN : TP_OPEN_RIGHT);
    return !last || pool->edges == TP_EDGES_TILE;
}

static bool is_flux_valid(int32_t flux, bool open)
{
    return is_within_limit(flux, open ? TP_FULL_32 / 2 : 0);
}

static bool are_fluxes_valid(const tp_pool *pool)
{
    const uint32_t cols = pool->cols, count = tp_pool_count(pool);
    const int32_t *const right =
        (const int32_t *)tp_pool_const_pointer(pool, sizeof *pool) + count;

    for (uint32_t i = 0; i < count; i++) {
        const uint32_t col = i % cols, row = i / cols;
        if (!is_flux_valid(right[i], can_flow(pool, col, row, false))
            || !is_flux_valid(right[count + i], can_flow(pool, col, row, true)))
            return false;
    }
    return true;
}

/* Four valid fluxes add up to 2^31 - 4 at the most. */
static bool are_heights_valid(const tp_pool *pool)
{
    for (uint32_t row = 0; row < pool->rows; row++) {
        for (uint32_t col = 0; col < pool->cols; col++) {
            const int64_t h = tp_pool_height_lsb(pool, col, row);
            const int64_t gain = tp_pool_net_inflow(pool, col, row);
            const int32_t most =
                tp_pool_is_wall_or_outside(pool, col, row) ? 0 : TP_FULL_32;
            if (!is_within_limit(h, most) || !is_within_limit(h - gain, TP_FULL_32))
                return false;
        }
    }
    return true;
}

bool tp_pool_is_valid(const tp_pool *pool, const tp_pool *fresh)
{
    if (!is_same_config(pool, fresh)
        || !is_same_part(pool, fresh, pool->walls, tp_pool_count(pool))
        || !is_same_part(pool, fresh, pool->sponge, pool->cols + pool->rows)
        || pool->drive_peak < 0 || pool->drive_peak > tp_pool_max_lsb(pool)
        || pool->drive_ticks >= tp_pool_drive_window_steps(pool)
        || pool->drive_hits > pool->drive_ticks
        || pool->at_rest > 1 || pool->no_flux > 1)
        return false;
    return pool->cells == TP_CELLS_32 ? are_fluxes_valid(pool) && are_heights_valid(pool)
                                      : are_cells_valid(pool);
}
