/* SPDX-License-Identifier: MIT */
/*
 * The boat: its course, its pose on the waves, its wake in a pool, its drawing, its
 * parameters.  A scene without a mesh has no boat.  Position and pose lie in tp_world,
 * because a camera aboard follows them.
 *
 *     boat_module.c    the module hull: the course
 *     buoyancy.c       the pose on the water
 *     wake.c           the module wake
 *     boat_drawing.c   the modules boat (the mesh) and lids
 *     boat_faces.c     the list of a view's faces
 *     boat_projection.c  the mesh's vertices and cut faces in a view
 *     boat_light.c     the light of vertices, for the fast rung of solids
 *     boat_outlines.c  the module outlines
 *     boat_neighbours.c  the faces beside each face, for outlines
 *     boat_stage.c     the lighting of the boat's materials
 *     boat_rungs.c     the cost of the boat's faces
 */
#ifndef TP_FEATURES_BOAT_BOAT_H
#define TP_FEATURES_BOAT_BOAT_H
#include "frame/drawing.h"
#include "pool/pool.h"
#include "raster/raster.h"
#include "shade/shade.h"
#include "tidepool/modules.h"
#include "world/module.h"
#include "world/world.h"

#define TP_BOAT_ID TP_MODULE_ID('b', 'o', 'a', 't')

#define TP_OUTLINES_ID TP_MODULE_ID('o', 'u', 't', 'l')

#define TP_BOAT_MATERIALS 192   /* further materials share the last stencil value */

/* A projected vertex of the mesh.  Two values of u mark a vertex without projection:
 * TP_GRID_NEEDS_CLIP, and TP_BOAT_OUTSIDE. */
typedef struct {
    int32_t  u, v;
    uint32_t zi;
} tp_boat_vertex;

/* Value of u for a vertex below the clip plane of the view.  A face with three such
 * vertices is not drawn.  A face with one or two is clipped. */
#define TP_BOAT_OUTSIDE (TP_GRID_NEEDS_CLIP + 1)

/* A render view in the mesh's frame. */
typedef struct {
    const tp_mesh *mesh;
    tp_vec3        low, high;   /* corners of the box of its positions */
    tp_projection  projection;
    tp_fx          metres;      /* metres per 1.0 of the mesh's positions */
    const tp_packed_dir *light; /* array, in the place of the vertices' normals; NULL */
    tp_outline_edge_drawer *draw_edge;  /* of outlines; NULL: the exact one */
} tp_boat_view;

/* Returns the normal of vertex i, or its light. */
static inline tp_packed_dir tp_boat_vertex_normal(const tp_boat_view *b, uint32_t i)
{
    return b->light ? b->light[i] : b->mesh->vertices[i].normal;
}

/* Sets the mesh and its box, from the positions themselves. */
void tp_boat_view_init(tp_boat_view *b, const tp_mesh *mesh);

/* Projects all vertices of the mesh; returns the box of the projected ones.  `plane`: clip
 * plane of the view, or NULL. */
tp_grid_box tp_boat_project_vertices(const tp_boat_view *b, const tp_view_plane *plane,
                                     tp_boat_vertex *vertex);

/* Clips face f; returns the number of corners, 0 if nothing is left. */
int tp_boat_clip_face(const tp_boat_view *b, const tp_view_plane *plane, uint32_t f,
                      tp_screen_vertex corner[TP_CLIP_VERTICES]);

/* Flags of an entry: set by the list, and by the module outlines. */
enum {
    TP_FACE_FILLS = 1,          /* may cover the centre of a pixel */
    TP_FACE_CUT = 2,            /* has corners to clip */
    TP_FACE_EDGED = 4           /* has edges of the outline */
};

/* The first and the last step of some rows. */
typedef struct {
    uint32_t first, last;
} tp_boat_rows;

/* The first and the last step of the rows of TP_BOAT_BLOCK entries in a row. */
typedef struct {
    uint8_t first, last;
} tp_boat_block;

#define TP_BOAT_BLOCK 16

/* The faces that the view placed last may draw; boat_faces.c. */
typedef struct {
    uint32_t *entry;            /* array, one for each face of the mesh */
    tp_boat_block *block;       /* array, one for each TP_BOAT_BLOCK entries */
    uint32_t  count;            /* entries [0, count): visible faces */
    uint32_t  lids, end;        /* entries [lids, end): lids */
    int32_t   last_step;        /* steps of rows are 0..last_step */
    uint8_t   row_bits, row_shift;
} tp_boat_faces;

tp_boat_faces tp_boat_faces_layout(tp_arena *arena, uint32_t count, uint32_t height);

/* Returns the steps of a tile's rows. */
tp_boat_rows tp_boat_rows_find(const tp_boat_faces *faces, const tp_gbuffer *tile);

