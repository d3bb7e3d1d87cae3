/* SPDX-License-Identifier: MIT */
/* Draws the mirrored picture of the planar reflection, and estimates its cost. */
#include "features/reflection/reflection.h"
#include "frame/drawing.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "pixel/pixel.h"
#include "quality/prices.h"
#include "tidepool/modules.h"

/* -- the planar reflection ----------------------------------------------------------- */

/* A planar map of the objects above the water.  The map is the view of a mirrored camera:
 * as deep under the level as the camera is above it, with the pitch negated, and upside
 * down [F4]. */

typedef struct {
    tp_mirror        look;      /* data of the stage; first member */
    tp_mirrored_zi  *zi;        /* array, one for each column */
    tp_planar_memory store;
    bool             outlined;  /* the band has memory for outlines */
} mirror;

/* Updates the columns' depths by row y of a band. */
static void update_column_depths(tp_mirrored_zi *zi, const tp_gbuffer *band, int32_t y)
{
    const uint32_t *key = band->key + (size_t)(uint32_t)(y - band->y0) * band->stride;

    for (int32_t i = 0; i < band->x1 - band->x0; i++) {
        uint32_t at = TP_ZI(key[i]);
        if (at == 0)
            continue;
        zi[i].far = zi[i].near == 0 || at < zi[i].far ? at : zi[i].far;
        zi[i].near = at > zi[i].near ? at : zi[i].near;
    }
}

/* Gives a column without an object the depths of its left neighbour; columns before the
 * first object get the depths of that first column. */
static void fill_gaps(tp_mirrored_zi *zi, uint32_t count)
{
    uint32_t first = 0;

    while (first + 1 < count && zi[first].near == 0)
        first++;
    for (uint32_t i = 0; i < first; i++)
        zi[i] = zi[first];
    for (uint32_t i = first + 1; i < count; i++)
        zi[i] = zi[i].near ? zi[i] : zi[i - 1];
}

/* Returns the projection of the mirrored camera.  Its rows count from the other end: its
 * row j is row rows - 1 - j of the camera, because its up vector is the camera's,
 * mirrored and negated. */
static tp_projection mirrored_projection(const tp_frame *frame,
                                         const tp_planar_memory *store, tp_fx level)
{
    const tp_projection *from = &frame->projection;
    const tp_dir3  r = from->turn.x, up = from->turn.y, back = from->turn.z;
    const tp_rotation turn = { { r.x, -r.y, r.z }, { -up.x, up.y, -up.z },
                               { back.x, -back.y, back.z } };
    tp_projection projection;

    tp_projection_init_turned(
        &projection, (tp_vec3){ from->eye.x, 2 * level - from->eye.y, from->eye.z }, turn,
        frame->scene->camera.fov, from->near, frame->config.width, frame->config.height);
    for (uint32_t n = 0; n < store->halvings; n++)
        projection = tp_projection_halve(&projection);
    projection.v0 = 16 * (int32_t)store->rows - projection.v0;
    return projection;
}

/* Pixels of the map by which the clip level is lowered.  At the foot of an
 * object one pixel covers water from both sides of the level.  The additional part of the
 * reflection lies behind its object and stays hidden. */
enum { OVERLAP = 2 };

/* Returns the clip level.  Troughs expose a hull below the mean level, so the clip level
 * is the deepest trough.  With tank walls the clip level is the mean level: walls and
 * floor below it would be reflected all over the water. */
static tp_view_plane mirror_clip_plane(const tp_frame *frame,
                                       const tp_projection *projection, tp_fx level)
{
    const tp_fx trough = -tp_surface_height_bound(&frame->surface);
    const bool  bare = !tp_frame_has_module(frame, TP_MODULE_WALLS) && trough < level;
    tp_view_plane plane = tp_projection_level_plane(projection, bare ? trough : level, 1);

    plane.depth += (int32_t)(((int64_t)OVERLAP << 43) / projection->focal);
    return plane;
}

static void set_bending(const tp_frame *frame, tp_mirror *to, tp_fx level)
{
    to->bend = frame->scene->mirror.distortion >> 8;
    to->height =
        (int64_t)(frame->projection.eye.y - level) * 4096 / frame->projection.zi_near;
}

/* True if the map has outlines.  The fast rung of objects has none where waves bend the
 * reflection by more than an outline smooths. */
static bool has_outlines(const tp_scene *scene)
{
    bool waves = scene->pool.cols > 0 || scene->field.cols > 0;

    for (int i = 0; i < TP_WAVES; i++)
        waves = waves || scene->wave[i].amplitude > 0;
    return tp_has_outlines(scene) && (!waves || scene->quality.objects != TP_RUNG_FAST);
}

/* Returns the next band. */
static tp_gbuffer begin_band(tp_frame *frame, const mirror *m, int32_t y0)
{
    const bool outlined = m->outlined && frame->outlined && has_outlines(frame->scene);
    tp_gbuffer band = tp_planar_tall_gbuffer(&m->store, &m->look.map, y0, outlined ? 8 : 4);

    tp_gbuffer_clear(&band);
    tp_frame_allow_wide_solids(frame, &band, &frame->stats.dropped);
    if (outlined)
        tp_frame_allow_outlines(frame, &band);
    return band;
}

/* Packs a colour premultiplied by its alpha as tp_mirror_unpack reads it: an object that
 * covers half the pixel or more has its whole colour. */
static uint16_t pack_colour(uint32_t colour)
{
    const uint32_t alpha = colour >> 24;
    uint32_t whole = colour;

    if (alpha < 128)
        return 0;
    for (int shift = 0; alpha < 255 && shift < 24; shift += 8) {
        const uint32_t channel = (colour >> shift & 255) * 255 / alpha;
        whole = (whole & ~(255u << shift)) | (channel < 255 ? channel : 255) << shift;
    }
    const uint32_t pixel = tp_rgb565(whole);
    return pixel ? (uint16_t)pixel : 1;
}

