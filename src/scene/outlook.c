/* SPDX-License-Identifier: MIT */
/* What a scene puts before its camera at the start, estimated: pixels of level water by a
 * lattice of rays, crossings of the grid by a lattice of them, and what those pixels go
 * through.  The conditions are those of frame/plan*.c.  Boat, drops and tank are not
 * taken off the water that they hide. */
#include "geom/grid.h"
#include "scene/faint.h"
#include "scene/light.h"
#include "scene/prices.h"
#include "scene/sides.h"
#include "wave/ocean.h"

#define RAYS   32               /* each way */
#define BAND   16               /* rows of a tile, as a board draws */
#define POINTS (1 << 20)        /* at the most */
#define SPOTS  32               /* of the grid, each way */

typedef struct {
    tp_vec3     eye;
    tp_rotation turn;
    int64_t     wide, high;     /* tangents of half the picture, Q16 */
    int64_t     x, z;           /* the grid's centre */
    tp_rectangle water;         /* that there is */
} stand;

/* -- the lay of the land ------------------------------------------------------------- */

/* From the grid's centre to the end of its even cells. */
static int64_t half_of(const tp_scene *s, int32_t lines, int32_t *flank)
{
    *flank = s->grid.reach > 0 ? lines / 8 : 0;
    *flank = *flank < TP_GRID_FLANK ? *flank : TP_GRID_FLANK;
    return (int64_t)s->grid.cell * (lines - 2 * *flank - 1) / 2;
}

/* Aboard the place is the deck's. */
static tp_vec3 eye_of(const tp_scene *s)
{
    tp_vec3 eye = { s->camera.x, s->camera.y, s->camera.z };

    if (s->camera.follow == TP_FOLLOW_BOAT) {
        const tp_turn heading = tp_turn_of_degrees(s->boat.heading);
        const tp_rotation boat = tp_rotation_of(heading, 0, 0);
        eye = tp_rotate_back(&boat, eye);
        eye.x = tp_fx_held((int64_t)eye.x + s->boat.x);
        eye.z = tp_fx_held((int64_t)eye.z + s->boat.z);
    }
    return eye;
}

static void place_water(stand *at, const tp_scene *s)
{
    int32_t flank;
    int64_t wide = half_of(s, s->grid.cols, &flank) + s->grid.reach;
    int64_t deep = half_of(s, s->grid.rows, &flank) + s->grid.reach;

    at->x = at->z = 0;
    if (s->grid.follow) {
        at->x = at->eye.x - ((int64_t)s->grid.cell * s->grid.cols * 3 / 10
                             * at->turn.z.x >> 30);
        at->z = at->eye.z - ((int64_t)s->grid.cell * s->grid.rows * 3 / 10
                             * at->turn.z.z >> 30);
    }
    at->water = (tp_rectangle){ tp_fx_held(at->x - wide), tp_fx_held(at->x + wide),
                                tp_fx_held(at->z - deep), tp_fx_held(at->z + deep) };
    if (tp_has_tank(s))
        at->water = tp_pool_sides(s);
}

static stand stand_of(const tp_scene *s, uint32_t width, uint32_t height)
{
    const tp_dir3 half = tp_rotation_of(tp_turn_of_degrees(s->camera.fov) / 2, 0, 0).x;
    const tp_turn aboard = s->camera.follow == TP_FOLLOW_BOAT
                         ? tp_turn_of_degrees(s->boat.heading) : 0;
    stand at = { .eye = eye_of(s) };

    at.turn = tp_rotation_of(aboard + tp_turn_of_degrees(s->camera.heading),
                             tp_turn_of_degrees(s->camera.pitch), 0);
    at.high = ((int64_t)half.z * 65536) / half.x;
    at.wide = at.high * width / height;
    place_water(&at, s);
    return at;
}

/* -- pixels -------------------------------------------------------------------------- */

/* The ray through x, y of the picture: tangents, Q16 of one ahead, below 2^26. */
static tp_vec3 ray_of(const stand *at, int64_t x, int64_t y)
{
    return tp_rotate_back(&at->turn, (tp_vec3){ (tp_fx)x, (tp_fx)y, -TP_FX_ONE });
}