/* Lists the faces of a view with these projected vertices.  `edges`: a word for each face,
 * for the module outlines; NULL: none. */
void tp_boat_faces_list(tp_boat_faces *faces, const tp_mesh *mesh,
                        const tp_boat_vertex *vertex, uint8_t *edges);

/* Sets the rows of entry i, a cut face, from its clipped polygon.  A polygon that covers no
 * pixel's centre from the front loses TP_FACE_FILLS. */
void tp_boat_faces_set_polygon(tp_boat_faces *faces, uint32_t i,
                               const tp_screen_vertex *corner, int count);

/* Sets the rows of all blocks, once the entries are complete. */
void tp_boat_faces_set_blocks(tp_boat_faces *faces);

/* Returns an entry's rows. */
static inline tp_boat_rows tp_boat_face_rows(const tp_boat_faces *faces, uint32_t entry)
{
    const uint32_t steps = (uint32_t)faces->last_step;
    return (tp_boat_rows){ entry >> (3 + faces->row_bits) & steps, entry >> 3 & steps };
}

/* Returns the first entry from i on, or `end`, that has a flag and may touch the rows. */
static inline uint32_t tp_boat_faces_next(const tp_boat_faces *faces, uint32_t i,
                                          uint32_t end, tp_boat_rows rows, uint32_t flag)
{
    while (i < end) {
        const tp_boat_block block = faces->block[i / TP_BOAT_BLOCK];
        const uint32_t next = i / TP_BOAT_BLOCK * TP_BOAT_BLOCK + TP_BOAT_BLOCK;
        const uint32_t stop = next < end ? next : end;
        if (block.first > rows.last || block.last < rows.first)
            i = stop;
        for (; i < stop; i++) {
            const uint32_t entry = faces->entry[i];
            const tp_boat_rows at = tp_boat_face_rows(faces, entry);
            if (entry & flag && at.last >= rows.first && at.first <= rows.last)
                return i;
        }
    }
    return end;
}

/* Returns the number of an entry's face. */
static inline uint32_t tp_boat_face_number(const tp_boat_faces *faces, uint32_t entry)
{
    return entry >> (3 + 2 * faces->row_bits);
}

/* Solids lit by their vertices, for quality.solids = fast; boat_light.c.  light_faces lights
 * the vertices of the listed faces, by the lobe of a light model or without one; `light` has
 * an entry for each vertex of the mesh. */
typedef enum { TP_BOAT_PHONG, TP_BOAT_BLINN, TP_BOAT_MATT } tp_boat_lobe;
struct tp_draw_fast_solids {
    bool (*draw_triangle)(const tp_gbuffer *tile, const tp_screen_vertex *a,
                          const tp_screen_vertex *b, const tp_screen_vertex *c,
                          uint32_t mark);
    tp_outline_edge_drawer *draw_edge;
    void (*light_faces)(const tp_boat_view *b, const tp_view_axes *axes, tp_boat_lobe lobe,
                        const tp_boat_faces *faces, tp_packed_dir *light);
};

/* Bits of tp_boat_outlines.edges besides 1, 2, 4 for the three edges. */
enum { TP_BOAT_FRONT = 8, TP_BOAT_CUT = 16, TP_BOAT_STEP = 64 };

/* The module outlines: edges between front and back faces in the view placed last.  Boats
 * without the module have plain outlines. */
typedef struct tp_boat_outlines {
    void (*find)(const struct tp_boat_outlines *o, const tp_boat_faces *faces,
                 const tp_boat_vertex *vertex, int32_t focal);
    void (*draw)(const struct tp_boat_outlines *o, const tp_boat_view *b,
                 const tp_boat_faces *faces, const tp_boat_vertex *vertex,
                 const tp_grid_box *box, tp_gbuffer *tile, uint32_t mark);
    const tp_mesh *mesh;
    uint16_t *neighbour;        /* of each face's three edges, or TP_BOAT_NO_FACE */
    uint8_t  *edges;            /* of each face: bit k: edge k is an outline */
} tp_boat_outlines;

#define TP_BOAT_NO_FACE UINT16_MAX
_Static_assert(TP_OUTLINE_FACES <= TP_BOAT_NO_FACE, "faces are numbered by 16 bits");

/* Finds the neighbours of all faces, and the faces that are steps.  `list` is scratch, a
 * word for each vertex of the mesh. */
void tp_boat_neighbours_find(const tp_boat_outlines *o, uint32_t *list);

/* Returns a word for each vertex of the module boat's mesh, free until a view is placed. */
uint32_t *tp_boat_words(void *boat);

/* Data of the boat's span stages; first in tp_run.mine. */
typedef struct {
    const tp_mesh  *mesh;
    const tp_solid *solid;      /* array, one for each material */
    tp_view_axes    axes;       /* view and light in the mesh's own frame */
} tp_boat_shading;

