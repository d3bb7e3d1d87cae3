/* SPDX-License-Identifier: MIT */
/* tidepool check: the pool's automaton, bit for bit and against its modes; [C4]-[C9],
 * [C17]. */
#include "check_pool.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "check.h"
#include "pixel/pixel.h"

tp_pool *check_pool_make(const check_pool_shape *shape)
{
    const tp_pool_config config = {
        .cols = shape->cols, .rows = shape->rows, .cells = shape->cells,
        .courant = shape->courant, .damping = shape->damping,
        .range = TP_FX_ONE, .cell = TP_FX_ONE / 4, .mask = shape->mask,
    };
    const size_t bytes = tp_pool_bytes(&config);
    tp_pool *pool = bytes ? malloc(bytes) : NULL;
    if (pool)
        tp_pool_init(pool, &config, NULL);
    return pool;
}

int check_pool_refuse(const check_run *run, unsigned row, const check_pool_shape *shape)
{
    return check_refuse(run, row, "no pool of %u x %u cells, r = %.4g and damping 2^-%u"
                        " can be made", (unsigned)shape->cols, (unsigned)shape->rows,
                        check_metres(shape->courant), (unsigned)shape->damping);
}

/* -- bit for bit --------------------------------------------------------------------- */

enum { CASE, BITS, N, M, R2Q, DM, INIT, STEP, GEAR, SUM_H, SUM_V, MAX_H, CRC };

static const check_field int_columns[] = {
    { .name = "case", .high = 1e6, .kind = CHECK_WHOLE },
    { .name = "bits", .kind = CHECK_WORD, .words = "8|16" },
    { .name = "N", .low = 16, .high = 512, .kind = CHECK_WHOLE },
    { .name = "M", .low = 1, .high = 512, .kind = CHECK_WHOLE },
    { .name = "r2q", .low = 3, .high = 255, .kind = CHECK_WHOLE },
    { .name = "dm", .low = 4, .high = 10, .kind = CHECK_WHOLE },
    { .name = "init", .kind = CHECK_TEXT },
    { .name = "step", .low = 1, .high = 1e6, .kind = CHECK_WHOLE },
    { .name = "gear", .kind = CHECK_WORD, .words = "B|A" },
    { .name = "sumH", .low = -1e12, .high = 1e12, .kind = CHECK_WHOLE },
    { .name = "sumV", .low = -1e12, .high = 1e12, .kind = CHECK_WHOLE },
    { .name = "maxabsH", .high = 32768, .kind = CHECK_WHOLE },
    { .name = "crc32", .high = 4294967295.0, .kind = CHECK_WHOLE },
};

static const check_field int_gear[] = {
    { .name = "last step of gear A", .high = 1e6, .kind = CHECK_WHOLE },
};

/* A pool has at least 16 rows: the mask turns the rows beyond the table's M into walls,
 * which do not affect the water. */
enum { ROWS_LEAST = 16 };

static uint16_t mask_samples[ROWS_LEAST];

static tp_grey make_mask(unsigned rows)
{
    for (unsigned i = 0; i < ROWS_LEAST; i++)
        mask_samples[i] = i < rows ? 65535 : 0;
    return (tp_grey){ .cols = 1, .rows = ROWS_LEAST, .sample = mask_samples };
}

/* Adds "index:height;index:height..." to the cells. */
static int stir(const check_run *run, unsigned row, tp_pool *pool)
{
    const double *v = check_row(run, row);
    const double cells = v[N] * v[M], most = v[BITS] > 0 ? 32767 : 127;
    const char *text = check_text(run, row, INIT);
    double index, height;
    for (const char *at = text; at; at = *at == ';' ? at + 1 : NULL) {
        at = csv_number(at, &index);
        at = at && *at == ':' ? csv_number(at + 1, &height) : NULL;
        if (!at || (*at && *at != ';') || index != floor(index) || height != floor(height)
            || index < 0 || index >= cells || fabs(height) > most)
            return check_refuse(run, row, "init: expected INDEX:HEIGHT;..., found"
                                " '%.40s'", text);
        tp_pool_add_cell_height(pool, (uint32_t)fmod(index, v[N]), (uint32_t)(index / v[N]),
                    (int32_t)height);
    }
    tp_pool_start_carry_rounding(pool, (int32_t)most);
    return EXIT_DONE;
}

