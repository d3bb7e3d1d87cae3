/* SPDX-License-Identifier: MIT */
/*
 * Functions shared by all render views: triangles clipped by the near plane, the frustum
 * or a level; the view's shading numbers; planar maps.  Conversion between world positions
 * and positions in the picture's own view.
 */
#include "frame/drawing.h"
#include "frame/frame.h"

/* -- clipped triangles, shared by all solids ----------------------------------------- */

tp_view_vertex tp_solid_vertex_make(const tp_projection *projection, tp_vec3 at,
                                    const int16_t n[3])
{
    tp_view_vertex c;

    tp_projection_view_vertex(projection, at, &c);
    c.s = c.t = 0;
    for (int k = 0; k < 3; k++)
        c.n[k] = n[k];
    return c;
}

int tp_clipped_corners(const tp_projection *projection, const tp_view_plane *level,
                       const tp_view_vertex in[3], tp_screen_vertex to[TP_CLIP_VERTICES])
{
    tp_view_vertex out[TP_CLIP_VERTICES];
    int count = tp_clip_triangle_view_and_plane(projection, level, in, out);

    for (int k = 0; k < count; k++)
        tp_view_vertex_project(projection, &out[k], &to[k]);
    return count;
}

void tp_clipped_draw(const tp_projection *projection, const tp_view_plane *level,
                     const tp_gbuffer *tile, const tp_view_vertex in[3], uint32_t mark,
                     uint32_t t)
{
    tp_screen_vertex corner[TP_CLIP_VERTICES];
    int count = tp_clipped_corners(projection, level, in, corner);

    for (int k = 2; k < count; k++)
        tp_tri_solid(tile, &corner[0], &corner[k - 1], &corner[k], mark, t, 16);
}

/* -- views --------------------------------------------------------------------------- */

tp_fx tp_view_objects_water_level(const tp_frame *frame)
{
    return tp_frame_objects_anchor(frame).level;
}

bool tp_view_is_above_level(const tp_frame *frame, tp_fx level)
{
    return !frame->under && frame->projection.eye.y > level;
}

/* Mipmap levels refer to the picture's focal length.  A view of a shorter focal length
 * puts more texels into a pixel, as a larger distance would. */
void tp_view_set_shade(tp_frame *frame, const tp_projection *projection)
{
    TP_ASSERT(projection->focal > 0 && projection->zi_near > 0);
    tp_shade *shade = &frame->shade;

    shade->u0 = projection->u0;
    shade->v0 = projection->v0;
    shade->focal = projection->focal >> 12;
    shade->per_focal = (uint32_t)tp_quotient((int64_t)1 << 32, shade->focal);
    shade->zi_log = tp_log2_q8((uint32_t)projection->zi_near) + 15 * 256
                    + tp_log2_q8((uint32_t)frame->projection.focal)
                    - tp_log2_q8((uint32_t)projection->focal);
    shade->world.right = projection->turn.x;
    shade->world.up = projection->turn.y;
    shade->world.back = projection->turn.z;
    shade->eye = projection->eye;
}

void tp_view_begin(tp_frame *frame, const tp_view *view)
{
    tp_view_set_shade(frame, view->projection);
}

tp_grid_box tp_view_project_solids(tp_frame *frame, tp_view *view)
{
    tp_grid_box box = TP_BOX_NONE;

    tp_frame_project_modules(frame, view, &box);
    return box;
}

void tp_view_draw_solids(const tp_frame *frame, const tp_view *view, tp_gbuffer *tile)
{
    tp_frame_draw_modules(frame, view, tile);
}

/* -- planar maps --------------------------------------------------------------------- */

/* Returns the words of some pixels of the map. */
static uint32_t count_words(const tp_planar_memory *store, uint32_t pixels)
{
    return store->packed ? (pixels + 1) / 2 : pixels;
}

void tp_planar_layout(tp_planar_memory *store, tp_arena *arena,
                      const tp_module_conditions *conditions, uint32_t halvings,
                      bool packed)
{
    TP_ASSERT(conditions->width >= 16 && conditions->height >= 16);
    store->halvings = halvings;
    store->packed = packed;
    store->cols = (conditions->width + (1u << halvings) - 1) >> halvings;
    store->rows = (conditions->height + (1u << halvings) - 1) >> halvings;
    store->colour = tp_arena_alloc(arena, count_words(store, store->cols * store->rows),
                                   sizeof *store->colour);
    store->samples = tp_arena_alloc(arena, (size_t)store->cols * TP_PLANAR_BAND,
                                    4 * sizeof *store->samples);
}