/* Places the boat on the water at tick 0 and after a change of the scene's numbers.
 * After a change the boat keeps its distance sailed and its turn from the scene's start.
 * A boat in dynamic mode or with boat.smooth > 0 also keeps its attitude. */
void tp_boat_place_on_water(const tp_program *program, tp_world *world,
                            const tp_scene *scene);

/* Advances the boat by one tick, after the water.  The caller has copied the last pose to
 * world->last_boat. */
void tp_boat_step(const tp_program *program, tp_world *world, const tp_scene *scene,
                  const tp_input *input);

/* Stirs the water of tp_boat_pool by the hull [E4].  Call after tp_boat_step. */
void tp_boat_stir_pool(tp_world *world, const tp_scene *scene);

/* Returns the pool stirred by the hull: [pool], else [field], else NULL. */
tp_pool *tp_boat_pool(tp_world *world);

/* -- buoyancy.c ---------------------------------------------------------------------- */

typedef enum { TP_BOW, TP_STERN, TP_PORT, TP_STARBOARD } tp_hull_point;

/* Sets the attitude to the water's own.  `water`: heights under the four points, within
 * +-2048 m. */
void tp_boat_snap_attitude(tp_boat_attitude *attitude, const tp_fx water[4]);

/* Moves the attitude for one tick towards the result of tp_boat_snap_attitude.
 * boat.mode and boat.smooth select the motion. */
void tp_boat_step_attitude(tp_boat_attitude *attitude, const tp_scene *scene,
                           const tp_fx water[4]);

/* Sets hull->immersion, the immersion: heights of the water minus the attitude. */
void tp_boat_set_immersion(tp_hull *hull, const tp_boat_attitude *attitude,
                           const tp_fx water[4]);

/* True if all numbers are in the ranges kept by the three functions above. */
bool tp_boat_attitude_is_valid(const tp_boat_attitude *attitude);
bool tp_boat_immersion_is_valid(const tp_hull *hull);

static inline tp_fx tp_fx_of_q40(int64_t x)
{
    return (tp_fx)((x + (1 << 23)) >> 24);
}

#define TP_BOAT_ROWS \
    TP_ROW_NAME("boat.mesh", boat.mesh, MESH, "OBJ file of the boat; empty: no boat"), \
    TP_ROW_NUMBER("boat.x", boat.x, "m", -8000, 8000, 0, \
        "start position, to the right of the origin"), \
    TP_ROW_NUMBER("boat.z", boat.z, "m", -8000, 8000, -12, \
        "start position, from the origin towards the viewer"), \
    TP_ROW_HEADING("boat.heading", boat.heading, 0, \
        "start direction of the bow, clockwise from -z"), \
    TP_ROW_NUMBER("boat.scale", boat.scale, "", 0.001, 100, 1, \
        "metres per unit of the mesh"), \
    TP_ROW_NUMBER("boat.lift", boat.lift, "m", -50, 50, 0, \
        "height of the mesh above the water"), \
    TP_ROW_NUMBER("boat.length", boat.length, "m", 0.1, 200, 10, \
        "distance between the points at bow and stern that sample the water"), \
    TP_ROW_NUMBER("boat.beam", boat.beam, "m", 0.1, 200, 3, \
        "distance between the points at both sides that sample the water"), \
    TP_ROW_CHOICE("boat.mode", boat.mode, "kinematic|dynamic", TP_BOAT_DYNAMIC, \
        TP_BOAT_KINEMATIC, \
        "kinematic: follows the water; dynamic: floats by its weight"), \
    TP_ROW_NUMBER("boat.smooth", boat.smooth, "s", 0, 10, 0, \
        "time constant with which the boat follows the water"), \
    TP_ROW_NUMBER("boat.draft", boat.draft, "m", 0.05, 20, 0.6, \
        "depth of the hull in the water at rest"), \
    TP_ROW_NUMBER("boat.drag", boat.drag, "", 0, 2, 0.3, \
        "damping of heave, roll and pitch; 1: critical, no overshoot"), \
    TP_ROW_NUMBER("boat.speed", boat.speed, "m/s", -30, 30, 0, \
        "speed without any input"), \
    TP_ROW_NUMBER("boat.rudder", boat.rudder, "degrees/s", -90, 90, 0, \
        "turn rate without any input"), \
    TP_ROW_NUMBER("boat.wake", boat.wake, "", 0, 1, 0.5, \
        "share of the displaced volume that makes waves in the pool"), \
    TP_ROW_CHOICE("boat.edges", boat.edges, "plain|smooth", TP_EDGES_SMOOTH, \
        TP_EDGES_SMOOTH, \
        "outlines: by pixel centres (plain), or by each pixel's covered share")

#endif