typedef struct {
    double   sum, highest;
    uint32_t crc;
} digest;

static void digest_cell(digest *d, int32_t x)
{
    const uint8_t byte[2] = { (uint8_t)x, (uint8_t)((uint32_t)x >> 8) };
    d->sum += x;
    d->highest = fmax(d->highest, abs((int)x));
    d->crc = tp_crc32(d->crc, byte, 2);
}

/* Sums the heights or the velocities of the open rows. */
static digest digest_cells(const tp_pool *pool, const double *v, uint32_t crc,
                           int32_t (*cell)(const tp_pool *pool, uint32_t col, uint32_t row))
{
    digest d = { .crc = crc };
    for (uint32_t j = 0; j < (uint32_t)v[M]; j++)
        for (uint32_t i = 0; i < (uint32_t)v[N]; i++)
            digest_cell(&d, cell(pool, i, j));
    return d;
}

static void compare_bits(check_run *run, unsigned row, const tp_pool *pool)
{
    const double *v = check_row(run, row);
    const digest h = digest_cells(pool, v, 0, tp_pool_height_lsb);
    const digest s = digest_cells(pool, v, h.crc, tp_pool_velocity);
    check_add(run, 0, row, s.crc != (uint32_t)v[CRC]);
    check_add(run, 1, row, h.sum - v[SUM_H]);
    check_add(run, 2, row, s.sum - v[SUM_V]);
    check_add(run, 3, row, h.highest - v[MAX_H]);
}

/* Steps through the rows of one case, in order of steps. */
static int run_case(check_run *run, unsigned *row, tp_pool *pool)
{
    const double *first = check_row(run, *row), last_a = run->lines[0][0][0];
    for (double step = 0; *row < run->table.n_rows; ++*row) {
        const double *v = check_row(run, *row);
        if (v[CASE] != first[CASE])
            break;
        if (v[STEP] <= step)
            return check_refuse(run, *row, "step %g after step %g", v[STEP], step);
        if ((v[GEAR] > 0) != (v[STEP] <= last_a))
            return check_refuse(run, *row, "step %g does not belong to that gear", v[STEP]);
        while (step < v[STEP]) {
            pool->gear = ++step <= last_a;
            tp_pool_step(pool);
        }
        compare_bits(run, *row, pool);
    }
    return EXIT_DONE;
}

static int run_automaton_int(check_run *run)
{
    int code = EXIT_DONE;
    for (unsigned row = 0; !code && row < run->table.n_rows;) {
        const double *v = check_row(run, row);
        const tp_grey mask = make_mask((unsigned)v[M]);
        const bool small = v[M] < ROWS_LEAST;
        const check_pool_shape shape = {
            .cells = v[BITS] > 0 ? TP_CELLS_16 : TP_CELLS_8, .cols = (uint32_t)v[N],
            .rows = small ? ROWS_LEAST : (uint32_t)v[M],
            .courant = check_fx(sqrt(v[R2Q] / 1024)), .damping = (uint32_t)v[DM],
            .mask = small ? &mask : NULL,
        };
        tp_pool *pool = check_pool_make(&shape);
        code = pool ? stir(run, row, pool) : check_pool_refuse(run, row, &shape);
        if (!code)
            code = run_case(run, &row, pool);
        free(pool);
    }
    return code;
}

const check_model check_automaton_int = {
    CHECK_ALL(int_columns),
    .notes = { { "[C8][C9] bit-exact integer steps: gear A for steps 1..% then gear B;"
                 " init = list index:height, V=0; crc32 (zlib, IEEE) of int16 LE H[]"
                 " row-major then V[]; r2q=1024 r^2; damping 2^-dm; saturation"
                 " +-(2^(bits-1)-1)",
                 CHECK_ALL(int_gear), false } },
    .quantities = { { "crc32", "", 0 }, { "sum of H", "LSB", 0 },
                    { "sum of V", "LSB", 0 }, { "max |H|", "LSB", 0 } },
    .run = run_automaton_int,
};

