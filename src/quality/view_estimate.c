/* SPDX-License-Identifier: MIT */
/* The view estimate: what the start camera of a scene sees.  Water pixels are counted by
 * a lattice of rays against level water.  The span stages of these pixels come from the
 * modules, asked as a frame asks them.  Water behind the boat, drops and the tank is
 * counted as visible. */
#include "quality/prices.h"
#include "view/fan.h"
#include "view/grid.h"
#include "waves/coastal_tables.h"
#include "world/light.h"
#include "world/module.h"
#include "world/pools.h"

#define RAYS   32               /* rays along each axis of the picture */
#define BAND   16               /* rows of a tile, as a board draws */
#define POINTS (1 << 20)        /* largest number of points */

/* -- pixels -------------------------------------------------------------------------- */

/* Returns the square of the part of a colour that haze leaves at a distance z, Q16 m:
 * h^2 / (z^2 + h^2), see features/sky/haze_stage.c. */
static uint32_t square_left_by_haze(int64_t z, tp_fx h)
{
    const int64_t ratio = (z << 8) / h, most = 1 << 15;         /* 128, Q8 */
    const int64_t r = ratio < most ? ratio : most;
    const uint32_t left = (uint32_t)(((int64_t)1 << 32) / (TP_FX_ONE + r * r));

    return (uint32_t)((uint64_t)left * left >> 16);
}

/* Counts the rays that meet water, of RAYS x RAYS, and averages what haze leaves of it. */
static uint32_t count_water_rays(const tp_scene *scene, const tp_start_view *at,
                                 tp_fx *unhazed)
{
    uint32_t seen = 0;
    uint64_t left = 0;

    for (int32_t j = 0; j < RAYS; j++)
        for (int32_t i = 0; i < RAYS; i++) {
            const int64_t z = tp_start_view_water_distance_ahead(
                at, at->wide * (2 * i + 1 - RAYS) / RAYS,
                at->high * (2 * j + 1 - RAYS) / RAYS);
            seen += z > 0;
            if (z > 0 && scene->sky.haze > 0)
                left += square_left_by_haze(z, scene->sky.haze);
        }
    *unhazed = seen > 0 && scene->sky.haze > 0 ? (tp_fx)(left / seen) : TP_FX_ONE;
    return seen;
}

/* Returns the part of the grid's vertices in view, 256ths: a basin's grid covers its water,
 * every other grid the view.  Tests 16 x 16 points of the level. */
static uint16_t count_vertices_in_view(const tp_scene *scene, const tp_start_view *at)
{
    const tp_rectangle *r = &at->water;
    uint32_t seen = 0;

    if (!tp_is_walled(scene))
        return 256;
    for (int32_t i = 0; i < 256; i++) {
        const int64_t x = r->x0 + ((int64_t)r->x1 - r->x0) * (2 * (i & 15) + 1) / 32;
        const int64_t z = r->z0 + ((int64_t)r->z1 - r->z0) * (2 * (i >> 4) + 1) / 32;
        const tp_vec3 way = tp_start_view_clamped_vector(
            at->eye, (tp_vec3){ tp_fx_saturate(x), 0, tp_fx_saturate(z) });
        const tp_vec3 v = tp_rotate(&at->turn, way);
        const int64_t wide = -at->wide * v.z >> 16, high = -at->high * v.z >> 16;
        seen += v.z < 0 && v.x <= wide && v.x >= -wide && v.y <= high && v.y >= -high;
    }
    return (uint16_t)seen;
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
    const tp_dir3 lines = tp_fan_rows_direction(&at->turn, tp_is_walled(s));

    for (int corner = 0; corner < 4; corner++) {
        const tp_vec3 ray = tp_start_view_ray(at, corner & 1 ? at->wide : -at->wide,
                                        corner & 2 ? at->high : -at->high);
        const int64_t across = -(int64_t)tp_dot_dir(ray, (tp_dir3){ -lines.z, 0, lines.x });
        const int64_t along = -(int64_t)tp_dot_dir(ray, lines);
        if (across < 256 || (along < 0 ? -along : along) >= 3 * across
            || !is_line_order_kept(s, coastal, lines, along * TP_FX_ONE / across))
            return false;
    }
    return true;
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
        if (!u->drawing || !tp_module_ask_condition(u->module, &conditions))
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
 * gentle too.  Returns the sum, Q16. */
static int64_t classify_sea(tp_view_estimate *o, const tp_scene *s)
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
    return slope;
}

/* True if a facet no steeper than `most`, Q16, mirrors the light to the eye along the
 * ray. */
