/* SPDX-License-Identifier: MIT */
/* Draws the boat's mesh: projected once per frame, drawn in every tile that the mesh
 * touches.
 *
 * Faces of a material with opacity 0 are lids.  A lid is invisible and hides the water
 * behind it, for example inside a hull. */
#include "features/boat/boat.h"
#include "frame/frame.h"
#include "mesh/mesh.h"

/* Order of TP_STAGES_OF_boat. */
enum { STAGE_PHONG, STAGE_BLINN, STAGE_FAST };

/* The boat in one render view; valid until the next view is placed. */
typedef struct {
    tp_boat_shading look;       /* data of the span stages; first member */
    tp_boat_vertex *vertex;
    tp_boat_faces   faces;
    tp_solid       *solid;      /* array, one for each material */
    uint8_t        *gloss;      /* tables, TP_GLOSS bytes for each material */
    int32_t         model;      /* light model of the gloss tables */
    uint32_t        materials;  /* number of distinct materials */
    tp_boat_view    view;
    tp_grid_box     box;        /* covered pixels; empty: not visible */
    tp_packed_dir  *light;      /* array, one for each vertex; NULL: no fast rung */
    const struct tp_draw_fast_solids *fast; /* of this frame; NULL: exact solids */
} drawn_boat;

static tp_dir3 turned(const tp_rotation *r, tp_dir3 d)
{
    tp_vec3 v = tp_rotate(r, (tp_vec3){ d.x, d.y, d.z });
    return (tp_dir3){ v.x, v.y, v.z };
}

