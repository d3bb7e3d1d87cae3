/* SPDX-License-Identifier: MIT */
/* The buoy's picture: a body of two cones, a mast and a flag, lit from one side.  The
 * picture, mirrors and the refraction map draw the buoy by the same functions. */
#include "buoy.h"
#include "frame/frame.h"
#include "shade/colour.h"
#include "shade/material.h"

enum { SIDES = 8, BOTTOM = SIDES, TOP, MAST, TIP, LOW, POINTS };

/* Parts, distinguished by the stage through a sample's t. */
enum { BODY, POLE, FLAG };

typedef struct {
    tp_vec3  point[POINTS];     /* vertices, world, m */
    uint32_t colour[3];         /* colour of each part */
} buoy;

/* -- placement ----------------------------------------------------------------------- */

/* Eight directions around the buoy, also the normals of its sides; 512 is 1. */
static const int16_t around[SIDES][2] = { { 512, 0 }, { 362, 362 }, { 0, 512 },
    { -362, 362 }, { -512, 0 }, { -362, -362 }, { 0, -512 }, { 362, -362 } };

/* Converts a point of the upright buoy, in 16ths of its radius, to the world. */
static tp_vec3 leant(const buoy_pose *pose, const tp_scene *scene, int x, int y, int z)
{
    const tp_fx unit = scene->own[BUOY_SIZE] / 16;
    const tp_fx along = x * unit, up = y * unit, deep = z * unit;

    return (tp_vec3){
        scene->own[BUOY_X] + along + tp_fx_mul(up, pose->lean_x),
        pose->height + up - tp_fx_mul(along, pose->lean_x)
                          - tp_fx_mul(deep, pose->lean_z),
        scene->own[BUOY_Z] + deep + tp_fx_mul(up, pose->lean_z),
    };
}

static buoy_pose interpolate_pose(const buoy_state *state, tp_fx lag)
{
    return (buoy_pose){
        tp_interpolate(state->last.height, state->now.height, lag),
        tp_interpolate(state->last.lean_x, state->now.lean_x, lag),
        tp_interpolate(state->last.lean_z, state->now.lean_z, lag),
    };
}

/* Places the vertices at the drawn moment. */
static void begin(tp_frame *frame, void *mine)
{
    const tp_scene *scene = frame->scene;
    const buoy_state *state = tp_world_module_state(frame->world, BUOY_ID);
    buoy *b = mine;

    if (!state)
        return;
    const buoy_pose pose = interpolate_pose(state, frame->world->lag);
    for (int k = 0; k < SIDES; k++)
        b->point[k] = leant(&pose, scene, around[k][0] / 32, 2, around[k][1] / 32);
    b->point[BOTTOM] = leant(&pose, scene, 0, -16, 0);
    b->point[TOP] = leant(&pose, scene, 0, 24, 0);
    b->point[MAST] = leant(&pose, scene, 0, 72, 0);
    b->point[TIP] = leant(&pose, scene, 28, 62, 0);
    b->point[LOW] = leant(&pose, scene, 0, 52, 0);
    b->colour[BODY] = (uint32_t)scene->own[BUOY_COLOUR];
    b->colour[POLE] = 0x303030;
    b->colour[FLAG] = (uint32_t)scene->own[BUOY_FLAG];
}

/* Projects the vertices and widens the box.  A vertex outside of the frustum makes the box
 * unbounded. */
static void place(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    const buoy *b = mine;
    const int16_t no_normal[3] = { 0, 0, 0 };

    (void)frame;
    for (int k = 0; k < POINTS; k++) {
        const tp_view_vertex c =
            tp_solid_vertex_make(view->projection, b->point[k], no_normal);
        tp_screen_vertex p;
        if (!tp_projection_can_project(view->projection, &c)) {
            *box = (tp_grid_box){ INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX };
            return;
        }
        tp_projection_project(view->projection, &c, &p.u, &p.v, &p.zi);
        tp_box_widen(box, p.u - 16, p.v - 16);
        tp_box_widen(box, p.u + 16, p.v + 16);
    }
}

/* -- triangles ----------------------------------------------------------------------- */