static bool sees_water(const stand *at, int64_t x, int64_t y)
{
    const tp_vec3 ray = ray_of(at, x, y);

    if (ray.y == 0 || at->eye.y == 0 || (ray.y < 0) != (at->eye.y > 0))
        return false;
    const int64_t far = (int64_t)at->eye.y * 65536 / -ray.y;    /* Q16, up to 2^47 */
    if (far > (int64_t)1 << 32)
        return false;
    const int64_t px = at->eye.x + (far * ray.x >> 16);
    const int64_t pz = at->eye.z + (far * ray.z >> 16);
    return px >= at->water.x0 && px <= at->water.x1
        && pz >= at->water.z0 && pz <= at->water.z1;
}

static uint32_t water_rays(const stand *at)
{
    uint32_t seen = 0;

    for (int32_t j = 0; j < RAYS; j++)
        for (int32_t i = 0; i < RAYS; i++)
            seen += sees_water(at, at->wide * (2 * i + 1 - RAYS) / RAYS,
                               at->high * (2 * j + 1 - RAYS) / RAYS);
    return seen;
}

/* -- vertices ------------------------------------------------------------------------ */

/* Where the n-th of SPOTS lies on an axis of `lines` lines; those of the flanks grow. */
static int64_t spot_of(const tp_scene *s, int32_t lines, int64_t centre, int32_t n)
{
    int32_t flank;
    const int64_t half = half_of(s, lines, &flank);
    const int64_t line = (int64_t)(lines - 1) * (2 * n + 1 - SPOTS) * 32768 / SPOTS;
    const int64_t core = (int64_t)(lines - 1 - 2 * flank) * 32768;
    const int64_t out = line < 0 ? -line - core : line - core;      /* lines, Q16 */

    if (out <= 0)
        return centre + (line * s->grid.cell >> 16);
    const int64_t share = out / flank;          /* of the flank, Q16; cubed */
    const int64_t way = half + (s->grid.reach * (share * share * share >> 32) >> 16);
    return centre + (line < 0 ? -way : way);
}

/* Within the picture and a little around it, at the level or the crests.  What is 8 km
 * off is as well there. */
static bool is_viewed(const stand *at, const tp_scene *s, int64_t x, int64_t z)
{
    const int64_t most = 1 << 29;
    const tp_vec3 v = tp_rotate(&at->turn, (tp_vec3){
        (tp_fx)tp_limit(x - at->eye.x, most), (tp_fx)tp_limit(-(int64_t)at->eye.y, most),
        (tp_fx)tp_limit(z - at->eye.z, most) });
    const int64_t room = 2 * (int64_t)s->grid.cell;
    const int64_t wide = (-v.z * at->wide >> 16) + room;
    const int64_t high = (-v.z * at->high >> 16) + room;

    return -v.z > -room && tp_abs(v.x) <= wide && tp_abs(v.y) <= high;
}

static uint32_t viewed_spots(const stand *at, const tp_scene *s)
{
    uint32_t viewed = 0;

    for (int32_t j = 0; j < SPOTS; j++) {
        const int64_t z = spot_of(s, s->grid.rows, at->z, j);
        for (int32_t i = 0; i < SPOTS; i++)
            viewed += is_viewed(at, s, spot_of(s, s->grid.cols, at->x, i), z);
    }
    return viewed;
}

/* -- points of a lattice over the picture -------------------------------------------- */

/* Lines of the projected method up to so many rows below the horizon (frame/projected.c),
 * to 4 times as many at a step there. */
static int64_t lines_below(int64_t rows)
{
    return rows > 64 ? 48 + (rows - 64) / 4 : rows > 32 ? 32 + (rows - 32) / 2
         : rows > 0 ? rows : 0;
}

/* Rows from the horizon down to the picture's lower edge. */
static int64_t rows_below(const stand *at, int32_t focal, uint32_t height)
{
    const int64_t up = at->turn.y.y > 1 << 20
                     ? (int64_t)focal * at->turn.z.y / at->turn.y.y : 4096;
    return tp_limit(up + height / 2, 4096);
}

/* Tiles of BAND rows walk again the lines that waves, so high, may raise into them. */
static uint32_t projected_points(const stand *at, int32_t focal, int64_t waves,
                                 uint32_t width, uint32_t height)
{
    const int64_t below = rows_below(at, focal, height), eye = at->eye.y;
    int64_t lines = 0;

    if (eye <= waves)
        return 0;
    for (int64_t low = below; low > 0 && low > below - height; low -= BAND) {
        const int64_t first = low * eye / (eye - waves) + (waves > 0 ? 8 : 4);
        const int64_t last = (low - BAND) * eye / (eye + waves);
        lines += lines_below(first) - lines_below(last) + 1;
    }
    return (uint32_t)tp_limit(lines * (width / 8 + 5), POINTS);
}

