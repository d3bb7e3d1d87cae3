/* SPDX-License-Identifier: MIT */
/* The boat's mesh, projected once a frame, drawn in every tile that it touches.
 *
 * Instead of the mesh into the world the camera is turned into the mesh's own frame:
 * a vertex then costs what a vertex of the world does. */
#include "frame/frame.h"
#include "asset/mesh.h"

static tp_dir3 turned(const tp_rotation *r, tp_dir3 d)
{
    tp_vec3 v = tp_rotate(r, (tp_vec3){ d.x, d.y, d.z });
    return (tp_dir3){ v.x, v.y, v.z };
}

static void turn_view(tp_frame *frame, const tp_pose *boat)
{
    const tp_rotation turn = tp_rotation_of(boat->heading, boat->pitch, boat->roll);
    const tp_rotation *r = &turn;
    tp_vec3 way = tp_vec3_sub(frame->lens.eye, boat->place);
    tp_view_axes *axes = &frame->shade.mesh;

    frame->boat_lens = frame->lens;
    frame->boat_lens.eye = tp_rotate(r, way);
    frame->boat_lens.right = turned(r, frame->lens.right);
    frame->boat_lens.up = turned(r, frame->lens.up);
    frame->boat_lens.ahead = turned(r, frame->lens.ahead);

    tp_dir3 light = turned(r, (tp_dir3){ frame->shade.world.lx * 65536,
                                         frame->shade.world.ly * 65536,
                                         frame->shade.world.lz * 65536 });
    axes->right = turned(r, frame->shade.world.right);
    axes->up = turned(r, frame->shade.world.up);
    axes->back = turned(r, frame->shade.world.back);
    axes->lx = light.x >> 16;
    axes->ly = light.y >> 16;
    axes->lz = light.z >> 16;
}

/* Held within 4 km: the eye may be 24 km away, and their difference is 16.16 too. */
static tp_fx scaled(tp_fx x, tp_fx scale)
{
    const int64_t most = 4000 * TP_FX_ONE;
    int64_t metres = ((int64_t)x * scale + 0x8000) >> 16;
    return (tp_fx)(metres > most ? most : metres < -most ? -most : metres);
}

static tp_view_corner view_of(const tp_frame *frame, const tp_mesh_vertex *vertex)
{
    tp_fx scale = frame->scene->boat.scale;
    tp_vec3 p = { scaled(vertex->position.x, scale), scaled(vertex->position.y, scale),
                  scaled(vertex->position.z, scale) };
    tp_view_corner c;

    tp_lens_view(&frame->boat_lens, p, &c);
    c.s = vertex->s;
    c.t = vertex->t;
    c.n[0] = (int16_t)tp_dir_x(vertex->normal);
    c.n[1] = (int16_t)tp_dir_y(vertex->normal);
    c.n[2] = (int16_t)tp_dir_z(vertex->normal);
    return c;
}

static void widen(tp_grid_box *box, const tp_boat_vertex *vertex)
{
    int16_t x = (int16_t)(vertex->u >> 4), y = (int16_t)(vertex->v >> 4);

    box->x0 = x < box->x0 ? x : box->x0;
    box->x1 = x > box->x1 ? x : box->x1;
    box->y0 = y < box->y0 ? y : box->y0;
    box->y1 = y > box->y1 ? y : box->y1;
}

void tp_frame_place_boat(tp_frame *frame)
{
    const tp_mesh *mesh = frame->assets.boat;
    bool ahead = false, cut = false;

    frame->boat_seen = false;
    if (!mesh)
        return;
    turn_view(frame, &frame->drawn.boat);
    frame->boat_box = (tp_grid_box){ INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN };
    for (uint32_t i = 0; i < mesh->n_vertices; i++) {
        tp_boat_vertex *vertex = &frame->boat_vertex[i];
        tp_view_corner c = view_of(frame, &mesh->vertices[i]);
        ahead |= c.depth >= frame->lens.near;
        if (tp_lens_holds(&frame->boat_lens, &c)) {
            tp_lens_project(&frame->boat_lens, &c, &vertex->u, &vertex->v, &vertex->zi);
            widen(&frame->boat_box, vertex);
        } else {
            vertex->u = TP_GRID_CUT;
            cut = true;
        }
    }
    if (cut)
        frame->boat_box = (tp_grid_box){ INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX };
    frame->boat_seen = ahead;
    if (ahead) {
        frame->stats.vertices += mesh->n_vertices;
        frame->stats.triangles += mesh->n_faces;
    }
}