typedef struct {
    const buoy       *b;
    const tp_view    *view;
    const tp_gbuffer *samples;
    uint32_t          mark;
} pen;

/* Draws a triangle; vertices are counter-clockwise, seen from the side of the normal. */
static void draw_triangle(const pen *to, const int corner[3], const int16_t n[3],
                          uint32_t part)
{
    tp_view_vertex in[3];

    for (int k = 0; k < 3; k++)
        in[k] = tp_solid_vertex_make(to->view->projection, to->b->point[corner[k]], n);
    tp_clipped_draw(to->view->projection, tp_view_clip_plane(to->view), to->samples, in,
                    to->mark, part);
}

static void draw_body(const pen *to)
{
    for (int k = 0; k < SIDES; k++) {
        const int next = (k + 1) % SIDES;
        const int above[3] = { next, k, TOP }, below[3] = { k, next, BOTTOM };
        const int16_t x = (int16_t)((around[k][0] + around[next][0]) / 3);
        const int16_t z = (int16_t)((around[k][1] + around[next][1]) / 3);
        const int16_t up[3] = { x, 240, z }, down[3] = { x, -300, z };
        draw_triangle(to, above, up, BODY);
        draw_triangle(to, below, down, BODY);
    }
}

/* Draws mast and flag as flat triangles; the caller switches culling off, and both sides
 * are visible. */
static void draw_mast(const pen *to)
{
    static const int16_t front[3] = { 0, 0, 511 }, side[3] = { 511, 0, 0 };
    static const int across[3] = { 4, 0, MAST }, along[3] = { 2, 6, MAST };
    static const int flag[3] = { LOW, TIP, MAST };
    pen thin = *to;
    buoy narrow = *to->b;

    for (int k = 0; k < SIDES; k += 2) {    /* a sixteenth as wide as the body */
        const tp_vec3 top = to->b->point[TOP], at = to->b->point[k];
        narrow.point[k] = (tp_vec3){ top.x + (at.x - top.x) / 16,
                                     top.y + (at.y - top.y) / 4,
                                     top.z + (at.z - top.z) / 16 };
    }
    thin.b = &narrow;
    draw_triangle(&thin, across, front, POLE);
    draw_triangle(&thin, along, side, POLE);
    draw_triangle(to, flag, front, FLAG);
}

static void draw(const tp_frame *frame, const void *mine, const tp_view *view,
                 tp_gbuffer *samples, uint32_t mark)
{
    const pen to = { mine, view, samples, mark };

    (void)frame;
    samples->front_only = true;
    draw_body(&to);
    samples->front_only = false;
    draw_mast(&to);
}

/* -- stage --------------------------------------------------------------------------- */

/* Shades a run by ambient light and sun.  Mast and flag take the sun from both sides. */
void tp_stage_buoy(const tp_shade *shade, tp_run *run)
{
    const buoy *b = run->mine;
    const tp_vec_q14 light = { shade->world.lx, shade->world.ly, shade->world.lz };

    for (int32_t i = 0; i < run->count; i++) {
        const int32_t nl = tp_vec_q14_dot(tp_vec_q14_unpack(run->n[i]), light);
        const int32_t lit = run->t[i] == BODY ? nl : tp_abs(nl);
        run->colour[i] = tp_colour_scale(
            b->colour[run->t[i]],
            (uint32_t)tp_lit_share(shade->ambient, tp_clamp(lit, 0, 16384)));
    }
}

static void add_stage(const tp_frame *frame, const void *mine, const tp_stage *stage,
                      tp_shaders *list)
{
    (void)frame;
    if (list->owner == &tp_buoy_drawing)
        tp_shaders_add(list, TP_AT_COLOUR, stage[0], mine);
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    (void)conditions;
    return tp_arena_alloc(arena, 1, sizeof(buoy));
}

const tp_drawing tp_buoy_drawing = {
    .layout = layout, .marks = tp_marks_one, .begin = begin, .project = place, .draw = draw,
    .stages = add_stage,
};
const tp_stage tp_buoy_stages[] = { tp_stage_buoy };