/* Every 8th pixel of every 8th row, of water that has waves. */
static uint32_t flat_points(const stand *at, int32_t focal, int64_t waves, uint32_t width,
                            uint32_t height)
{
    const int64_t below = rows_below(at, focal, height);
    const int64_t rows = below < height ? below : height;

    return waves > 0 && rows > 0 ? (uint32_t)((rows / 8 + 1) * (width / 8 + 1)) : 0;
}

static void list_points(tp_outlook *o, const stand *at, int64_t waves, uint32_t width,
                        uint32_t height)
{
    o->points[TP_VISIBILITY_TRIANGLES - 1] = o->vertices;
    o->points[TP_VISIBILITY_ROWS - 1] = o->vertices;
    o->points[TP_VISIBILITY_PROJECTED - 1] =
        projected_points(at, o->focal, waves, width, height);
    o->points[TP_VISIBILITY_FLAT - 1] = flat_points(at, o->focal, waves, width, height);
}

/* -- which methods draw it ----------------------------------------------------------- */

/* The frame decides by its own camera; here by the scene's, and a little strictly. */
static void list_fits(tp_outlook *o, const tp_scene *s, const stand *at, int64_t waves,
                      bool ahead)
{
    const bool ocean = tp_has_ocean(s), stirred = s->pool.cols > 0 || s->field.cols > 0;
    const bool over = at->eye.y > waves + TP_FX_ONE / 8;
    const bool swell = over && !ocean && !stirred && s->drops.count == 0;

    o->fits[TP_VISIBILITY_TRIANGLES - 1] = 1;
    o->fits[TP_VISIBILITY_ROWS - 1] = over && ahead
        && !(ocean && tp_may_break(s->surf.stretch, s->floor.slope, s->floor.map[0]));
    o->fits[TP_VISIBILITY_PROJECTED - 1] = swell && ahead && waves < at->eye.y * 3 / 4;
    o->fits[TP_VISIBILITY_FLAT - 1] = swell;
}

/* -- what water goes through --------------------------------------------------------- */

/* As a picture, or as one prepared for the quick rung. */
static bool has_layer(const tp_assets *a, int k)
{
    return a->layer[k] || a->graded[k];
}

static void list_pictures(tp_outlook *o, const tp_scene *s, const tp_assets *a)
{
    const uint8_t added = (uint8_t)(has_layer(a, 1) + has_layer(a, 2));
    const bool first = has_layer(a, 0);

    o->trait[TP_TRAIT_texture] = first;
    o->trait[TP_TRAIT_linear] = s->water.filter == TP_FILTER_LINEAR
                              ? (uint8_t)(added + first) : 0;
    o->trait[TP_TRAIT_bend] = (a->distortion || a->offsets)
                           && s->distortion.strength > 0 && (first || added);
    o->trait[TP_TRAIT_layer] = added;
    o->trait[TP_TRAIT_ripple] = (a->ripple || a->slopes) && s->ripple.bump > 0;
    o->trait[TP_TRAIT_bump] = s->water.pool_bump > 0
                           && (s->pool.cols > 0 || s->field.cols > 0);
}

static void list_light(tp_outlook *o, const tp_scene *s, const tp_assets *a)
{
    const bool shines = s->water.specular > 0, mirrors = s->water.reflection > 0;
    const bool clear = s->water.clear > 0;

    o->trait[TP_TRAIT_look] = shines || mirrors || clear;
    o->trait[TP_TRAIT_mirror] = mirrors;
    o->trait[TP_TRAIT_glint] = shines;
    o->trait[TP_TRAIT_haze] = s->sky.haze > 0;
    o->trait[TP_TRAIT_dome] = mirrors && tp_has_dome(s);
    o->trait[TP_TRAIT_cube] = mirrors && s->sky.kind == TP_SKY_CUBE && a->sky[0];
    o->trait[TP_TRAIT_objects] = mirrors && s->mirror.objects != TP_MIRROR_NONE
                              && (a->boat || s->drops.count > 0 || tp_has_tank(s));
    o->trait[TP_TRAIT_behind] = clear;
    o->trait[TP_TRAIT_bed] = clear && (tp_has_floor(s) || tp_has_tank(s));
    o->trait[TP_TRAIT_dispersion] = clear && s->water.dispersion > 0;
    o->trait[TP_TRAIT_foam] = s->foam.cells > 0;
    o->trait[TP_TRAIT_expose] = s->hdr.exposure == TP_EXPOSURE_AUTO
                             || s->hdr.value != TP_FX_ONE;
}

