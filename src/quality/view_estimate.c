/* SPDX-License-Identifier: MIT */
/* The view estimate: what the start camera of a scene sees.  Water pixels are counted by
 * a lattice of rays against level water, grid vertices by a lattice of points on the
 * grid.  The span stages of these pixels come from the modules, asked as a frame asks
 * them.  Water behind the boat, drops and the tank is counted as visible. */
#include "quality/prices.h"
#include "view/grid.h"
#include "waves/coastal_tables.h"
#include "world/light.h"
#include "world/module.h"
#include "world/pools.h"

#define RAYS   32               /* rays along each axis of the picture */
#define BAND   16               /* rows of a tile, as a board draws */
#define POINTS (1 << 20)        /* largest number of points */
#define SPOTS  32               /* points of the grid along each axis */

/* -- pixels -------------------------------------------------------------------------- */

static uint32_t count_water_rays(const tp_start_view *at)
{
    uint32_t seen = 0;

    for (int32_t j = 0; j < RAYS; j++)
        for (int32_t i = 0; i < RAYS; i++)
            seen += tp_start_view_water_distance_ahead(
                        at, at->wide * (2 * i + 1 - RAYS) / RAYS,
                        at->high * (2 * j + 1 - RAYS) / RAYS)
                    > 0;
    return seen;
}

/* -- vertices ------------------------------------------------------------------------ */

/* Returns the coordinate of the n-th of SPOTS points on an axis of `lines` lines. */
static int64_t grid_point_coordinate(const tp_scene *s, int32_t lines, int64_t centre,
                                     int32_t n)
{
    return tp_start_view_grid_line_place(s, lines, centre,
                              (int64_t)(lines - 1) * (2 * n + 1 - SPOTS) * 32768 / SPOTS);
}

/* Grid points in view, and the number of their cells that get a pixel, Q8. */
typedef struct {
    uint32_t spots, drawn;
} viewed;

/* Returns the share, Q8, of level cells at a depth that get a pixel.  The image of a cell
 * has the area of the cell times focal^2 height / depth^3.  A cell counts once for each
 * tile that its rows touch. */
static uint32_t share_of_cells_with_pixels(const tp_start_view *at, const tp_scene *s,
                                           int32_t focal, int64_t depth)
{
    const int64_t height = tp_abs(at->eye.y);

    if (depth <= s->grid.cell)
        return 512;
    const int64_t side = tp_clamp_abs((int64_t)focal * s->grid.cell * 256 / depth, 1 << 20);
    const int64_t steep = tp_clamp_abs(height * 256 / depth, 1024);
    const int64_t area = side * side * steep >> 16, rows = side * steep >> 8;
    return (uint32_t)((area < 256 ? area : 256) * (256 + rows / BAND) >> 8);
}

/* Counts a grid point inside the picture, with a margin for its neighbours and crests.
 * Distances are limited to 8 km. */
static void count_grid_point_if_visible(viewed *to, const tp_start_view *at,
                                        const tp_scene *s, int32_t focal, int64_t x,
                                        int64_t z)
{
    const int64_t most = 1 << 29;
    const tp_vec3 v =
        tp_rotate(&at->turn, (tp_vec3){ (tp_fx)tp_clamp_abs(x - at->eye.x, most),
                                        (tp_fx)tp_clamp_abs(-(int64_t)at->eye.y, most),
                                        (tp_fx)tp_clamp_abs(z - at->eye.z, most) });
    const int64_t room = 2 * (int64_t)s->grid.cell;
    const int64_t wide = (-v.z * at->wide >> 16) + room;
    const int64_t high = (-v.z * at->high >> 16) + room;

    if (-v.z > -room && tp_abs(v.x) <= wide && tp_abs(v.y) <= high) {
        to->spots++;
        to->drawn += share_of_cells_with_pixels(at, s, focal, -v.z);
    }
}

static viewed count_visible_grid_points(const tp_start_view *at, const tp_scene *s,
                                        int32_t focal)
{
    viewed all = { 0, 0 };

    for (int32_t j = 0; j < SPOTS; j++) {
        const int64_t z = grid_point_coordinate(s, s->grid.rows, at->z, j);
        for (int32_t i = 0; i < SPOTS; i++)
            count_grid_point_if_visible(
                &all, at, s, focal, grid_point_coordinate(s, s->grid.cols, at->x, i), z);
    }
    return all;
}

/* -- points of a lattice over the picture -------------------------------------------- */