/* -- modes --------------------------------------------------------------------------- */

enum { MODE_N, MODE_M, MODE_P, MODE_Q, R2, DELTA, STEPS, MU, OMEGA, DISCRETE, FLUX };

/* Bound of a mode with initial amplitude 1.  With g = r^2 mu, the energy of [C3], V^2 / 2 +
 * g H (H - V) / 2, never exceeds its initial value g / 2.  For a given H the energy is at
 * least g H^2 (1 - g / 4) / 2.  Hence H^2 <= 1 / (1 - g / 4), below 2 for r^2 <= 1/4 and mu
 * < 8.  [C17] swings no higher in any mode tried (1.376).  The mode of the wave equation
 * stays within 1, up to rounding. */
#define SWING(n) { .name = n, .low = -1.41422, .high = 1.41422 }

/* n: up to the last tick for which tp_pool_rounding_noise bounds a wave. */
static const check_field mode_columns[] = {
    { .name = "N", .low = 16, .high = 512, .kind = CHECK_WHOLE },
    { .name = "M", .low = 16, .high = 512, .kind = CHECK_WHOLE },
    { .name = "p", .high = 511, .kind = CHECK_WHOLE },
    { .name = "q", .high = 511, .kind = CHECK_WHOLE },
    { .name = "r2", .low = 0.0025, .high = 0.25 },
    { .name = "delta", .low = 1.0 / 1024, .high = 1.0 / 16 },
    { .name = "n", .low = 1, .high = 400, .kind = CHECK_WHOLE },
    { .name = "mu", .high = 8 }, { .name = "Omega", .high = CHECK_PI },
    SWING("H_discrete"), SWING("H_flux"), CHECK_UNIT("H_wave"),
};

/* Amplitude, LSB: a quarter of the range of each kind of cell. */
static const double quarter_range[] = { 127 / 4.0, 32767 / 4.0, 2147483648.0 / 4 };

/* Returns the mode of amplitude 1 at a cell. */
static double sample_mode(const double *v, uint32_t col, uint32_t row)
{
    return cos(CHECK_PI * v[MODE_P] * (col + 0.5) / v[MODE_N])
         * cos(CHECK_PI * v[MODE_Q] * (row + 0.5) / v[MODE_M]);
}

static void stir_mode(tp_pool *pool, const double *v)
{
    const double amplitude = quarter_range[pool->cells];
    for (uint32_t j = 0; j < pool->rows; j++)
        for (uint32_t i = 0; i < pool->cols; i++)
            tp_pool_add_cell_height(pool, i, j,
                                    (int32_t)lround(amplitude * sample_mode(v, i, j)));
    tp_pool_start_carry_rounding(pool, (int32_t)amplitude);
}

/* Errors, LSB: in the corner cell, where every mode has its full height; rms of all cells;
 * largest of all cells. */
typedef struct {
    double corner, rms, worst;
} mode_error;

static mode_error measure_mode_error(const tp_pool *pool, const double *v, double share)
{
    const double amplitude = quarter_range[pool->cells] * share;
    const double corner = tp_pool_height_lsb(pool, 0, 0) - amplitude * sample_mode(v, 0, 0);
    mode_error e = { .corner = corner };
    double squares = 0;
    for (uint32_t j = 0; j < pool->rows; j++) {
        for (uint32_t i = 0; i < pool->cols; i++) {
            const double off =
                tp_pool_height_lsb(pool, i, j) - amplitude * sample_mode(v, i, j);
            squares += off * off;
            e.worst = fmax(e.worst, fabs(off));
        }
    }
    e.rms = sqrt(squares / (v[MODE_N] * v[MODE_M]));
    return e;
}

/* Returns the allowed rms error of a wave of 8- or 16-bit cells, LSB: see
 * tp_pool_rounding_noise. */
