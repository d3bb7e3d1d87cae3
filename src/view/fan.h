/* SPDX-License-Identifier: MIT */
/*
 * The fan: the water's grid as rows across the camera's heading, out to the horizon.
 *
 * Rows lie at distances d along the heading, near the eye dense: the spacing is a r with
 * r^2 = d^2 + h^2 and h the height of the eye, or a length by the waves if that is larger,
 * so d = h sinh(u) for equal steps of u.
 * Beyond r* the spacing grows as r^3: r = r* / sqrt(1 - 2 m).  Swells leave the rows where
 * half the longest is the spacing.  Rings and pools leave the rows at their farthest place,
 * or where half of their length is the spacing, if that is nearer.  r* is the larger
 * distance of the two.  If rings or pools are the only waves, the spacing grows as r^9, so
 * that few rows lead to the horizon.  The number of rows determines a.  Columns lead away
 * from a point behind the eye; each row is as wide as the view at its depth.
 *
 * A wave is kept by a row as far as the row can hold the wave [V4]: the weight is 1 up to a
 * spacing of 0.3 wavelengths and 0 from 0.5 on, along the heading and across.  Rings and
 * pools are weighed as a wave of their length, without gain.  The slopes of swells left out
 * are known as a variance.  Kept waves have a gain of 1 + (k d)^2 / 12 along and
 * across, since linear interpolation lowers them by that share.  Measured at equal vertices,
 * kept scenes at tick 600 against 16 samples: lava 12.06 to 10.90, storm 10.62 to 9.50,
 * count-64 7.88 to 7.17, three-swells 8.55 to 8.14, none worse; frame to frame the pictures
 * change by 5 % more at the most.
 *
 * The pixels do not carry the waves left out.  Measured against 16 samples: slopes by pixel
 * of waves between 2 px and 3.3 cells change the error of three-swells from 7.6 to 7.5 and
 * of deep-sea from 12.4 to 12.5 (of 255).  A pixel of distant water is longer than a cell,
 * and a slope without its height lies at the wrong place.  More vertices are cheaper.
 *
 * Every vertex evaluates its waves.  The weights of a row's waves are not kept: rows times
 * waves need 3.5 KB in storm and would save less than 0.3 M of its 70 M instructions a
 * frame.
 *
 * Water that ends at the walls of a tank has rows along the tank's sides, with cells of
 * equal size (fan_tank.c).
 */
#ifndef TP_VIEW_FAN_H
#define TP_VIEW_FAN_H
#include "view/grid.h"
#include "view/rough.h"

struct tp_fan_wave;
struct tp_fan_waves;

/* A row of vertices: the rest position of column i is (x + i step_x, z + i step_z). */
typedef struct tp_fan_row {
    tp_fx x, z, step_x, step_z;
    tp_fx along, across;        /* distance of neighbours along the heading, across */
} tp_fan_row;

/* The numbers of a view and its water that determine the rows. */
typedef struct tp_fan_view {
    const tp_projection *projection;
    uint32_t width, height;     /* of the picture, px */
    tp_fx    half_longest;      /* half the longest wave, m; 0: no waves */
    tp_fx    shortest;          /* twice the shortest wave, m */
    tp_fx    high, aside;       /* bounds of the waves' height and displacement, m */
    tp_fx    land;              /* height of the land near the eye, m; TP_FX_MIN: none */
    tp_fx    detail;            /* length of the rings' and pools' waves, m; 0: none */
    int64_t  detail_end;        /* largest distance of them along the heading, 16.16 m; 0
                                 * without them */
    const struct tp_fan_walls *walls;   /* the water ends at `sides`; NULL: it does not */
    tp_rectangle sides;
} tp_fan_view;

/* The law of the rows; u and its lengths are Q24. */
typedef struct {
    tp_dir3  right;             /* level unit vector along the rows, Q2.30 */
    tp_fx    height;            /* h, at least 1/2 m and what the waves need */
    tp_fx    last;              /* distance of the last row, m */
    tp_fx    farthest;          /* end of the water, m */
    tp_fx    wide;              /* half the width of the view per metre of depth */
    tp_fx    waves_end;         /* r*, m; TP_FX_MAX: every row keeps some waves */
    int32_t  start, dense;      /* u of the nearest row; length of u up to r* */
    int32_t  length;            /* of all rows */
    int32_t  tail;              /* beyond r* the spacing grows as r^(1 + tail) */
    uint32_t rows, cols;
    const struct tp_fan_walls *walls;   /* rows of a tank; NULL: others */
} tp_fan_law;

/* The rows of water that ends at walls, fan_tank.c. */
struct tp_fan_walls {
    tp_fan_law (*law)(const tp_fan_view *view, uint32_t vertices);
    tp_fan_row (*row)(const tp_fan_law *law, const tp_fan_view *view, uint32_t n);
    tp_fx (*end)(const tp_fan_law *law, const tp_fan_view *view);
};