/* Lines of the screen grid (frame/screen_grid.c) in the first `rows` rows below the
 * horizon: every row, then every 2nd, then every 4th. */
static int64_t count_screen_grid_lines(int64_t rows)
{
    return rows > 64 ? 48 + (rows - 64) / 4 : rows > 32 ? 32 + (rows - 32) / 2
         : rows > 0 ? rows : 0;
}

/* Returns the number of rows from the horizon to the lower edge of the picture. */
static int64_t count_rows_below_horizon(const tp_start_view *at, int32_t focal,
                                        uint32_t height)
{
    const int64_t up = at->turn.y.y > 1 << 20
                     ? (int64_t)focal * at->turn.z.y / at->turn.y.y : 4096;
    return tp_clamp_abs(up + height / 2, 4096);
}

/* Counts the points of tiles of BAND rows.  Each tile walks again the lines that waves of
 * this height may raise into it. */
static uint32_t projected_points(const tp_start_view *at, int32_t focal,
                                 int64_t wave_height, uint32_t width, uint32_t height)
{
    const int64_t below = count_rows_below_horizon(at, focal, height), eye = at->eye.y;
    int64_t lines = 0;

    if (eye <= wave_height)
        return 0;
    for (int64_t low = below; low > 0 && low > below - height; low -= BAND) {
        const int64_t first = low * eye / (eye - wave_height) + (wave_height > 0 ? 8 : 4);
        const int64_t last = (low - BAND) * eye / (eye + wave_height);
        lines += count_screen_grid_lines(first) - count_screen_grid_lines(last) + 1;
    }
    return (uint32_t)tp_clamp_abs(lines * (width / 8 + 5), POINTS);
}

/* Counts every 8th pixel of every 8th row, if the water has waves. */
static uint32_t flat_points(const tp_start_view *at, int32_t focal, int64_t wave_height,
                            uint32_t width, uint32_t height)
{
    const int64_t below = count_rows_below_horizon(at, focal, height);
    const int64_t rows = below < height ? below : height;

    return wave_height > 0 && rows > 0 ? (uint32_t)((rows / 8 + 1) * (width / 8 + 1)) : 0;
}

static void set_points_per_renderer(tp_view_estimate *o, const tp_start_view *at,
                                    int64_t wave_height, uint32_t width, uint32_t height)
{
    o->points[TP_VISIBILITY_TRIANGLES - 1] = o->vertices;
    o->points[TP_VISIBILITY_ROWS - 1] = o->vertices;
    o->points[TP_VISIBILITY_PROJECTED - 1] =
        projected_points(at, o->focal, wave_height, width, height);
    o->points[TP_VISIBILITY_FLAT - 1] =
        flat_points(at, o->focal, wave_height, width, height);
}

/* -- renderers that can draw the view ------------------------------------------------ */

#define FOLDS    (TP_FX_ONE * 9 / 10)   /* limits of the sum, as in frame/scanline_grid.c */
#define STEEPENS (TP_FX_ONE * 3 / 4)

/* True if lines keep their order along a ray.  Sums the bend along the lines minus t
 * times the bend across the lines.  Steepness is scaled to a sum of at most 0.95. */
static bool is_line_order_kept(const tp_scene *s, bool coastal, tp_dir3 lines,
                               int64_t slant)
{
    const int64_t x = lines.x >> 14, z = lines.z >> 14;
    int64_t sum = 0, steepness = 0;

    for (int i = 0; i < TP_WAVES; i++) {
        const tp_wave *w = &s->wave[i];
        const tp_dir3  d = tp_rotation_from_angles(tp_turn_of_degrees(w->heading), 0, 0).x;
        const int64_t  k = ((d.x >> 14) * x + (d.z >> 14) * z) >> 16;
        const int64_t  m = ((d.z >> 14) * x - (d.x >> 14) * z) >> 16;
        const int64_t  bend = (m * m + (slant * m >> 16) * k) >> 16;
        if (w->amplitude <= 0)
            continue;
        sum += (bend < 0 ? -bend : bend) * w->steepness >> 16;
        steepness += w->steepness;
    }
    if (steepness > TP_FX(0.95))
        sum = sum * TP_FX(0.95) / steepness;
    return sum < (coastal ? STEEPENS : FOLDS);
}

/* True if the rays of all four corners of the picture lead away across the lines and meet
 * the lines in order; frame/scanline_grid.c has the rule. */
