/* SPDX-License-Identifier: MIT */
/* The boat's mesh, projected once a frame, drawn in every tile that it touches.
 *
 * Instead of the mesh into the world the camera is turned into the mesh's own frame:
 * a vertex then costs what a vertex of the world does.
 *
 * Faces of a material with opacity 0 are lids: never seen, they keep water from what
 * they cover, the inside of a hull. */
#include "frame/frame.h"
#include "asset/mesh.h"

static tp_dir3 turned(const tp_rotation *r, tp_dir3 d)
{
    tp_vec3 v = tp_rotate(r, (tp_vec3){ d.x, d.y, d.z });
    return (tp_dir3){ v.x, v.y, v.z };
}

static void turn_view(tp_frame *frame, tp_sight *sight, const tp_pose *boat)
{
    const tp_rotation turn = tp_rotation_of(boat->heading, boat->pitch, boat->roll);
    const tp_rotation *r = &turn;
    tp_vec3 way = tp_vec3_sub(sight->lens->eye, boat->place);
    tp_view_axes *axes = &frame->shade.mesh;

    sight->boat_metres = tp_mesh_metres(frame->assets.boat, frame->scene->boat.scale);
    sight->boat_lens = *sight->lens;
    sight->boat_lens.eye = tp_rotate(r, way);
    sight->boat_lens.right = turned(r, sight->lens->right);
    sight->boat_lens.up = turned(r, sight->lens->up);
    sight->boat_lens.ahead = turned(r, sight->lens->ahead);

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

static tp_view_corner view_of(const tp_sight *sight, const tp_mesh_vertex *vertex)
{
    tp_fx scale = sight->boat_metres;
    tp_vec3 p = { scaled(vertex->position.x, scale), scaled(vertex->position.y, scale),
                  scaled(vertex->position.z, scale) };
    tp_view_corner c;

    tp_lens_view(&sight->boat_lens, p, &c);
    c.s = vertex->s;
    c.t = vertex->t;
    c.n[0] = (int16_t)tp_dir_x(vertex->normal);
    c.n[1] = (int16_t)tp_dir_y(vertex->normal);
    c.n[2] = (int16_t)tp_dir_z(vertex->normal);
    return c;
}

/* Beyond the level that cuts the sight; of a face all of whose corners are so nothing is
 * left, one with some must be clipped. */
#define OUTSIDE (TP_GRID_CUT + 1)

static void place_vertex(const tp_frame *frame, const tp_sight *sight, uint32_t i)
{
    tp_boat_vertex *to = &frame->parts.boat_vertex[i];
    tp_view_corner c = view_of(sight, &frame->assets.boat->vertices[i]);

    if (sight->cut && tp_view_height(&sight->level, &c) < 0)
        to->u = OUTSIDE;
    else if (tp_lens_holds(&sight->boat_lens, &c))
        tp_lens_project(&sight->boat_lens, &c, &to->u, &to->v, &to->zi);
    else
        to->u = TP_GRID_CUT;
}

static int clipped(const tp_frame *frame, const tp_sight *sight, const tp_mesh_face *face,
                   tp_corner corner[TP_CLIP_CORNERS])
{
    tp_view_corner in[3];

    for (int k = 0; k < 3; k++)
        in[k] = view_of(sight, &frame->assets.boat->vertices[face->vertex[k]]);
    return tp_clipped_corners(&sight->boat_lens, tp_sight_cut(sight), in, corner);
}

static void widen_by_face(const tp_frame *frame, tp_sight *sight, const tp_mesh_face *face)
{
    const tp_boat_vertex *vertex = frame->parts.boat_vertex;
    tp_corner corner[TP_CLIP_CORNERS];
    int cut = 0, outside = 0;

    for (int k = 0; k < 3; k++) {
        const tp_boat_vertex *v = &vertex[face->vertex[k]];
        cut += v->u <= OUTSIDE;
        outside += v->u == OUTSIDE;
        if (v->u > OUTSIDE)
            tp_box_widen(&sight->boat_box, v->u, v->v);
    }
    if (cut == 0 || outside == 3)
        return;
    for (int k = clipped(frame, sight, face, corner); k-- > 0; )
        tp_box_widen(&sight->boat_box, corner[k].u, corner[k].v);
}

static void place_boat(tp_frame *frame, tp_sight *sight)
{
    const tp_mesh *mesh = frame->assets.boat;

    turn_view(frame, sight, &frame->drawn.boat);
    for (uint32_t i = 0; i < mesh->n_vertices; i++)
        place_vertex(frame, sight, i);
    for (uint32_t f = 0; f < mesh->n_faces; f++)
        widen_by_face(frame, sight, &mesh->faces[f]);
    if (sight->boat_box.x0 <= sight->boat_box.x1) {
        frame->stats.vertices += mesh->n_vertices;
        frame->stats.triangles += mesh->n_faces;
    }
}

/* -- faces ------------------------------------------------------------------------ */

static uint32_t mark_of(uint32_t material)
{
    return TP_MARK_BOAT + (material < TP_MATERIALS ? material : TP_MATERIALS - 1);
}

static bool is_lid(const tp_mesh *mesh, uint32_t material)
{
    return mesh->materials[material].opacity == 0;
}

static void draw(const tp_frame *frame, const tp_samples *tile, const tp_corner *a,
                 const tp_corner *b, const tp_corner *c, uint32_t f)
{
    TP_ASSERT(f < frame->assets.boat->n_faces);
    const tp_mesh *mesh = frame->assets.boat;
    uint32_t material = mesh->faces[f].material;
    tp_fx opacity = mesh->materials[material].opacity;

    if (is_lid(mesh, material))
        tp_tri_lid(tile, a, b, c);
    else
        tp_tri_solid(tile, a, b, c, mark_of(material), f, (opacity * 16 + 0x8000) >> 16);
}

static void draw_clipped(const tp_frame *frame, const tp_sight *sight,
                         const tp_samples *tile, uint32_t f)
{
    tp_corner corner[TP_CLIP_CORNERS];
    int count = clipped(frame, sight, &frame->assets.boat->faces[f], corner);

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
static void draw_face(const tp_frame *frame, const tp_sight *sight,
                      const tp_samples *tile, uint32_t f)
{
    const tp_mesh_face   *face = &frame->assets.boat->faces[f];
    const tp_mesh_vertex *vertex = frame->assets.boat->vertices;
    const tp_boat_vertex *a = &frame->parts.boat_vertex[face->vertex[0]];
    const tp_boat_vertex *b = &frame->parts.boat_vertex[face->vertex[1]];
    const tp_boat_vertex *c = &frame->parts.boat_vertex[face->vertex[2]];
    int32_t top = 16 * tile->y0, bottom = 16 * tile->y1;

    if (a->u <= OUTSIDE || b->u <= OUTSIDE || c->u <= OUTSIDE) {
        if (a->u != OUTSIDE || b->u != OUTSIDE || c->u != OUTSIDE)
            draw_clipped(frame, sight, tile, f);
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

static void draw_faces(const tp_frame *frame, const tp_sight *sight, tp_samples *tile,
                       bool lids)
{
    const tp_mesh *mesh = frame->assets.boat;

    if (!tp_sight_touches(&sight->boat_box, tile))
        return;
    tile->front_only = true;
    for (uint32_t f = 0; f < mesh->n_faces; f++)
        if (is_lid(mesh, mesh->faces[f].material) == lids)
            draw_face(frame, sight, tile, f);
}

static void draw_boat(const tp_frame *frame, const tp_sight *sight, tp_samples *tile)
{
    draw_faces(frame, sight, tile, false);
}

static void draw_lids(const tp_frame *frame, const tp_sight *sight, tp_samples *tile)
{
    const tp_mesh *mesh = frame->assets.boat;
    bool any = false;

    for (uint32_t i = 0; mesh && i < mesh->n_materials; i++)
        any |= is_lid(mesh, i);
    if (any)
        draw_faces(frame, sight, tile, true);
}

/* -- materials ------------------------------------------------------------------------ */

static void make_gloss(tp_frame *frame)
{
    frame->model = frame->scene->light.model;
    for (uint32_t i = 0; i < tp_frame_materials(&frame->assets); i++) {
        uint8_t *gloss = frame->parts.gloss + (size_t)i * TP_GLOSS;
        tp_fx shininess = frame->assets.boat->materials[i].shininess;
        if (frame->model == TP_LIGHT_BLINN)
            tp_shade_gloss_blinn(gloss, shininess);
        else
            tp_shade_gloss(gloss, shininess);
    }
}

static void plan_boat(tp_frame *frame)
{
    const tp_mesh *mesh = frame->assets.boat;
    uint32_t count = tp_frame_materials(&frame->assets);
    tp_fx metres = tp_mesh_metres(mesh, frame->scene->boat.scale);

    if (frame->model != frame->scene->light.model)
        make_gloss(frame);
    for (uint32_t i = 0; i < count; i++) {
        const tp_material *m = &mesh->materials[i];
        tp_fx texels = tp_fx_div(m->texels, metres);
        frame->parts.solid[i] = (tp_solid){
            .diffuse = m->diffuse,
            .specular = m->specular,
            .lod = tp_frame_lod(frame, texels, false) + 96,  /* one texel: grain glitters */
            .bump = tp_clamp(m->bump, -16 * TP_FX_ONE, 16 * TP_FX_ONE) >> 8,
            .diffuse_map = m->diffuse_map,
            .normal_map = m->normal_map,
            .gloss = frame->parts.gloss + (size_t)i * TP_GLOSS,
        };
    }
}

const struct tp_draw_boat tp_draw_boat = {
    .solid = { place_boat, draw_boat }, .lids = draw_lids, .init = make_gloss,
    .plan = plan_boat,
};
