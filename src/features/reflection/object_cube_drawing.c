/* SPDX-License-Identifier: MIT */
/* Draws the cube map in which water and drops mirror objects. */
#include "features/reflection/reflection.h"
#include "frame/drawing.h"
#include "frame/frame.h"
#include "frame/renderers.h"
#include "pixel/pixel.h"
#include "tidepool/modules.h"

/* -- the object cube map ------------------------------------------------------------- */

/* Boat and drops seen from a point on the water, drawn anew in each frame.  The point is
 * the reflection point of the objects' middle for the camera.  The cube is exact at the
 * point and a good approximation around it. */

#define WIDE (2 * TP_OBJECT_CUBE_SIDE)
#define BAND 4                  /* rows drawn at a time */

typedef struct {
    tp_object_cube object_cube;           /* data of the stage; first member */
    uint32_t *colour;           /* texels of TP_OBJECT_CUBE_FACES faces */
    uint32_t *samples;
} cube_map;

/* Returns the point eye + (to - eye) part, with y = level. */
static tp_vec3 interpolate_on_level(tp_vec3 eye, tp_vec3 to, tp_fx part, tp_fx level)
{
    return (tp_vec3){ eye.x + tp_fx_mul(to.x - eye.x, part), level,
                      eye.z + tp_fx_mul(to.z - eye.z, part) };
}

/* Fills *cube except for its colours.  Returns the point. */
static tp_vec3 set_cube_viewpoint(const tp_frame *frame, tp_object_cube *cube, tp_fx level)
{
    const tp_vec3 eye = frame->projection.eye, to = tp_frame_objects_anchor(frame).middle;
    const tp_fx up = eye.y - level, high = to.y - level > TP_FX_ONE / 4
                                         ? to.y - level : TP_FX_ONE / 4;
    const tp_vec3 point = interpolate_on_level(eye, to, tp_fx_div(up, up + high), level);
    const tp_vec3 way = tp_vec3_sub(to, point);
    const tp_dir3 n = tp_normalise(way.x, 0, way.z);

    *cube = (tp_object_cube){
        .from = tp_vec3_sub(eye, point), .to = way, .nx = n.x >> 16, .nz = n.z >> 16,
        .zi_near = frame->projection.zi_near,
    };
    return point;
}

/* Adds one row of the G-buffer to a row of texels.  The G-buffer is twice as fine each
 * way: a quarter of each colour is added to its texel, so a colour is premultiplied by
 * its cover.  The colours overwrite the row's normals; the shading has used the normals
 * before. */
static void accumulate_row(const tp_frame *frame, const tp_gbuffer *band, int32_t y,
                           uint32_t *to)
{
    uint32_t *row = band->n + (uint32_t)(y - band->y0) * WIDE;

    tp_frame_colour_row(frame, band, y, row);
    for (int32_t x = 0; x < WIDE; x++)
        to[x / 2] += row[x] >> 2 & 0x3f3f3f3fu;
}

/* Draws one face.  Returns true if the face shows an object. */
static bool draw_face(tp_frame *frame, uint32_t *samples, tp_view *view, uint32_t *texels)
{
    const size_t plane = WIDE * BAND;

    tp_view_begin(frame, view);
    tp_grid_box box = tp_view_project_solids(frame, view);
    memset(texels, 0, TP_OBJECT_CUBE_SIDE * TP_OBJECT_CUBE_SIDE * sizeof *texels);
    for (int32_t y0 = 0; y0 < WIDE; y0 += BAND) {
        tp_gbuffer band = { 0, y0, WIDE, y0 + BAND, WIDE, samples, samples + plane,
                            samples + 2 * plane, samples + 3 * plane, false, 0, NULL, 0, 0,
                            NULL, NULL };
        if (!tp_box_overlaps_tile(&box, &band))
            continue;
        tp_gbuffer_clear(&band);
        tp_frame_allow_wide_solids(frame, &band, &frame->stats.dropped);
        tp_view_draw_solids(frame, view, &band);
        for (int32_t y = y0; y < y0 + BAND; y++)
            accumulate_row(frame, &band, y, texels + y / 2 * TP_OBJECT_CUBE_SIDE);
    }
    return box.x0 <= box.x1;
}

static void draw_cube_map(tp_frame *frame, void *mine)
{
    static const int32_t turn[TP_OBJECT_CUBE_FACES][2] = { /* quarters: heading, pitch */
                                                           { 1, 0 },
                                                           { 3, 0 },
                                                           { 2, 0 },
                                                           { 0, 0 },
                                                           { 0, 1 }
    };
    cube_map *m = mine;
    const tp_fx level = tp_view_objects_water_level(frame);
    const uint32_t quarter = (uint32_t)1 << 30;
    bool seen = false;

    m->object_cube.colour = NULL;
    if (!tp_view_is_above_level(frame, level)
        || !tp_frame_has_module(frame, TP_MODULE_SOLID))
        return;
    const tp_vec3 point = set_cube_viewpoint(frame, &m->object_cube, level);
    for (uint32_t f = 0; f < TP_OBJECT_CUBE_FACES; f++) {
        tp_projection projection;
        tp_projection_init(&projection, point, (uint32_t)turn[f][0] * quarter,
                     (uint32_t)turn[f][1] * quarter, 90 * TP_FX_ONE,
                     frame->scene->camera.near, WIDE, WIDE);
        tp_view view = { .projection = &projection, .clipped = true,
                           .level = tp_projection_level_plane(&projection, level, 1) };
        seen |= draw_face(frame, m->samples, &view,
                          m->colour + f * TP_OBJECT_CUBE_SIDE * TP_OBJECT_CUBE_SIDE);
    }
    m->object_cube.colour = seen ? m->colour : NULL;
}

/* -- the module object_cube ---------------------------------------------------------- */

bool tp_object_cube_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->mirror.method == TP_MIRROR_CUBE
        && conditions->scene->water.reflection > 0 && conditions->above & TP_MODULE_SOLID;
}

static void *layout_cube(tp_arena *arena, const tp_module_conditions *conditions)
{
    const size_t texels = TP_OBJECT_CUBE_FACES * TP_OBJECT_CUBE_SIDE * TP_OBJECT_CUBE_SIDE;
    cube_map *m = tp_arena_alloc(arena, 1, sizeof *m),
             made = { .object_cube.colour = NULL };

    (void)conditions;
    made.colour = tp_arena_alloc(arena, texels, sizeof *made.colour);
    made.samples = tp_arena_alloc(arena, WIDE * BAND, 4 * sizeof *made.samples);
    if (m)
        *m = made;
    return m;
}

const tp_module tp_object_cube_module = {
    .name = "object cube", .id = TP_OBJECT_CUBE_ID, .is = TP_MODULE_EXACT,
    .trait = TP_TRAIT_objects, .enabled = tp_object_cube_enabled,
};

static void add_cube_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                           tp_shaders *list)
{
    (void)frame;
    if (tp_shaders_has(list, TP_AT_REFLECT))
        tp_shaders_add(list, TP_AT_OBJECTS, stage[0], mine);
}

const tp_drawing tp_object_cube_drawing = {
    .layout = layout_cube, .draw_map = draw_cube_map, .stages = add_cube_stage,
};