static bool is_rows_renderer_usable(const tp_scene *s, bool coastal,
                                    const tp_start_view *at)
{
    const bool fan = tp_has_fan(s);
    const bool behind = fan || at->turn.z.z > 0;
    const tp_dir3 lines = fan ? at->turn.x : (tp_dir3){ TP_Q30_ONE, 0, 0 };

    for (int corner = 0; corner < 4; corner++) {
        tp_vec3 ray = tp_start_view_ray(at, corner & 1 ? at->wide : -at->wide,
                                        corner & 2 ? at->high : -at->high);
        if (fan)
            ray = (tp_vec3){ (tp_fx)tp_dot_dir(ray, lines), 0,
                             tp_dot_dir(ray, (tp_dir3){ -lines.z, 0, lines.x }) };
        const int64_t across = (int64_t)ray.z * (behind ? -1 : 1);
        const int64_t along = (int64_t)ray.x * (behind ? -1 : 1);
        if (across < 256 || (along < 0 ? -along : along) >= 3 * across
            || !is_line_order_kept(s, coastal, lines, along * TP_FX_ONE / across))
            return false;
    }
    return true;
}

/* Returns the metres along the lines for each metre across them, straight ahead. */
static tp_fx view_slant_to_grid_lines(const tp_start_view *at)
{
    const int64_t x = tp_abs(at->turn.z.x), z = tp_abs(at->turn.z.z);

    return x < 3 * z ? (tp_fx)(x * TP_FX_ONE / z) : TP_FX(3);
}

/* Sets the grid's vertices, and its cells that get a pixel.  A fan covers little more than
 * the view, with cells as large as pixels or larger. */
static void set_grid_size(tp_view_estimate *o, const tp_start_view *at, const tp_scene *s)
{
    if (tp_has_fan(s)) {
        o->vertices = o->drawn = tp_fan_budget(s) * 9 / 10;
        return;
    }
    const viewed spots = count_visible_grid_points(at, s, o->focal);
    const uint64_t crossings = (uint64_t)s->grid.cols * (uint64_t)s->grid.rows;

    o->vertices = (uint32_t)(crossings * spots.spots / (SPOTS * SPOTS));
    o->drawn = (uint32_t)(crossings * spots.drawn / (256 * SPOTS * SPOTS));
}

/* Lists the water renderers that fit the view.  The frame decides by its own camera; the
 * estimate uses the scene's camera and is slightly stricter. */
static void set_usable_renderers(tp_view_estimate *o, const tp_scene *s,
                                 const tp_start_view *at, int64_t wave_height, bool ahead)
{
    const bool over = at->eye.y > wave_height + TP_FX_ONE / 8;
    const bool swell = over && !o->coastal && !o->stirred;

    o->fits[TP_VISIBILITY_TRIANGLES - 1] = 1;
    o->fits[TP_VISIBILITY_ROWS - 1] =
        over && ahead && is_rows_renderer_usable(s, o->coastal, at)
        && !(o->coastal
             && tp_can_overhang(s->surf.stretch, s->floor.slope, s->floor.map[0]));
    o->fits[TP_VISIBILITY_PROJECTED - 1] =
        swell && ahead && wave_height < at->eye.y * 3 / 4;
    o->fits[TP_VISIBILITY_FLAT - 1] = swell;
}

/* -- the stages of water ------------------------------------------------------------- */

/* Records the enabled modules that raise the water's surface.  Their conditions do not
 * depend on other modules. */
static void record_surface_modules(tp_view_estimate *o, const tp_use *modules,
                                   const tp_module_conditions *conditions)
{
    for (const tp_use *u = modules; u && u->module; u++) {
        const tp_module *m = u->module;
        if (!m->surface || !m->enabled(conditions))
            continue;
        if (m->is & TP_MODULE_COASTAL)
            o->coastal = 1;
        else if (m->id == TP_POOL_ID || m->id == TP_FIELD_ID)
            o->pools++;
        else
            o->rings = 1;
    }
    o->stirred = o->pools > 0 || o->rings;
}

/* Records the enabled modules that are drawn.  Pools drawn only as slopes do not raise
 * the grid. */