static bool mirrors_light(tp_vec3 ray, tp_dir3 light, int64_t most)
{
    const int64_t square = (int64_t)ray.x * ray.x + (int64_t)ray.y * ray.y
                         + (int64_t)ray.z * ray.z;
    const int64_t length = tp_isqrt64((uint64_t)square) + 1;
    const int64_t x = (light.x >> 14) - (int64_t)ray.x * TP_FX_ONE / length;
    const int64_t y = (light.y >> 14) - (int64_t)ray.y * TP_FX_ONE / length;
    const int64_t z = (light.z >> 14) - (int64_t)ray.z * TP_FX_ONE / length;
    const int64_t level = most * y >> 16;

    return y > 0 && x * x + z * z <= level * level;
}

/* True if water in view may show the specular lobe: at some ray a facet no steeper than
 * the waves and the lobe together mirrors the light.  The lobe ends where it falls to
 * 1/16: tan^2 = 2 ln 16 / exponent.  Ripples, pools and rings have slopes up to about 1/3.
 * `slope`: that of the waves, Q16. */
static bool is_lobe_in_view(const tp_view_estimate *o, const tp_scene *s,
                            const tp_start_view *at, int64_t slope)
{
    const tp_dir3 light = tp_light_direction(tp_turn_of_degrees(s->light.heading),
                                             tp_turn_of_degrees(s->light.elevation));
    const bool rippled = o->stirred || o->trait[TP_TRAIT_ripple] || o->trait[TP_TRAIT_bump];
    const int64_t lobe = tp_isqrt64(((uint64_t)TP_FX(5.545) << 32)
                                    / ((uint64_t)s->water.shininess + 1));
    const int64_t most = tp_clamp_abs(slope + lobe + (rippled ? TP_FX_ONE / 3 : 0),
                                      4 * TP_FX_ONE);

    if (!o->trait[TP_TRAIT_glint] || s->water.specular <= 0)
        return false;
    for (int32_t i = 0; i < RAYS * RAYS; i++) {
        const int64_t x = at->wide * (2 * (i % RAYS) + 1 - RAYS) / RAYS;
        const int64_t y = at->high * (2 * (i / RAYS) + 1 - RAYS) / RAYS;
        if (tp_start_view_water_distance_ahead(at, x, y) > 0
            && mirrors_light(tp_start_view_ray(at, x, y), light, most))
            return true;
    }
    return false;
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
    const tp_module_conditions conditions = tp_plan_module_conditions(in);
    const tp_start_view at = tp_start_view_make(scene, width, height);
    const uint64_t pixels = (uint64_t)width * height;
    const tp_vec3 low = tp_start_view_ray(&at, 0, -at.high);
    const int64_t ahead = (int64_t)low.x * -at.turn.z.x + (int64_t)low.z * -at.turn.z.z;
    tp_view_estimate o = { .focal = (int32_t)(((int64_t)height << 15) / at.high) };
    int64_t waves = 0, crests = 0;

    o.water_pixels =
        (uint32_t)(pixels * count_water_rays(scene, &at, &o.unhazed) / (RAYS * RAYS));
    o.other_pixels = (uint32_t)pixels - o.water_pixels;
    o.vertices = tp_fan_budget(scene) * 9 / 10;     /* seen ones */
    o.in_view = count_vertices_in_view(scene, &at);
    record_surface_modules(&o, in->modules, &conditions);
    o.trait[TP_TRAIT_plain] = 1;
    record_drawn_modules(&o, in->modules, conditions);
    o.slope_cells = o.modules & TP_MODULE_SLOPES
                        ? (uint32_t)(scene->pool.cols * scene->pool.rows) : 0;
    o.quick = (o.modules & TP_MODULE_FAST) != 0;
    o.lobe = is_lobe_in_view(&o, scene, &at, classify_sea(&o, scene));
    o.floor = (uint8_t)(tp_has_floor(scene) + (tp_has_floor(scene) && assets->floor));
    set_wave_flags(&o, scene);
    for (int i = 0; i < TP_WAVES; i++) {
        const tp_wave *w = &scene->wave[i];
        waves += w->amplitude > 0 ? w->amplitude : 0;
        crests += w->amplitude > 0 ? tp_sharp_max_height(w->amplitude, w->exponent) : 0;
    }
    o.near = tp_nearest_water_distance(tp_fx_saturate(at.eye.y - waves), &at.turn,
                                       scene->camera.fov);
    set_points_per_renderer(&o, &at, waves, width, height);
    set_usable_renderers(&o, scene, &at, crests, low.y >= 0 || ahead > 0);
    return o;
}
