/* SPDX-License-Identifier: MIT */
#include "tests/charts/pool_truth.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

/* -- one mode ------------------------------------------------------------------------ */

/* h = e^-gt (A C(t) + B S(t)): C and S are cos(nt) and sin(nt)/n with n^2 = omega^2 - g^2;
 * where damping is too strong for waves, cosh and sinh. */
static double even(double square, double t)
{
    return square >= 0 ? cos(sqrt(square) * t) : cosh(sqrt(-square) * t);
}

static double odd(double square, double t)
{
    const double n = sqrt(fabs(square));

    if (n < 1e-9)
        return t;
    return square >= 0 ? sin(n * t) / n : sinh(n * t) / n;
}

double pool_truth_mode(double omega, double gamma, double height, double speed, double t)
{
    const double square = omega * omega - gamma * gamma;

    return exp(-gamma * t) * (height * even(square, t)
                              + (speed + gamma * height) * odd(square, t));
}

double pool_truth_speed(double omega, double gamma, double height, double before)
{
    const double square = omega * omega - gamma * gamma;

    return (height * even(square, 1) - before * exp(-gamma)) / odd(square, 1)
         - gamma * height;
}

/* -- fields -------------------------------------------------------------------------- */

static double *room_for(size_t count)
{
    double *const room = malloc(count * sizeof *room);

    if (!room) {
        fprintf(stderr, "out of memory\n");
        exit(EXIT_FAILURE);
    }
    return room;
}

/* Cosines of mode p of n at the i-th of `places` centres. */
static double *cosines(uint32_t n, uint32_t places)
{
    double *const table = room_for((size_t)n * places);

    for (uint32_t i = 0; i < places; i++)
        for (uint32_t p = 0; p < n; p++)
            table[(size_t)i * n + p] = cos(PI * p * (i + 0.5) / places);
    return table;
}

/* Matrix product: to[i][j] = sum over k of a[i][k] b[j][k]. */
static void multiply(const double *a, const double *b, double *to, uint32_t rows,
                     uint32_t cols, uint32_t length)
{
    for (uint32_t i = 0; i < rows; i++)
        for (uint32_t j = 0; j < cols; j++) {
            const double *const x = a + (size_t)i * length, *const y =
                b + (size_t)j * length;
            double sum = 0;
            for (uint32_t k = 0; k < length; k++)
                sum += x[k] * y[k];
            to[(size_t)i * cols + j] = sum;
        }
}

static double *turned(double *table, uint32_t rows, uint32_t cols)
{
    double *const to = room_for((size_t)rows * cols);

    for (uint32_t i = 0; i < rows; i++)
        for (uint32_t j = 0; j < cols; j++)
            to[(size_t)j * rows + i] = table[(size_t)i * cols + j];
    free(table);
    return to;
}

/* Amplitudes of the modes, from the heights at cell centres. */
static double *modes_of(const double *h, uint32_t cols, uint32_t rows)
{
    double *const x = turned(cosines(cols, cols), cols, cols);
    double *const z = turned(cosines(rows, rows), rows, rows);
    double *const half = room_for((size_t)cols * rows);
    double *const modes = room_for((size_t)cols * rows);

    multiply(x, h, half, cols, rows, cols);         /* [p][j] */
    multiply(z, half, modes, rows, cols, rows);     /* [q][p] */
    for (uint32_t q = 0; q < rows; q++)
        for (uint32_t p = 0; p < cols; p++)
            modes[(size_t)q * cols + p] *= (p ? 2.0 : 1.0) * (q ? 2.0 : 1.0)
                                         / ((double)cols * rows);
    free(x);
    free(z);
    free(half);
    return modes;
}

static double omega_of(const pool_truth *truth, uint32_t p, uint32_t q)
{
    return truth->r * PI * hypot((double)p / truth->cols, (double)q / truth->rows);
}

void pool_truth_init(pool_truth *truth, uint32_t cols, uint32_t rows, double r,
                     double rho, const double *now, const double *before)
{
    *truth = (pool_truth){ .cols = cols, .rows = rows, .r = r, .gamma = -log(rho) / 2 };
    truth->height = modes_of(now, cols, rows);
    truth->speed = before ? modes_of(before, cols, rows)
                          : calloc((size_t)cols * rows, sizeof(double));
    for (uint32_t i = 0; before && i < cols * rows; i++)
        truth->speed[i] = pool_truth_speed(omega_of(truth, i % cols, i / cols),
                                           truth->gamma, truth->height[i],
                                           truth->speed[i]);
}

void pool_truth_free(pool_truth *truth)
{
    free(truth->height);
    free(truth->speed);
}

void pool_truth_at(const pool_truth *truth, double t, uint32_t finer, double *to)
{
    const uint32_t cols = truth->cols, rows = truth->rows;
    double *const x = cosines(cols, cols * finer), *const z = cosines(rows, rows * finer);
    double *const modes = room_for((size_t)cols * rows);
    double *const half = room_for((size_t)cols * finer * rows);

    for (uint32_t i = 0; i < cols * rows; i++)
        modes[i] = pool_truth_mode(omega_of(truth, i % cols, i / cols), truth->gamma,
                                   truth->height[i], truth->speed[i], t);
    multiply(x, modes, half, cols * finer, rows, cols);             /* [x][q] */
    multiply(z, half, to, rows * finer, cols * finer, rows);        /* [z][x] */
    free(x);
    free(z);
    free(modes);
    free(half);
}