bool tp_planar_set_bounds(const tp_planar_memory *store, const tp_grid_box *box,
                          tp_planar_map *map)
{
    TP_ASSERT(store->colour != NULL);
    int32_t cols = (int32_t)store->cols, rows = (int32_t)store->rows;

    *map = (tp_planar_map){
        store->colour, tp_clamp(box->x0, 0, cols), tp_clamp(box->y0, 0, rows),
        tp_clamp(box->x1 + 1, 0, cols), tp_clamp(box->y1 + 1, 0, rows),
        (int32_t)store->halvings,
    };
    if (map->x0 < map->x1 && map->y0 < map->y1)
        return true;
    map->colour = NULL;
    return false;
}

tp_gbuffer tp_planar_gbuffer(const tp_planar_memory *store, const tp_planar_map *map,
                             int32_t y0)
{
    size_t plane = (size_t)store->cols * TP_PLANAR_BAND;
    int32_t y1 = y0 + TP_PLANAR_BAND < map->y1 ? y0 + TP_PLANAR_BAND : map->y1;

    return (tp_gbuffer){ map->x0, y0, map->x1, y1, store->cols, store->samples,
                         store->samples + plane, store->samples + 2 * plane,
                         store->samples + 3 * plane, false, 0, NULL, 0, 0,
                         NULL, NULL };
}

/* The words past the map's box are free; so are, of `left` rows, those that come after the
 * band: left - rows, of which its planes take at most all. */
tp_gbuffer tp_planar_tall_gbuffer(const tp_planar_memory *store, const tp_planar_map *map,
                                  int32_t y0, uint32_t planes)
{
    const uint32_t wide = (uint32_t)(map->x1 - map->x0), left = (uint32_t)(map->y1 - y0),
                   used = count_words(store, wide * (uint32_t)(map->y1 - map->y0)),
                   all = count_words(store, store->cols * store->rows),
                   past = (all - used) / (planes * wide),
                   before = left / ((store->packed ? 2 * planes : planes) + 1),
                   most = past > before ? past : before,
                   rows = most < left ? most : left;
    const size_t plane = (size_t)wide * rows;
    uint32_t *key = store->colour + (past > before ? used : 0);

    if (rows <= TP_PLANAR_BAND)
        return tp_planar_gbuffer(store, map, y0);
    return (tp_gbuffer){ map->x0, y0, map->x1, y0 + (int32_t)rows, wide, key, key + plane,
                         key + 2 * plane, key + 3 * plane, false, 0, NULL, 0, 0,
                         NULL, NULL };
}

/* -- world and picture positions ----------------------------------------------------- */

/* Component of a position relative to the eye along an axis of the view, m, Q30.
 * Differences below 2^32 times 2^30 fit 64 bits; three of them fit once 16 bits are cut. */
static int64_t view_axis_component(const tp_projection *projection, tp_vec3 place,
                                   tp_dir3 axis)
{
    const int64_t x = (int64_t)place.x - projection->eye.x;
    const int64_t y = (int64_t)place.y - projection->eye.y;
    const int64_t z = (int64_t)place.z - projection->eye.z;

    return (x * axis.x >> 16) + (y * axis.y >> 16) + (z * axis.z >> 16);
}

/* Returns focal x way / depth, px, 16.16, saturated.  Both lengths are halved until depth
 * fits 31 bits; if the product would still not fit, the point lies far outside. */
static tp_fx project_pixels(const tp_projection *projection, int64_t offset, int64_t depth)
{
    int64_t most;

    for (; depth >> 31 > 0; depth >>= 1)
        offset /= 2;
    most = INT64_MAX / 2 / projection->focal;
    if (offset > most || offset < -most)
        return offset > 0 ? TP_FX_MAX : TP_FX_MIN;
    return tp_fx_saturate(tp_div_rounded(offset * projection->focal, depth));
}

bool tp_frame_project(const tp_frame *frame, tp_vec3 place, tp_fx *x_px, tp_fx *y_px,
                      tp_fx *depth)
{
    TP_ASSERT(frame != NULL && frame->world != NULL);
    const tp_projection *projection = &frame->projection;
    const int64_t far = view_axis_component(projection, place, projection->ahead);

    if (far >> 14 < projection->near)
        return false;
    *x_px = tp_fx_saturate(
        (int64_t)frame->config.width * (TP_FX_ONE / 2)
        + project_pixels(
            projection, view_axis_component(projection, place, projection->turn.x), far));
    *y_px = tp_fx_saturate(
        (int64_t)frame->config.height * (TP_FX_ONE / 2)
        - project_pixels(
            projection, view_axis_component(projection, place, projection->turn.y), far));
    *depth = tp_fx_saturate((far + (1 << 13)) >> 14);
    return true;
}

bool tp_frame_pick(const tp_frame *frame, tp_fx x_px, tp_fx y_px, tp_vec3 *at)
{
    TP_ASSERT(frame != NULL && frame->world != NULL);
    return tp_world_pick(frame->program, frame->world, frame->scene, frame->config.width,
                         frame->config.height, x_px, y_px, at);
}