/* Colours row y of a band into the map.  Packed colours take the place of the row's normals
 * before, which the shading has used. */
static void colour_row(const tp_frame *frame, const mirror *m, const tp_gbuffer *band,
                       int32_t y)
{
    TP_ASSERT(band->y0 <= y && y < band->y1 && y < m->look.map.y1);
    const uint32_t wide = (uint32_t)(band->x1 - band->x0);
    const uint32_t at = (uint32_t)(m->look.map.y1 - 1 - y) * wide;

    if (!m->store.packed) {
        tp_frame_colour_row(frame, band, y, m->store.colour + at);
        return;
    }
    uint32_t *row = band->n + (size_t)(uint32_t)(y - band->y0) * band->stride;
    uint16_t *to = (uint16_t *)(void *)m->store.colour + at;
    tp_frame_colour_row(frame, band, y, row);
    for (uint32_t i = 0; i < wide; i++)
        to[i] = pack_colour(row[i]);
}

static void draw_mirror(tp_frame *frame, mirror *m, const tp_view *view)
{
    const tp_planar_map *map = &m->look.map;
    uint32_t wide = (uint32_t)(map->x1 - map->x0);

    memset(m->zi, 0, wide * sizeof *m->zi);
    for (int32_t y0 = map->y0; y0 < map->y1; ) {
        tp_gbuffer band = begin_band(frame, m, y0);
        tp_view_draw_solids(frame, view, &band);
        for (int32_t y = y0; y < band.y1; y++) {
            colour_row(frame, m, &band, y);
            update_column_depths(m->zi, &band, y);
        }
        y0 = band.y1;
    }
    fill_gaps(m->zi, wide);
}

static void draw_mirror_map(tp_frame *frame, void *mine)
{
    mirror *m = mine;
    const int32_t rows = (int32_t)m->store.rows;
    tp_fx    level = tp_view_objects_water_level(frame);
    tp_planar_map *map = &m->look.map;

    map->colour = NULL;
    if (!tp_view_is_above_level(frame, level))
        return;
    tp_projection  projection = mirrored_projection(frame, &m->store, level);
    tp_view view = { .projection = &projection, .clipped = true, .walls = true,
                       .level = mirror_clip_plane(frame, &projection, level) };
    tp_view_begin(frame, &view);
    tp_grid_box box = tp_view_project_solids(frame, &view);
    if (!tp_planar_set_bounds(&m->store, &box, map))
        return;
    set_bending(frame, &m->look, level);
    draw_mirror(frame, m, &view);
    *map = (tp_planar_map){ map->colour, map->x0, rows - map->y1, map->x1,
                       rows - map->y0, map->halvings };
}

/* -- the module mirror --------------------------------------------------------------- */

bool tp_mirror_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->mirror.method == TP_MIRROR_STENCIL
           && conditions->scene->water.reflection > 0
           && conditions->above & (TP_MODULE_SOLID | TP_MODULE_WALLS);
}

static void *layout_mirror(tp_arena *arena, const tp_module_conditions *conditions)
{
    mirror *m = tp_arena_alloc(arena, 1, sizeof *m), made = { .look.bend = 0 };

    tp_planar_layout(&made.store, arena, conditions,
                     tp_mirror_halvings(conditions->scene, conditions->width,
                                        conditions->height),
                     conditions->scene->mirror.colours == TP_MIRROR_RGB565);
    made.outlined = has_outlines(conditions->scene);
    if (made.outlined)          /* right behind the band's samples */
        tp_arena_alloc(arena, (size_t)made.store.cols * TP_PLANAR_BAND,
                       4 * sizeof *made.store.samples);
    made.look.zi = made.zi = tp_arena_alloc(arena, made.store.cols, sizeof *made.zi);
    if (m)
        *m = made;
    return m;
}

const tp_module tp_mirror_module = {
    .name = "mirror", .id = TP_MIRROR_ID, .is = TP_MODULE_MIRROR,
    .trait = TP_TRAIT_objects, .enabled = tp_mirror_enabled,
};

/* Indices in the program's table of stages. */
enum { EXACT, BY_BLOCKS, FAST, PACKED };

/* Adds the stage.  Water without a reflected sky does not reflect objects either. */
static void add_mirror_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                             tp_shaders *list)
{
    const bool blocks = frame->scene->quality.objects == TP_RUNG_FAST;
    const mirror *m = mine;

    stage += m->store.packed ? PACKED : 0;
    if (list->kind == TP_LIST_FAST)
        tp_shaders_add(list, TP_AT_OBJECTS, stage[FAST], mine);
    else if (tp_shaders_has(list, TP_AT_REFLECT))
        tp_shaders_add(list, TP_AT_OBJECTS, stage[blocks ? BY_BLOCKS : EXACT], mine);
}

const tp_drawing tp_mirror_drawing = {
    .layout = layout_mirror,
    .draw_map = draw_mirror_map,
    .stages = add_mirror_stage,
};

/* -- cost ---------------------------------------------------------------------------- */

/* Water pixels that read the planar map.  Each object's own cost function counts its faces
 * in the reflection. */

static void count_pixel_work(tp_site *w, const tp_work_pixels *px)
{
    if (!w->mirrors)
        return;
    w->fixed_cost.of[TP_WORK_looked] = px->water;
    w->fixed_cost.of[TP_WORK_looked_near] = px->mirrored;
}

const tp_cost tp_mirror_cost = { .pixels = count_pixel_work };