static void set_mesh_space_view(const tp_frame *frame, drawn_boat *b, const tp_view *view,
                                const tp_pose *boat)
{
    const tp_rotation turn =
        tp_rotation_from_angles(boat->heading, boat->pitch, boat->roll);
    const tp_rotation *r = &turn;
    tp_vec3 way = tp_vec3_sub(view->projection->eye, boat->place);
    tp_view_axes *axes = &b->look.axes;

    b->view.metres = tp_mesh_metres_per_unit(b->look.mesh, frame->scene->boat.scale);
    b->view.projection = *view->projection;
    b->view.projection.eye = tp_rotate(r, way);
    b->view.projection.right = turned(r, view->projection->right);
    b->view.projection.up = turned(r, view->projection->up);
    b->view.projection.ahead = turned(r, view->projection->ahead);

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

/* Finds the rows of the faces with cut corners, and widens the box by their clipped
 * parts. */
static void measure_cut_faces(drawn_boat *b, const tp_view *view, uint32_t first,
                              uint32_t end)
{
    tp_screen_vertex corner[TP_CLIP_VERTICES];

    for (uint32_t i = first; i < end; i++) {
        const uint32_t entry = b->faces.entry[i];
        if (!(entry & TP_FACE_CUT))
            continue;
        const uint32_t f = tp_boat_face_number(&b->faces, entry);
        const int count = tp_boat_clip_face(&b->view, tp_view_clip_plane(view), f, corner);
        tp_boat_faces_set_polygon(&b->faces, i, corner, count);
        for (int k = 0; k < count; k++)
            tp_box_widen(&b->box, corner[k].u, corner[k].v);
    }
}

/* Lists the faces of the view, and finds their outlines. */
static void list_faces(const tp_frame *frame, drawn_boat *b, const tp_view *view)
{
    const tp_boat_outlines *o =
        frame->outlined ? tp_frame_module_memory(frame, TP_OUTLINES_ID) : NULL;

    tp_boat_faces_list(&b->faces, b->look.mesh, b->vertex, o ? o->edges : NULL);
    measure_cut_faces(b, view, 0, b->faces.count);
    measure_cut_faces(b, view, b->faces.lids, b->faces.end);
    if (o && b->box.x0 <= b->box.x1)
        o->find(o, &b->faces, b->vertex, frame->shade.focal);
    tp_boat_faces_set_blocks(&b->faces);
}

static void project(tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box)
{
    drawn_boat *b = mine;
    const tp_mesh *mesh = b->look.mesh;

    set_mesh_space_view(frame, b, view, &frame->drawn.boat);
    b->box = tp_boat_project_vertices(&b->view, tp_view_clip_plane(view), b->vertex);
    list_faces(frame, b, view);
    b->view.light = b->fast ? b->light : NULL;
    b->view.draw_edge = b->fast ? b->fast->draw_edge : NULL;
    if (b->fast)
        b->fast->light_faces(&b->view, &b->look.axes,
                             !view->picture                ? TP_BOAT_MATT
                             : b->model == TP_LIGHT_BLINN ? TP_BOAT_BLINN
                                                          : TP_BOAT_PHONG,
                             &b->faces, b->light);
    if (b->box.x0 <= b->box.x1) {
        frame->stats.vertices += mesh->n_vertices;
        frame->stats.triangles += mesh->n_faces;
    }
    tp_box_join(box, &b->box);
}

/* -- faces --------------------------------------------------------------------------- */

static uint32_t clamp_material(uint32_t material)
{
    return material < TP_BOAT_MATERIALS ? material : TP_BOAT_MATERIALS - 1;
}

static bool is_invisible_lid(const tp_mesh *mesh, uint32_t material)
{
    return mesh->materials[material].opacity == 0;
}

/* One pass over the faces in one tile. */
typedef struct {
    const drawn_boat *boat;
    const tp_mesh    *mesh;
    const tp_view    *view;
    const tp_gbuffer *tile;
    uint32_t          mark;
} pass;

static void draw_triangle(const pass *p, const tp_screen_vertex corner[3], uint32_t f)
{
    TP_ASSERT(f < p->mesh->n_faces);
    uint32_t material = p->mesh->faces[f].material;
    tp_fx opacity = p->mesh->materials[material].opacity;

    if (p->boat->fast && opacity >= TP_FX_ONE
        && p->boat->fast->draw_triangle(p->tile, &corner[0], &corner[1], &corner[2],
                                        p->mark + clamp_material(material)))
        return;
    if (is_invisible_lid(p->mesh, material))
        tp_tri_depth_only(p->tile, &corner[0], &corner[1], &corner[2]);
    else
        tp_tri_solid(p->tile, &corner[0], &corner[1], &corner[2],
                     p->mark + clamp_material(material), f, (opacity * 16 + 0x8000) >> 16);
}

static void draw_clipped(const pass *p, uint32_t f)
{
    tp_screen_vertex corner[TP_CLIP_VERTICES];
    int count = tp_boat_clip_face(&p->boat->view, tp_view_clip_plane(p->view), f, corner);

    for (int k = 2; k < count; k++) {
        const tp_screen_vertex fan[3] = { corner[0], corner[k - 1], corner[k] };
        draw_triangle(p, fan, f);
    }
}

static tp_screen_vertex make_corner(const tp_boat_vertex *at, const tp_mesh_vertex *vertex,
                                    tp_packed_dir normal)
{
    return (tp_screen_vertex){
        .u = at->u, .v = at->v, .zi = at->zi, .s = vertex->s, .t = vertex->t,
        .n = { (int16_t)tp_dir_x(normal), (int16_t)tp_dir_y(normal),
               (int16_t)tp_dir_z(normal) },
    };
}

static void draw_face(const pass *p, uint32_t f)
{
    const tp_boat_vertex *at = p->boat->vertex;
    const tp_mesh_vertex *vertex = p->mesh->vertices;
    const uint32_t *v = p->mesh->faces[f].vertex;
    tp_screen_vertex corner[3];

    for (int k = 0; k < 3; k++)
        corner[k] = make_corner(&at[v[k]], &vertex[v[k]],
                                tp_boat_vertex_normal(&p->boat->view, v[k]));
    draw_triangle(p, corner, f);
}

/* Draws the faces of a range of the list. */
static void draw_faces(const drawn_boat *b, const tp_view *view, tp_gbuffer *samples,
                       uint32_t first, uint32_t end, uint32_t mark)
{
    const pass p = { b, b->look.mesh, view, samples, mark };
    const tp_boat_rows rows = tp_boat_rows_find(&b->faces, samples);

    samples->front_only = true;
    for (uint32_t i = first;
         (i = tp_boat_faces_next(&b->faces, i, end, rows, TP_FACE_FILLS)) < end; i++) {
        const uint32_t entry = b->faces.entry[i];
        if (entry & TP_FACE_CUT)
            draw_clipped(&p, tp_boat_face_number(&b->faces, entry));
        else
            draw_face(&p, tp_boat_face_number(&b->faces, entry));
    }
}

static void draw_outlines(const tp_frame *frame, const drawn_boat *b, tp_gbuffer *samples,
                          uint32_t mark)
{
    const tp_boat_outlines *o = tp_frame_module_memory(frame, TP_OUTLINES_ID);

    if (o && samples->outline_shift)
        o->draw(o, &b->view, &b->faces, b->vertex, &b->box, samples, mark);
}

static void draw(const tp_frame *frame, const void *mine, const tp_view *view,
                 tp_gbuffer *samples, uint32_t mark)
{
    const drawn_boat *b = mine;

    if (!tp_box_overlaps_tile(&b->box, samples))
        return;
    if (frame->outlined)
        draw_outlines(frame, b, samples, mark);
    draw_faces(b, view, samples, 0, b->faces.count, mark);
}

/* -- materials ----------------------------------------------------------------------- */

static void make_gloss(tp_frame *frame, void *mine)
{
    drawn_boat *b = mine;

    b->model = frame->scene->light.model;
    for (uint32_t i = 0; i < b->materials; i++) {
        uint8_t *gloss = b->gloss + (size_t)i * TP_GLOSS;
        tp_fx shininess = b->look.mesh->materials[i].shininess;
        if (b->model == TP_LIGHT_BLINN)
            tp_shade_gloss_blinn(gloss, shininess);
        else
            tp_shade_gloss(gloss, shininess);
    }
}

uint32_t *tp_boat_words(void *boat)
{
    const drawn_boat *b = boat;
    _Static_assert(sizeof *b->vertex >= sizeof(uint32_t), "a word for each vertex");

    return (uint32_t *)(void *)b->vertex;
}

static void init_boat(tp_frame *frame, void *mine)
{
    drawn_boat *b = mine;

    tp_boat_view_init(&b->view, b->look.mesh);
    make_gloss(frame, mine);
}

/* Sets the boat's materials: mipmap bias, maps and tables of highlights. */
static void begin_boat_materials(tp_frame *frame, void *mine)
{
    drawn_boat *b = mine;
    const tp_mesh *mesh = b->look.mesh;
    tp_fx metres = tp_mesh_metres_per_unit(mesh, frame->scene->boat.scale);

    frame->stats.dropped += mesh->n_materials - b->materials;
    b->fast = b->light && frame->scene->quality.solids == TP_RUNG_FAST
                      && tp_frame_module_stages(frame, TP_BOAT_ID)[STAGE_FAST]
                  ? frame->program->draw.fast_solids : NULL;
    if (b->model != frame->scene->light.model)
        make_gloss(frame, mine);
    for (uint32_t i = 0; i < b->materials; i++) {
        const tp_material *m = &mesh->materials[i];
        tp_fx texels = tp_fx_div(m->texels, metres);
        b->solid[i] = (tp_solid){
            .diffuse = tp_frame_lit_colour(frame, m->diffuse),
            .specular = m->specular,
            .lod = tp_frame_lod(frame, texels, false) + 96,  /* Q8: bias, or grain
                                                              * glitters */
            .bump = tp_clamp(m->bump, -16 * TP_FX_ONE, 16 * TP_FX_ONE) >> 8,
            .diffuse_map = m->diffuse_map,
            .normal_map = m->normal_map,
            .gloss = b->gloss + (size_t)i * TP_GLOSS,
        };
    }
}

/* -- the module ---------------------------------------------------------------------- */

/* Returns the number of stencil values: at least 1, also for a mesh without materials. */
static uint32_t count_marks(const tp_module_conditions *conditions)
{
    const uint32_t n = conditions->assets->boat->n_materials;
    return n == 0 ? 1 : n < TP_BOAT_MATERIALS ? n : TP_BOAT_MATERIALS;
}

static void *layout(tp_arena *arena, const tp_module_conditions *conditions)
{
    const tp_mesh *mesh = conditions->assets->boat;
    drawn_boat *b = tp_arena_alloc(arena, 1, sizeof *b), made = { .look.mesh = mesh };

    made.materials = mesh->n_materials < TP_BOAT_MATERIALS ? mesh->n_materials
                                                           : TP_BOAT_MATERIALS;
    made.vertex = tp_arena_alloc(arena, mesh->n_vertices, sizeof *made.vertex);
    made.faces = tp_boat_faces_layout(arena, mesh->n_faces, conditions->height);
    made.look.solid = made.solid = tp_arena_alloc(arena, made.materials,
                                                 sizeof *made.solid);
    made.gloss = tp_arena_alloc(arena, made.materials, TP_GLOSS);
    if (conditions->scene->quality.solids == TP_RUNG_FAST)
        made.light = tp_arena_alloc(arena, mesh->n_vertices, sizeof *made.light);
    if (b)
        *b = made;
    return b;
}

/* Returns the middle of two mesh coordinates in m.  project() clamps vertices to 4 km; with
 * the boat's position the sum is below 15 km.  The eye is at most 23 km away. */
static tp_fx scaled_middle(tp_fx low, tp_fx high, tp_fx scale)
{
    return (tp_fx)tp_clamp_abs(((int64_t)low + high) / 2 * scale >> 16, 4000 * TP_FX_ONE);
}

/* Sets the anchor of mirrors: the middle of the mesh, and the level of the waterline. */
static bool set_anchor(const tp_frame *frame, const void *mine, tp_view_anchor *anchor)
{
    const drawn_boat *b = mine;
    const tp_mesh *mesh = b->look.mesh;
    const tp_pose *boat = &frame->drawn.boat;
    const tp_fx scale = tp_mesh_metres_per_unit(mesh, frame->scene->boat.scale);
    const tp_rotation turn =
        tp_rotation_from_angles(boat->heading, boat->pitch, boat->roll);
    const tp_vec3 at = { scaled_middle(mesh->low.x, mesh->high.x, scale),
                         scaled_middle(mesh->low.y, mesh->high.y, scale),
                         scaled_middle(mesh->low.z, mesh->high.z, scale) };

    *anchor = (tp_view_anchor){
        .middle = tp_vec3_add(boat->place, tp_rotate_back(&turn, at)),
        .level = boat->place.y - frame->scene->boat.lift,
    };
    return true;
}

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    const drawn_boat *b = mine;
    const bool blinn = frame->scene->light.model == TP_LIGHT_BLINN;

    if (list->owner == &tp_boat_drawing)
        tp_shaders_add(list, TP_AT_COLOUR,
                       b->fast ? stage[STAGE_FAST]
                       : blinn && stage[STAGE_BLINN] ? stage[STAGE_BLINN]
                                                     : stage[STAGE_PHONG],
                       mine);
}