static double mode_noise(const tp_pool *pool, const double *v)
{
    const double k = CHECK_PI * hypot(v[MODE_P] / v[MODE_N], v[MODE_Q] / v[MODE_M]);
    const double noise =
        check_metres(tp_pool_rounding_noise(check_fx(sqrt(v[R2])), pool->damping));
    return 1 + 8 * noise + fmin(2 * quarter_range[pool->cells], 1 / (v[R2] * k));
}

/* Compares 8- and 16-bit cells with the bound of their noise, and 32-bit cells one by one
 * in percent of the amplitude. */
static void compare_mode(check_run *run, unsigned row, const tp_pool *pool)
{
    const double *v = check_row(run, row);
    if (pool->cells == TP_CELLS_32) {
        const mode_error e = measure_mode_error(pool, v, v[FLUX]);
        check_add(run, 4, row, 100 * e.worst / quarter_range[TP_CELLS_32]);
    } else {
        const mode_error e = measure_mode_error(pool, v, v[DISCRETE]);
        const double noise = mode_noise(pool, v);
        check_add(run, 2 * pool->cells, row, e.corner / (2 * noise));
        check_add(run, 2 * pool->cells + 1, row, e.rms / noise);
    }
}

/* Steps through the rows of one mode, up to `last`. */
static int run_mode(check_run *run, unsigned row, unsigned last, tp_cells cells)
{
    const double *v = check_row(run, row);
    const check_pool_shape shape = {
        .cells = cells, .cols = (uint32_t)v[MODE_N], .rows = (uint32_t)v[MODE_M],
        .courant = check_fx(sqrt(v[R2])), .damping = (uint32_t)lround(-log2(v[DELTA])),
    };
    if (v[R2] * 1024 != floor(v[R2] * 1024) || ldexp(v[DELTA], (int)shape.damping) != 1)
        return check_refuse(run, row, "1024 r2 is no whole number, or delta no 2^-m");
    tp_pool *pool = check_pool_make(&shape);
    if (!pool)
        return check_pool_refuse(run, row, &shape);
    stir_mode(pool, v);
    for (double n = 0; row <= last; row++) {
        for (; n < check_row(run, row)[STEPS]; n++) {
            pool->gear = 2;                     /* stays in gear A */
            tp_pool_step(pool);
        }
        compare_mode(run, row, pool);
    }
    free(pool);
    return EXIT_DONE;
}

/* Returns the last row of the mode that begins at `row`; steps increase within a mode. */
static unsigned last_of_mode(const check_run *run, unsigned row)
{
    const double *first = check_row(run, row);
    while (row + 1 < run->table.n_rows
           && memcmp(check_row(run, row + 1), first, STEPS * sizeof *first) == 0
           && check_row(run, row + 1)[STEPS] > check_row(run, row)[STEPS])
        row++;
    return row;
}

static int run_automaton_mode(check_run *run)
{
    int code = EXIT_DONE;
    for (unsigned row = 0; !code && row < run->table.n_rows;) {
        const unsigned last = last_of_mode(run, row);
        check_progress(run, row);
        for (int cells = TP_CELLS_8; !code && cells <= TP_CELLS_32; cells++)
            code = run_mode(run, row, last, (tp_cells)cells);
        row = last + 1;
    }
    return code;
}

const check_model check_automaton_mode = {
    CHECK_ALL(mode_columns),
    .notes = { { .text = "[C6] mode cos(pi p(i+1/2)/N)cos(pi q(j+1/2)/M), reflecting"
                         " walls, H0=amplitude 1, V0=0, damped-centred scheme [C4];"
                         " H_discrete closed form after n steps of [C4] (8- and 16-bit"
                         " cells); H_flux after n steps of [C17] (32-bit cells, damping"
                         " after the kick); H_wave: continuous wave equation at t=n dt"
                         " with envelope (1-delta)^(n/2)" } },
    .quantities = { { "8-bit corner", "noise", 1 }, { "8-bit rms", "noise", 1 },
                    { "16-bit corner", "noise", 1 }, { "16-bit rms", "noise", 1 },
                    { "32-bit cells", "%", 0.5 } },
    .run = run_automaton_mode,
};