/* frame/plan_quick.c has the rule: what the quick stages do not know is drawn by exact
 * ones. */
static bool is_quick(const tp_outlook *o, const tp_scene *s, const tp_assets *a)
{
    const bool sky = tp_has_dome(s) || (s->sky.kind == TP_SKY_CUBE && a->sky[0]);

    return !o->trait[TP_TRAIT_behind] && !o->trait[TP_TRAIT_bump]
        && !o->trait[TP_TRAIT_foam] && !o->trait[TP_TRAIT_objects]
        && !(sky && !o->trait[TP_TRAIT_ripple]) && s->hdr.share <= 0;
}

/* The lobe's steepest place is about its height times the root of its exponent. */
static int gloss_of(const tp_scene *s)
{
    const int64_t square = (int64_t)s->water.specular * s->water.specular >> 16;

    return s->water.specular <= 0 ? 0
         : square * s->water.shininess >> 16 > 144 * TP_FX_ONE ? 2 : 1;
}

/* By the sum of k A: up to 1/4 is gentle, and so are pools and rings. */
static uint8_t sea_of(const tp_scene *s, uint32_t *waves)
{
    const bool stirred = s->pool.cols > 0 || s->field.cols > 0 || s->drops.count > 0;
    int64_t slope = 0;

    *waves = 0;
    for (int i = 0; i < TP_WAVES; i++) {
        if (s->wave[i].amplitude <= 0)
            continue;
        slope += (int64_t)s->wave[i].amplitude * 411775 / s->wave[i].length;    /* 2 pi */
        ++*waves;
    }
    const int most = tp_has_ocean(s) ? TP_SEA_OCEAN : TP_SEA_STEEP;
    const int steep = slope > TP_FX_ONE / 4 ? most
                    : slope > 0 || stirred ? TP_SEA_GENTLE : TP_SEA_LEVEL;
    return (uint8_t)(steep + gloss_of(s));
}

/* -- all ----------------------------------------------------------------------------- */

tp_outlook tp_outlook_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                         uint32_t height)
{
    const stand at = stand_of(scene, width, height);
    const uint64_t pixels = (uint64_t)width * height;
    const tp_vec3 low = ray_of(&at, 0, -at.high);
    const int64_t ahead = (int64_t)low.x * -at.turn.z.x + (int64_t)low.z * -at.turn.z.z;
    tp_outlook o = { .focal = (int32_t)(((int64_t)height << 15) / at.high) };
    int64_t waves = 0;

    o.water_pixels = (uint32_t)(pixels * water_rays(&at) / (RAYS * RAYS));
    o.other_pixels = (uint32_t)pixels - o.water_pixels;
    o.vertices = (uint32_t)((uint64_t)scene->grid.cols * (uint64_t)scene->grid.rows
                            * viewed_spots(&at, scene) / (SPOTS * SPOTS));
    o.sea = sea_of(scene, &o.waves);
    o.pools = scene->water.pool_bump > 0 ? 0 : (uint8_t)((scene->pool.cols > 0)
                                                         + (scene->field.cols > 0));
    o.ocean = tp_has_ocean(scene);
    for (int i = 0; i < TP_WAVES; i++)
        waves += scene->wave[i].amplitude > 0 ? scene->wave[i].amplitude : 0;
    o.near = tp_faint_near(tp_fx_held(at.eye.y - waves), &at.turn, scene->camera.fov);
    list_points(&o, &at, waves, width, height);
    list_fits(&o, scene, &at, waves, low.y >= 0 || ahead > 0);
    o.trait[TP_TRAIT_plain] = 1;
    list_pictures(&o, scene, assets);
    list_light(&o, scene, assets);
    o.quick = is_quick(&o, scene, assets);
    return o;
}
