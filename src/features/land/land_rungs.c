/* SPDX-License-Identifier: MIT */
/* Cost estimate of land, a sea floor above the level, as land_drawing.c draws it.  A row
 * of cells counts once for each tile touched.  In a row every cell counts, except cells
 * with all corners below the deepest trough or all behind the near plane. */
#include "base/base.h"
#include "features/land/land.h"
#include "quality/prices.h"
#include "view/fan.h"
#include "view/projection.h"
#include "waves/coastal_tables.h"

#define KEPT_RATE TP_FX(0.1)    /* same value as in waves/coastal_tables.c */

/* Returns the highest crest of a wave over a shoaling floor, m, with the bound of
 * waves/coastal_water.c: the wave grows, its orbit tilts with the floor, its crest is
 * thrown.  Over a map the mean rise counts and no crest is thrown. */
static tp_fx bound_crest_height(const tp_scene *s, const tp_wave *given, tp_fx floor_slope)
{
    const tp_fx   slope = tp_clamp(floor_slope, 0, TP_FX_ONE);
    const tp_wave held = {
        .amplitude = tp_clamp(given->amplitude, 1, 16 * TP_FX_ONE),
        .length = tp_clamp(given->length, TP_FX(0.25), TP_FX(2000)),
        .steepness = tp_clamp(given->steepness, 0, TP_FX_ONE),
    };
    const tp_wave *wave = &held;
    const int64_t k_inf = tp_depth_wave_number_deep(wave->length);
    const tp_breaker_type type = tp_breaker_classify(
        tp_iribarren(slope * (1 << 14), 2 * wave->amplitude, wave->length));
    const bool throws = type == TP_BREAKER_PLUNGING && !s->floor.map[0];
    const int64_t lips = throws ? 3 * (int64_t)s->surf.stretch : 0;
    int64_t highest = wave->amplitude;

    for (uint32_t n = 1; n < TP_COASTAL_DEPTHS - 8; n += 4) {
        const tp_fx   h = tp_coastal_node_depth(n, 3);
        const int64_t k = tp_coastal_local_wave_number(k_inf, h);
        const tp_fx a = tp_depth_amplitude(
            wave->amplitude, tp_depth_shoaling_factor(k_inf, k, h), TP_FX_ONE, h);
        const tp_orbit_scale sc = tp_orbit_scale_make(h, s->surf.widening_decay,
                                                      s->surf.flattening_decay);
        const int64_t most = ((int64_t)TP_FX(0.95) << 32) / k;
        const int64_t reach = ((int64_t)wave->steepness << 32) / k_inf;
        const int64_t round = reach * a / wave->amplitude * (sc.x_q24 >> 8) >> 16;
        const int64_t along = round < most ? round : most;
        const int64_t tilt =
            (along * slope >> 16) * (tp_orbit_depth_decay(s->surf.tilt_decay, h) >> 16)
            >> 16;
        const int64_t lip =
            4 * (int64_t)a > h
                ? ((int64_t)a * tp_orbit_depth_decay(KEPT_RATE, h) >> 32) * lips >> 16
                : 0;
        const int64_t high = ((int64_t)a * (sc.y_q24 >> 8) >> 16) + tilt + lip;
        highest = high > highest ? high : highest;
    }
    return tp_fx_saturate(highest);
}

typedef struct {
    const tp_scene *scene;
    tp_floor floor;
    tp_projection projection;
    tp_fan_view view;
    tp_fan_law  law;            /* of the rows */
    tp_fan_row  line[2];        /* the selected row and the next */
    int32_t  lines, columns;    /* lines of the grid */
    int64_t  deepest;           /* deepest floor exposed by a trough, m, Q16 */
    int32_t  cols, rows;        /* size of the picture, px */
} land_ground;

static tp_floor make_floor(const tp_site *w)
{
    const tp_scene *s = w->scene;

    return (tp_floor){ .depth = s->floor.depth, .slope = s->floor.slope,
                       .heading = s->floor.heading, .map = w->assets->floor,
                       .map_x = s->floor.map_x, .map_z = s->floor.map_z,
                       .map_size = s->floor.map_size, .map_low = s->floor.map_low,
                       .map_high = s->floor.map_high };
}

/* A projected corner of a cell. */
typedef struct {
    bool    deep, behind, cut;
    int32_t u, v;
} cost_corner;

static int64_t sample_depth(const land_ground *g, int64_t x, int64_t z)
{
    return tp_floor_sample(&g->floor, tp_fx_saturate(x), tp_fx_saturate(z)).depth;
}

/* Returns the floor's steepest rise.  A map is sampled on a lattice of 64 x 64, with
 * differences over two lattice cells, because coastal water smooths the map. */
