/* SPDX-License-Identifier: MIT */
/* Rules of a pool's cells without rounding, and the limits of stability by theory; for the
 * charts. */
#ifndef TP_TESTS_CHARTS_POOL_RULES_H
#define TP_TESTS_CHARTS_POOL_RULES_H
#include <stdbool.h>
#include "pool/pool.h"

enum { POOL_WHOLE = 1024 };         /* r2q of r = 1 */

/* -- theory -------------------------------------------------------------------------- */

/* V' = keep V + kick F, H' = H + V': [C4] for 8- and 16-bit cells, [C17] for 32-bit
 * cells. */
typedef struct { double keep, kick; } pool_rule;
pool_rule pool_rule_of(tp_cells cells, double r2, uint32_t m);

/* Growth factor of a step for the mode with K0's eigenvalue mu: the larger root. */
double pool_rule_root(pool_rule rule, double mu);

/* Von Neumann's bound of r^2 [C2], above which the shortest waves grow; and the bound of
 * [C9], the largest value a pool can be configured with. */
double pool_neumann_r2(tp_cells cells, uint32_t m);
double pool_bound_r2(uint32_t m);

/* The r below which the roundings of gear A add more energy than damping removes from noise
 * of rms h LSB [C8]. The error of each S is the carry out minus the carry in, 1 / 6 in the
 * mean square, and half of that is its energy. Damping removes the share delta of the
 * energy, which is r^2 / 2 times 4 h^2: r^2 = 2^m / 24 h^2. */
double pool_noise_r(double rms, uint32_t m);

/* The r below which the tank's longest wave creeps instead of swinging: damping is stronger
 * than r pi / cols [C6]. */
double pool_creep_r(uint32_t cols, uint32_t m);

/* -- fields in double precision ------------------------------------------------------ */

typedef struct {
    uint32_t cols, rows;
    double  *h, *v, *f;             /* heights, velocities, and room for forces */
} pool_field;

/* Copies the pool's present heights and velocities. */
pool_field pool_field_of(const tp_pool *pool);
void pool_field_free(pool_field *w);
void pool_field_step(pool_field *w, pool_rule rule);

/* Energy 2E = V.V + r^2 H.K0 (H - V) [C3], or the sum of the squares of the heights
 * alone. */
double pool_field_energy(const pool_field *w, double r2, bool heights);

/* Root mean square of a - b, or of a alone if b is NULL. */
double pool_rms(const double *a, const double *b, uint32_t count);

/* Allocates `count` zeros; ends the program if there is no memory. */
double *pool_room(uint32_t count);
void    pool_give_up(const char *what);
#endif
