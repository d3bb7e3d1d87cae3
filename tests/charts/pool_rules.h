/* SPDX-License-Identifier: MIT */
/* The rules of a pool's cells without any rounding, and where theory says that they fail;
 * for the charts. */
#ifndef POOL_RULES_H
#define POOL_RULES_H
#include <stdbool.h>
#include "pool/pool.h"

enum { POOL_WHOLE = 1024 };         /* r2q of r = 1 */

/* -- theory -------------------------------------------------------------------------- */

/* V' = keep V + kick F, H' = H + V': [C4] of 8- and 16-bit cells, [C17] of 32-bit. */
typedef struct { double keep, kick; } pool_rule;
pool_rule pool_rule_of(tp_cells cells, double r2, uint32_t m);

/* What a step multiplies the mode of K0's eigenvalue mu by: the larger root. */
double pool_rule_root(pool_rule rule, double mu);

/* Von Neumann's r^2 [C2], beyond which the shortest waves grow; and [C9]'s, beyond which
 * a pool cannot be configured. */
double pool_neumann_r2(tp_cells cells, uint32_t m);
double pool_bound_r2(uint32_t m);

/* The r below which gear A's roundings add more energy than damping takes from noise of
 * rms h LSB [C8].  Each S is off by what is carried on less what was carried here, 1 / 6
 * in the mean square, half of which is its energy; damping takes delta of the energy,
 * which is r^2 / 2 times 4 h^2: r^2 = 2^m / 24 h^2. */
double pool_noise_r(double rms, uint32_t m);

/* The r below which the tank's longest wave does not swing any more but creeps: damping
 * is stronger than r pi / cols [C6]. */
double pool_creep_r(uint32_t cols, uint32_t m);

/* -- fields in double ---------------------------------------------------------------- */

typedef struct {
    uint32_t cols, rows;
    double  *h, *v, *f;             /* heights, velocities, and room for forces */
} pool_field;

/* The pool's heights and velocities, now. */
pool_field pool_field_of(const tp_pool *pool);
void pool_field_free(pool_field *w);
void pool_field_step(pool_field *w, pool_rule rule);

/* 2E = V.V + r^2 H.K0 (H - V) [C3], or the squares of the heights alone. */
double pool_field_energy(const pool_field *w, double r2, bool heights);

/* Of a - b, or of a alone. */
double pool_rms(const double *a, const double *b, uint32_t count);

/* `count` zeros; ends the program where there is no memory. */
double *pool_room(uint32_t count);
void    pool_give_up(const char *what);
#endif