/* -- faces ------------------------------------------------------------------------ */

static uint32_t mark_of(uint32_t material)
{
    return TP_MARK_SOLID + (material < TP_MATERIALS ? material : TP_MATERIALS - 1);
}

static void draw(const tp_frame *frame, const tp_samples *tile, const tp_corner *a,
                 const tp_corner *b, const tp_corner *c, uint32_t f)
{
    const tp_mesh *mesh = frame->assets.boat;
    uint32_t material = mesh->faces[f].material;
    tp_fx opacity = mesh->materials[material].opacity;

    tp_tri_solid(tile, a, b, c, mark_of(material), f, (opacity * 16 + 0x8000) >> 16);
}

static void draw_clipped(const tp_frame *frame, const tp_samples *tile,
                         const tp_mesh_face *face, uint32_t f)
{
    tp_view_corner in[3], out[TP_CLIP_CORNERS];
    tp_corner corner[TP_CLIP_CORNERS];

    for (int k = 0; k < 3; k++)
        in[k] = view_of(frame, &frame->assets.boat->vertices[face->vertex[k]]);
    int count = tp_clip_triangle(&frame->boat_lens, in, out);
    for (int k = 0; k < count; k++)
        tp_corner_project(&frame->boat_lens, &out[k], &corner[k]);
    for (int k = 2; k < count; k++)
        draw(frame, tile, &corner[0], &corner[k - 1], &corner[k], f);
}

static tp_corner corner_of(const tp_boat_vertex *at, const tp_mesh_vertex *vertex)
{
    return (tp_corner){
        .u = at->u, .v = at->v, .zi = at->zi, .s = vertex->s, .t = vertex->t,
        .n = { (int16_t)tp_dir_x(vertex->normal), (int16_t)tp_dir_y(vertex->normal),
               (int16_t)tp_dir_z(vertex->normal) },
    };
}

/* Most faces of most tiles end at the first test: they lie in other rows. */
static void draw_face(const tp_frame *frame, const tp_samples *tile,
                      const tp_mesh_face *face, uint32_t f)
{
    const tp_mesh_vertex *vertex = frame->assets.boat->vertices;
    const tp_boat_vertex *a = &frame->boat_vertex[face->vertex[0]];
    const tp_boat_vertex *b = &frame->boat_vertex[face->vertex[1]];
    const tp_boat_vertex *c = &frame->boat_vertex[face->vertex[2]];
    int32_t top = 16 * tile->y0, bottom = 16 * tile->y1;

    if (a->u == TP_GRID_CUT || b->u == TP_GRID_CUT || c->u == TP_GRID_CUT) {
        draw_clipped(frame, tile, face, f);
        return;
    }
    if ((a->v < top && b->v < top && c->v < top)
        || (a->v >= bottom && b->v >= bottom && c->v >= bottom))
        return;
    tp_corner corner[3] = { corner_of(a, &vertex[face->vertex[0]]),
                            corner_of(b, &vertex[face->vertex[1]]),
                            corner_of(c, &vertex[face->vertex[2]]) };
    draw(frame, tile, &corner[0], &corner[1], &corner[2], f);
}

void tp_frame_draw_boat(const tp_frame *frame, tp_samples *tile)
{
    const tp_grid_box *box = &frame->boat_box;
    const tp_mesh *mesh = frame->assets.boat;

    if (!frame->boat_seen || box->x0 >= tile->x1 || box->x1 < tile->x0
        || box->y0 >= tile->y1 || box->y1 < tile->y0)
        return;
    tile->front_only = true;
    for (uint32_t f = 0; f < mesh->n_faces; f++)
        draw_face(frame, tile, &mesh->faces[f], f);
}
