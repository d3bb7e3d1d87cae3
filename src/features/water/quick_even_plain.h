/* SPDX-License-Identifier: MIT */
/* Fast light of every second column, and glints of all columns, as plain loops. */
#ifndef TP_WATER_QUICK_EVEN_PLAIN_H
#define TP_WATER_QUICK_EVEN_PLAIN_H
#include "features/water/quick_light_plain.h"
#include "tidepool/modules.h"

/* Lights the even columns, from the first even column on.  Slopes and views are read at
 * every second column of the run. */
TP_ALWAYS_INLINE void plain_light_even_loop(const plain_tables tables,
                                            const tp_run *restrict run,
                                            uint32_t *restrict even, int32_t odd,
                                            int32_t places, int env)
{
    const uint32_t *restrict slope = run->slope + odd, *restrict back = run->back + odd;
    const uint32_t *restrict column = run->column + odd;
    const int32_t  *restrict y = run->view_y + odd;

    for (int32_t k = 0; k < places; k++) {
        plain_column c = plain_column_make(&tables, slope[2 * k], back[2 * k], y[2 * k]);
        even[k] = plain_light_and_reflect(
            &tables, c, env == TP_ENV_DOME ? column[2 * k] : 0, even[k], env);
    }
}

TP_ALWAYS_INLINE void plain_light_even(const tp_shade *shade, tp_run *run, int env)
{
    const plain_tables tables = plain_tables_make(shade, env);
    const int32_t odd = run->x & 1;

    tp_quick_view_run(shade, run, TP_LOBE_BLINN);
    if (odd) {
        plain_column c = plain_column_make(&tables, run->slope[0], run->back[0],
                                         run->view_y[0]);
        run->even[0] = plain_light_and_reflect(
            &tables, c, env == TP_ENV_DOME ? run->column[0] : 0, run->even[0], env);
    }
    plain_light_even_loop(tables, run, run->even + odd, odd, (run->count - odd + 1) >> 1,
                          env);
}

/* Adds the glints.  The half vectors are those left in the run by the light of the even
 * columns. */
TP_ALWAYS_INLINE void plain_glint(const tp_shade *shade, tp_run *run, int lobe)
{
    const plain_tables tables = plain_tables_make(shade, TP_ENV_GRADIENT);
    uint32_t *restrict colour = run->colour;

    tp_quick_odd_fill(run);
    if (lobe == TP_LOBE_PHONG)
        tp_quick_view_run(shade, run, lobe);
    for (int32_t i = 0; i < run->count; i++) {
        plain_column c = plain_column_make(&tables, run->slope[i], run->back[i],
                                         run->view_y[i]);
        colour[i] = lobe == TP_LOBE_PHONG
                        ? plain_phong(&tables, c, run->view_l[i], colour[i])
                        : plain_blinn(&tables, run->slope[i], run->half[i], colour[i]);
    }
}
#endif