static tp_fx floor_steepest_slope(const land_ground *g)
{
    const tp_scene *s = g->scene;
    const int64_t d = s->floor.map_size / 64;
    int64_t most = 0;

    if (!g->floor.map || d <= 0)
        return s->floor.slope;
    for (int64_t n = 0; n < 64 * 64; n++) {
        const int64_t x = s->floor.map_x + s->floor.map_size * (2 * (n % 64) - 63) / 128;
        const int64_t z = s->floor.map_z + s->floor.map_size * (2 * (n / 64) - 63) / 128;
        const int64_t over_x = sample_depth(g, x + d, z) - sample_depth(g, x - d, z);
        const int64_t over_z = sample_depth(g, x, z + d) - sample_depth(g, x, z - d);
        const int64_t rise = over_x * over_x + over_z * over_z;
        most = rise > most ? rise : most;
    }
    return (tp_fx)((int64_t)tp_isqrt64((uint64_t)most) * TP_FX_ONE / (2 * d));
}

/* -- places of the grid's lines ------------------------------------------------------ */

static tp_fx longest_wave(const tp_scene *s, tp_fx *shortest)
{
    tp_fx longest = 0;

    *shortest = TP_FX_MAX;
    for (int i = 0; i < TP_WAVES; i++) {
        const tp_fx length = s->wave[i].length;
        if (s->wave[i].amplitude <= 0)
            continue;
        longest = length > longest ? length : longest;
        *shortest = length < *shortest ? length : *shortest;
    }
    return longest;
}

/* Sets the grid's rows by the law of the fan. */
static void set_lines(land_ground *g)
{
    const tp_scene *s = g->scene;
    tp_fx shortest;
    const tp_fx longest = longest_wave(s, &shortest);

    g->view = (tp_fan_view){
        .projection = &g->projection, .width = (uint32_t)g->cols,
        .height = (uint32_t)g->rows, .half_longest = longest / 2,
        .shortest = shortest < TP_FX_MAX / 2 ? 2 * shortest : shortest,
        .high = tp_fx_saturate(g->deepest - TP_FX_ONE),
        .aside = tp_fx_saturate(g->deepest - TP_FX_ONE),
        .land = TP_FX_MIN,
    };
    tp_vec3 place[TP_FAN_LAND_PLACES];
    tp_fan_land_places(&g->view, place);
    for (int k = 0; k < TP_FAN_LAND_PLACES; k++)
        tp_fan_widen_land(&g->view,
                          tp_fx_saturate(sample_depth(g, place[k].x, place[k].z)));
    g->law = tp_fan_law_solve(&g->view, tp_fan_budget(s));
    g->columns = (int32_t)g->law.cols;
    g->lines = (int32_t)g->law.rows;
}

/* Selects the lines on both sides of a row of cells. */
static void select_row(land_ground *g, int32_t j)
{
    for (int k = 0; k < 2; k++)
        g->line[k] = tp_fan_law_row(&g->law, &g->view, g->law.rows - 1 - (uint32_t)(j + k));
}

/* Returns the rest position of column i of the selected line or, with `next`, of the
 * line behind it. */
static tp_vec3 line_place(const land_ground *g, int32_t i, int next)
{
    const tp_fan_row *row = &g->line[next];

    return (tp_vec3){ tp_fan_place(row->x, row->step_x, (uint32_t)i), 0,
                      tp_fan_place(row->z, row->step_z, (uint32_t)i) };
}

static cost_corner project_corner(const land_ground *g, int32_t i, int next)
{
    const tp_vec3 rest = line_place(g, i, next);
    const tp_floor_at at = tp_floor_sample(&g->floor, rest.x, rest.z);
    const tp_vec3 place = { rest.x, tp_fx_saturate(-(int64_t)at.depth), rest.z };
    tp_view_vertex c;
    uint32_t zi;

    tp_projection_view_vertex(
        &g->projection,
        tp_vec3_add(g->projection.eye,
                    tp_start_view_clamped_vector(g->projection.eye, place)),
        &c);
    cost_corner to = { at.depth > g->deepest, c.depth < g->projection.near,
                       !tp_projection_can_project(&g->projection, &c), 0, 0 };
    if (!to.cut)
        tp_projection_project(&g->projection, &c, &to.u, &to.v, &zi);
    return to;
}

/* Counts for a row of cells. */
typedef struct {
    uint32_t tries, cuts;       /* uncut cells; partly cut */
    uint32_t seen;              /* cells in view, with breaking waves */
    uint64_t drawn, fill;       /* cells with a pixel, once per tile, Q8; filled pixels */
    int32_t  top, bottom;       /* pixel rows touched */
} strip;