static void record_drawn_modules(tp_view_estimate *o, const tp_use *modules,
                                 tp_module_conditions conditions)
{
    for (const tp_use *u = modules; u && u->module; u++) {
        if (!u->drawing || !tp_module_ask_enabled(u->module, &conditions))
            continue;
        o->trait[u->module->trait] = 1;
        if (u->module->count)
            u->module->count(&conditions, o->trait);
    }
    if (!o->trait[TP_TRAIT_mirror])             /* the sky is not reflected */
        o->trait[TP_TRAIT_dome] = o->trait[TP_TRAIT_cube] = 0;
    o->modules = conditions.above;
    if (o->modules & TP_MODULE_SLOPES)
        o->pools = 0;
}

/* Returns the gloss class of the specular lobe.  The steepest slope of the lobe is about
 * its height times the square root of its exponent. */
static int gloss_class(const tp_scene *s)
{
    const int64_t square = (int64_t)s->water.specular * s->water.specular >> 16;

    return s->water.specular <= 0 ? 0
         : square * s->water.shininess >> 16 > 144 * TP_FX_ONE ? 2 : 1;
}

/* Classifies the sea by the sum of k A: a sum up to 1/4 is gentle; pools and rings are
 * gentle too. */
static void classify_sea(tp_view_estimate *o, const tp_scene *s)
{
    int64_t slope = 0;

    for (int i = 0; i < TP_WAVES; i++) {
        if (s->wave[i].amplitude <= 0)
            continue;
        slope += (int64_t)s->wave[i].amplitude * 411775 / s->wave[i].length;    /* 2 pi */
        o->waves++;
    }
    const int most = o->coastal ? TP_SEA_COASTAL : TP_SEA_STEEP;
    const int steep = slope > TP_FX_ONE / 4 ? most
                    : slope > 0 || o->stirred ? TP_SEA_GENTLE : TP_SEA_LEVEL;
    o->sea = (uint8_t)(steep + gloss_class(s));
}

static void set_wave_flags(tp_view_estimate *o, const tp_scene *s)
{
    const bool raised = o->pools > 0 || o->rings || o->coastal;

    for (int i = 0; i < TP_WAVES; i++)
        o->sharp |= s->wave[i].amplitude > 0 && s->wave[i].exponent > 1;
    o->still = o->waves == 0 && !raised;
}

/* -- the estimate -------------------------------------------------------------------- */

tp_module_conditions tp_plan_module_conditions(const tp_plan_input *in)
{
    return (tp_module_conditions){
        .scene = in->scene, .assets = in->assets, .width = in->width, .height = in->height,
        .shadings = UINT32_MAX,
    };
}

tp_view_estimate tp_view_estimate_make(const tp_plan_input *in)
{
    const tp_scene  *scene = in->scene;
    const tp_assets *assets = in->assets;
    const uint32_t   width = in->width, height = in->height;
    TP_ASSERT(scene->grid.cols >= 2 && scene->grid.rows >= 2);
    const tp_module_conditions conditions = tp_plan_module_conditions(in);
    const tp_start_view at = tp_start_view_make(scene, width, height);
    const uint64_t pixels = (uint64_t)width * height;
    const tp_vec3 low = tp_start_view_ray(&at, 0, -at.high);
    const int64_t ahead = (int64_t)low.x * -at.turn.z.x + (int64_t)low.z * -at.turn.z.z;
    tp_view_estimate o = { .focal = (int32_t)(((int64_t)height << 15) / at.high) };
    int64_t waves = 0;

    o.water_pixels = (uint32_t)(pixels * count_water_rays(&at) / (RAYS * RAYS));
    o.other_pixels = (uint32_t)pixels - o.water_pixels;
    set_grid_size(&o, &at, scene);
    record_surface_modules(&o, in->modules, &conditions);
    o.trait[TP_TRAIT_plain] = 1;
    record_drawn_modules(&o, in->modules, conditions);
    o.quick = (o.modules & TP_MODULE_FAST) != 0;
    classify_sea(&o, scene);
    o.floor = (uint8_t)(tp_has_floor(scene) + (tp_has_floor(scene) && assets->floor));
    o.slant = tp_has_fan(scene) ? 0 : view_slant_to_grid_lines(&at);
    set_wave_flags(&o, scene);
    for (int i = 0; i < TP_WAVES; i++)
        waves += scene->wave[i].amplitude > 0 ? scene->wave[i].amplitude : 0;
    o.near = tp_nearest_water_distance(tp_fx_saturate(at.eye.y - waves), &at.turn,
                                       scene->camera.fov);
    set_points_per_renderer(&o, &at, waves, width, height);
    set_usable_renderers(&o, scene, &at, waves, low.y >= 0 || ahead > 0);
    return o;
}