#define TP_FAN_KEY 27           /* numbers that determine a law */

/* The numbers of a swell that the filter reads. */
typedef struct {
    int64_t turns_x, turns_z;
    tp_q30  slope_x, slope_z;
} tp_fan_swell;

/* Law, rows, visible cells and slope variance are kept between frames while the numbers
 * that determine them stay the same. */
typedef struct tp_fan {
    tp_fan_law  law;
    int32_t     law_for[TP_FAN_KEY];    /* its numbers; all 0: not solved yet */
    const tp_fan_row *row;      /* from the farthest to the nearest */
    tp_fan_row *placed;         /* the memory of the rows; NULL: they are baked */
    tp_fx       rows_for[3];    /* numbers of the rows beyond those of the law: the eye's x
                                 * and z, near */
    bool        moved;          /* true: placed with other rows than before */
    tp_fan_swell *filtered_for; /* swells of the slope variance */
    uint32_t    swells, most_swells;
    tp_fx       detail;         /* length of the rings' and pools' waves, m; 0: none */
    tp_fx       wind[TP_WAVES]; /* share of the horizontal motion left by the wind */
    uint32_t    vertices;       /* the budget */
    uint32_t    end_column;     /* the last column of a tank's rows, else none */
    tp_fx       end;            /* its place, the tank's side */
} tp_fan;

/* Blocks of cells of all rows, at most. */
#define TP_FAN_BLOCKS(vertices, rows) ((vertices) / TP_GRID_BLOCK + (rows))

/* Returns the largest number of columns and of rows for a budget of vertices. */
uint32_t tp_fan_most_cols(uint32_t vertices);
uint32_t tp_fan_most_rows(uint32_t vertices);

/* fan_view.c: returns the level direction of the rows, a unit vector.  A tank's rows lie
 * along x or z. */
tp_dir3 tp_fan_rows_direction(const tp_rotation *turn, bool walled);

#define TP_FAN_LAND_PLACES 5

/* Returns the places where land may come between the eye and the nearest water: under the
 * eye, and where the lowest rays of the picture's corners meet level water, at most four
 * heights away. */
void tp_fan_land_places(const tp_fan_view *view, tp_vec3 place[TP_FAN_LAND_PLACES]);

/* Raises the land of a view to a floor at so many metres below the level. */
static inline void tp_fan_widen_land(tp_fan_view *view, tp_fx depth)
{
    const tp_fx height = depth > TP_FX_MIN ? -depth : TP_FX_MAX;
    view->land = height > view->land ? height : view->land;
}

/* Raises the land of a view to the floor of coastal water at these places. */
void tp_fan_widen_to_floor(tp_fan_view *view, const tp_surface *surface);

/* Returns the numbers of a grid's view. */
tp_fan_view tp_fan_view_make(const tp_grid_view *view);

#define TP_FAN_WIDEST (22000 * TP_FX_ONE)   /* from the eye to a row's ends at most, m */

/* Range of distances along the heading, m. */
typedef struct {
    int64_t first, last;
} tp_fan_range;

/* Returns the distances of the water in view, up to +-last, for waves of +-highest. */
tp_fan_range tp_fan_visible_range(const tp_fan_view *view, tp_dir3 right, tp_fx highest,
                                  tp_fx last);

/* Returns half the width of the view per metre of depth, 16.16. */
tp_fx tp_fan_half_width_per_depth(const tp_fan_view *view, tp_dir3 right);

/* fan_law.c: solves the law for a view; returns row n of law->rows, from the nearest. */
tp_fan_law tp_fan_law_solve(const tp_fan_view *view, uint32_t vertices);

/* Solves the law again if a number that determines it has changed, and returns true then.
 * *law and its numbers are those of the last call, or the numbers are 0.  The eye's x and z
 * determine no law themselves, but the land under the eye and the end of rings and pools. */
bool tp_fan_law_update(tp_fan_law *law, int32_t made_for[TP_FAN_KEY],
                       const tp_fan_view *view, uint32_t vertices);
tp_fan_row tp_fan_law_row(const tp_fan_law *law, const tp_fan_view *view, uint32_t n);

/* fan_filter.c: returns the weight of a wave for a spacing: the share that points at this
 * distance hold, times the gain for linear interpolation; `turns` is Q0.32 turns per metre. */
tp_fx tp_fan_wave_weight(tp_fx spacing, int64_t turns);

/* Returns the weight of rings and pools in a row. */
tp_fx tp_fan_row_detail_weight(const tp_fan *fan, const tp_fan_row *row);

/* Returns the weight of a swell in a row, along times across.  The weight multiplies
 * heights, displacements and slopes. */
tp_fx tp_fan_row_weight(const tp_fan *fan, const tp_fan_row *row, const tp_swell *swell);

/* The same by quality.geometry: tp_fan_row_least returns the displacement, m, up to which a
 * row keeps nothing of a swell, 0 if all move vertices. */