static int32_t least(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static int32_t most(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* Counts an uncut cell in view.  If the cell faces the camera, its fill is counted too;
 * the cross product of its diagonals is twice its area. */
static void count_visible_cell(const land_ground *g, strip *to, const cost_corner p[4])
{
    const int64_t area = ((int64_t)p[3].v - p[0].v) * ((int64_t)p[2].u - p[1].u)
                       - ((int64_t)p[3].u - p[0].u) * ((int64_t)p[2].v - p[1].v);
    const int32_t left = least(least(p[0].u, p[1].u), least(p[2].u, p[3].u)) >> 4;
    const int32_t right = most(most(p[0].u, p[1].u), most(p[2].u, p[3].u)) >> 4;
    const int32_t top = least(least(p[0].v, p[1].v), least(p[2].v, p[3].v)) >> 4;
    const int32_t low = most(most(p[0].v, p[1].v), most(p[2].v, p[3].v)) >> 4;
    const int64_t across = most(left, 0) < least(right, g->cols)
                         ? least(right, g->cols) - most(left, 0) : 0;
    const int64_t down = most(top, 0) < least(low, g->rows)
                       ? least(low, g->rows) - most(top, 0) : 0;
    const int64_t whole = ((int64_t)right - left + 1) * ((int64_t)low - top + 1);

    if (right < 0 || low < 0 || left >= g->cols || top >= g->rows)
        return;
    to->seen++;
    if (area <= 0)
        return;
    to->drawn += (uint64_t)(area < 512 ? area / 2 : 256)
               * (uint64_t)(TP_WORK_BAND + down) / TP_WORK_BAND;
    to->fill += (uint64_t)(area / 512 * (across + 1) * (down + 1) / whole);
}

static void count_cell(const land_ground *g, strip *to, const cost_corner p[4])
{
    const bool cut = p[0].cut || p[1].cut || p[2].cut || p[3].cut;
    const bool none = p[0].cut && p[1].cut && p[2].cut && p[3].cut;

    if ((p[0].deep && p[1].deep && p[2].deep && p[3].deep)
        || (p[0].behind && p[1].behind && p[2].behind && p[3].behind))
        return;
    to->tries += !cut;
    to->cuts += cut && !none;
    if (!cut)
        count_visible_cell(g, to, p);
    for (int k = 0; k < 4; k++) {
        const int32_t low = cut ? INT16_MIN : p[k].v >> 4;
        const int32_t high = cut ? INT16_MAX : p[k].v >> 4;
        to->top = low < to->top ? low : to->top;
        to->bottom = high > to->bottom ? high : to->bottom;
    }
}

static strip measure_strip(land_ground *g, int32_t j)
{
    select_row(g, j);
    strip to = { 0, 0, 0, 0, 0, INT32_MAX, INT32_MIN };
    cost_corner left[2] = { project_corner(g, 0, 0), project_corner(g, 0, 1) };

    for (int32_t i = 0; i + 1 < g->columns; i++) {
        const cost_corner right[2] = { project_corner(g, i + 1, 0),
                                       project_corner(g, i + 1, 1) };
        const cost_corner all[4] = { left[0], left[1], right[0], right[1] };
        count_cell(g, &to, all);
        left[0] = right[0];
        left[1] = right[1];
    }
    return to;
}

static uint32_t count_tiles(const land_ground *g, const strip *s)
{
    const int32_t top = s->top < 0 ? 0 : s->top;
    const int32_t bottom = s->bottom < g->rows ? s->bottom : g->rows - 1;

    return top > bottom ? 0
         : (uint32_t)(bottom / TP_WORK_BAND - top / TP_WORK_BAND + 1);
}

static void count_work(tp_site *w)
{
    const tp_scene *s = w->scene;
    land_ground g = { .scene = s, .floor = make_floor(w),
                 .deepest = TP_FX_ONE, .cols = (int32_t)w->width,
                 .rows = (int32_t)w->height };
    uint64_t drawn = 0;

    const tp_fx slope = floor_steepest_slope(&g);
    for (int i = 0; i < TP_WAVES; i++)
        g.deepest +=
            s->wave[i].amplitude > 0 ? bound_crest_height(s, &s->wave[i], slope) : 0;
    tp_projection_init_turned(&g.projection, w->at.eye, w->at.turn, s->camera.fov,
                              s->camera.near, w->width, w->height);
    set_lines(&g);
    for (int32_t j = 0; j + 1 < g.lines; j++) {
        const strip row = measure_strip(&g, j);
        const uint32_t tiles = count_tiles(&g, &row);
        w->fixed_cost.of[TP_WORK_land_row] += tiles * (uint32_t)(g.columns - 1);
        w->fixed_cost.of[TP_WORK_land_cell] += tiles * row.tries;
        w->fixed_cost.of[TP_WORK_land_cut] += tiles * row.cuts;
        w->fixed_cost.of[TP_WORK_surf] += row.seen;
        w->fixed_cost.of[TP_WORK_land_fill] += (uint32_t)row.fill;
        drawn += row.drawn;
    }
    w->fixed_cost.of[TP_WORK_land_drawn] = (uint32_t)(drawn >> 8);
}

/* True if the floor is above the level at the point, `far` m ahead, where the ray would
 * meet the water. */
static bool is_ray_stopped(const tp_site *w, tp_vec3 ray, int64_t far)
{
    const tp_floor floor = make_floor(w);
    const tp_fx x = tp_fx_saturate(w->at.eye.x + (far * ray.x >> 16));
    const tp_fx z = tp_fx_saturate(w->at.eye.z + (far * ray.z >> 16));

    return !tp_has_tank(w->scene) && tp_floor_sample(&floor, x, z).depth <= 0;
}

static void count_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    w->fixed_cost.of[TP_WORK_land] = tp_work_ray_pixels(w, px->stopped);
}

const tp_cost tp_land_cost = { .work = count_work,
                               .stops = is_ray_stopped,
                               .pixels = count_pixel_work };