const tp_drawing tp_boat_drawing = {
    .layout = layout, .init = init_boat, .marks = count_marks,
    .begin = begin_boat_materials,
    .anchor = set_anchor, .project = project, .draw = draw, .stages = add_stages,
};

/* -- the module lids ----------------------------------------------------------------- */

bool tp_lids_enabled(const tp_module_conditions *conditions)
{
    const tp_mesh *mesh = conditions->assets ? conditions->assets->boat : NULL;

    for (uint32_t i = 0; mesh && i < mesh->n_materials; i++)
        if (is_invisible_lid(mesh, i))
            return true;
    return false;
}

/* Draws the lids after all solids that a lid may cover. */
static void draw_lids(const tp_frame *frame, const void *mine, const tp_view *view,
                      tp_gbuffer *samples, uint32_t mark)
{
    const drawn_boat *b = tp_frame_module_memory(frame, TP_BOAT_ID);

    (void)mine;
    if (b && view->picture && tp_box_overlaps_tile(&b->box, samples))
        draw_faces(b, view, samples, b->faces.lids, b->faces.end, mark);
}

const tp_module tp_lids_module = {
    .name = "lids", .id = TP_MODULE_ID('l', 'i', 'd', 's'), .enabled = tp_lids_enabled,
};

const tp_drawing tp_lids_drawing = { .draw = draw_lids };
const tp_stage tp_lids_stages[] = { NULL };