static inline tp_fx tp_fan_row_least(const tp_grid *grid, const tp_fan_row *row)
{
    return grid->large ? grid->large->least(grid, row) : 0;
}

static inline tp_fx tp_fan_row_large_weight(const tp_grid *grid, const tp_fan_row *row,
                                            tp_fx least, const tp_swell *swell)
{
    const tp_fx weight = tp_fan_row_weight(grid->fan, row, swell);

    return least > 0 && weight != 0 ? tp_fx_mul(weight, grid->large->share(least, swell))
                                    : weight;
}

#define TP_FAN_GAIN (TP_FX_ONE * 7 / 4)     /* largest weight: 1.32 along and across */

/* Returns a weight without gain, for the Jacobian, which must not fold, and the variance. */
static inline tp_fx tp_fan_share(tp_fx weight)
{
    return weight < TP_FX_ONE ? weight : TP_FX_ONE;
}

/* Returns the weight of the slopes; the slopes of a wave too steep to exist stay below 2. */
static inline tp_fx tp_fan_slope_weight(const tp_swell *w, tp_fx weight)
{
    const int64_t most = tp_abs(w->slope_x) > tp_abs(w->slope_z) ? tp_abs(w->slope_x)
                                                                 : tp_abs(w->slope_z);
    return most * weight >> 16 < INT32_MAX
               ? weight : (tp_fx)tp_quotient((int64_t)INT32_MAX << 16, most);
}

/* fan_vertices.c: waves in a wind, for tp_water_coastal. */
void tp_fan_set_wind(struct tp_fan_wave *wave, const tp_coastal_water *coastal, tp_fx share,
                     uint32_t i);
tp_surface_point tp_fan_wind_point(const struct tp_fan_waves *waves, uint32_t i, tp_fx x,
                                   tp_fx z);

/* Returns the spacing of a row in wavelengths of deep water. */
tp_coastal_spacing tp_fan_row_spacing(const tp_fan *fan, const tp_fan_row *row,
                                      const tp_deep_water *deep);

/* Returns the slope variance of what a row does not show: of the waves that it leaves out,
 * and the share `unseen` of what interpolation along and across it loses. */
tp_slope_variance tp_fan_row_variance(const tp_grid *grid, const tp_fan_row *row,
                                      tp_fx unseen);

/* The slope variance of the rows, fan_filter.c.  Fills the variance of the rows placed last.
 * `filtered` keeps the variance if rows and swells are those of the last call; it must be
 * cleared or filled by the same fan. */
struct tp_draw_row_variance {
    void (*fill)(const tp_grid *grid, tp_filtered_waves *filtered);
};

void tp_fan_fill_variance(const tp_grid *grid, tp_filtered_waves *filtered);

/* fan_tank.c: the same for a tank; tp_fan_tank_end returns the place of the rows' end. */
tp_fan_law tp_fan_tank_law(const tp_fan_view *view, uint32_t vertices);
tp_fan_row tp_fan_tank_row(const tp_fan_law *law, const tp_fan_view *view, uint32_t n);
tp_fx tp_fan_tank_end(const tp_fan_law *law, const tp_fan_view *view);

/* grid.c: evaluates vertices first to end - 1 of row j: into vertex[first] and on; into to[0]
 * and on before projection, with slopes of 0. */
void tp_fan_evaluate_row(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                         tp_grid_vertex *vertex);
void tp_fan_make_view_vertices(const tp_grid *grid, uint32_t j, uint32_t first, uint32_t end,
                               tp_view_vertex *to);

/* Returns first + i step; the product alone may be out of range. */
static inline tp_fx tp_fan_place(tp_fx first, tp_fx step, uint32_t i)
{
    return (tp_fx)((uint32_t)first + i * (uint32_t)step);
}

/* Return the rest position of a row's vertex along x and z.  A step in a tank has less
 * precision than the tank's side. */
static inline tp_fx tp_fan_x(const tp_fan *fan, const tp_fan_row *row, uint32_t i)
{
    return i == fan->end_column && row->step_x != 0 ? fan->end
                                                    : tp_fan_place(row->x, row->step_x, i);
}

static inline tp_fx tp_fan_z(const tp_fan *fan, const tp_fan_row *row, uint32_t i)
{
    return i == fan->end_column && row->step_z != 0 ? fan->end
                                                    : tp_fan_place(row->z, row->step_z, i);
}

/* The same for a vertex of the grid. */
static inline tp_fx tp_grid_s(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return tp_fan_x(grid->fan, &grid->fan->row[j], i);
}

static inline tp_fx tp_grid_t(const tp_grid *grid, uint32_t i, uint32_t j)
{
    return tp_fan_z(grid->fan, &grid->fan->row[j], i);
}

/* fan.c: places the rows; sets the number of rows and columns, and the visible cells. */
void tp_fan_place_rows(tp_grid *grid, const tp_grid_view *view);

#endif
