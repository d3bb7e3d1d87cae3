/* SPDX-License-Identifier: MIT */
/*
 * The drawing half of a module: its callbacks, and the parts of a frame that they use:
 * render views, planar maps, shader lists, stencil values.  world/module.h has the
 * simulation half and decides if the feature is on.
 *
 * Each module has one shader list and one or more stencil values: the low bits of a
 * sample's key identify the module of the sample.
 */
#ifndef TP_FRAME_DRAWING_H
#define TP_FRAME_DRAWING_H
#include "base/base.h"
#include "raster/raster.h"
#include "shade/shade.h"
#include "tidepool/frame.h"
#include "tidepool/modules.h"
#include "view/grid.h"
#include "world/module.h"

/* -- render views: render_view.c ----------------------------------------------------- */

/*
 * Cameras that solids are drawn for.  The picture is one view.  Mirrors, refraction maps
 * and the faces of a cube map are other views, drawn before the picture; all views share
 * the memory of projected vertices.
 *
 *     tp_view_begin(frame, &view)                sets up shading for the view
 *     tp_view_project_solids(frame, &view)       projects all solids
 *     tp_view_draw_solids(frame, &view, tile)    draws one tile, any number of times
 */

typedef struct {
    const tp_projection *projection;
    bool          picture;      /* true: the picture itself */
    bool          clipped;      /* true: clipped to the inner side of `level` */
    bool          walls;        /* true: tanks and blocks are drawn too */
    tp_view_plane level;
} tp_view;

/* The target of the mirrors' views. */
typedef struct {
    tp_vec3 middle;             /* middle of the objects, world, m */
    tp_fx   level;              /* still water level there, m */
} tp_view_anchor;

/* Returns the clip plane of the view, or NULL. */
static inline const tp_view_plane *tp_view_clip_plane(const tp_view *view)
{
    return view->clipped ? &view->level : NULL;
}

static inline bool tp_box_overlaps_tile(const tp_grid_box *box, const tp_gbuffer *tile)
{
    return box->x0 < tile->x1 && box->x1 >= tile->x0 && box->y0 < tile->y1
        && box->y1 >= tile->y0 && box->x0 <= box->x1;
}

#define TP_BOX_NONE (tp_grid_box){ INT16_MAX, INT16_MAX, INT16_MIN, INT16_MIN }
#define TP_BOX_ALL  (tp_grid_box){ INT16_MIN, INT16_MIN, INT16_MAX, INT16_MAX }

static inline void tp_box_widen(tp_grid_box *box, int32_t u, int32_t v)
{
    TP_ASSERT(u >> 4 == (int16_t)(u >> 4) && v >> 4 == (int16_t)(v >> 4));
    int16_t x = (int16_t)(u >> 4), y = (int16_t)(v >> 4);

    box->x0 = x < box->x0 ? x : box->x0;
    box->x1 = x > box->x1 ? x : box->x1;
    box->y0 = y < box->y0 ? y : box->y0;
    box->y1 = y > box->y1 ? y : box->y1;
}

static inline void tp_box_join(tp_grid_box *to, const tp_grid_box *box)
{
    to->x0 = box->x0 < to->x0 ? box->x0 : to->x0;
    to->x1 = box->x1 > to->x1 ? box->x1 : to->x1;
    to->y0 = box->y0 < to->y0 ? box->y0 : to->y0;
    to->y1 = box->y1 > to->y1 ? box->y1 : to->y1;
}

/* Returns the height of still water, m, at the middle of the objects: the anchor of the
 * mirror views. */
tp_fx tp_view_objects_water_level(const tp_frame *frame);

/* Sets the shade's view numbers from a projection; the light stays the world's. */
void tp_view_set_shade(tp_frame *frame, const tp_projection *projection);

/* True if the camera is above water and above still water of height `level`: the water
 * then mirrors. */
bool tp_view_is_above_level(const tp_frame *frame, tp_fx level);

void tp_view_begin(tp_frame *frame, const tp_view *view);

/* Projects the solids of all modules for a view; returns the box of all covered pixels. */
tp_grid_box tp_view_project_solids(tp_frame *frame, tp_view *view);
void tp_view_draw_solids(const tp_frame *frame, const tp_view *view, tp_gbuffer *tile);

/* A view vertex without texture coordinates; the clipped screen vertices of a
 * triangle, fewer than 3 if nothing is left; drawing the clipped polygon, with t as its
 * stage expects. */
tp_view_vertex tp_solid_vertex_make(const tp_projection *projection, tp_vec3 at,
                                    const int16_t n[3]);
int tp_clipped_corners(const tp_projection *projection, const tp_view_plane *level,
                       const tp_view_vertex in[3], tp_screen_vertex to[TP_CLIP_VERTICES]);
void tp_clipped_draw(const tp_projection *projection, const tp_view_plane *level,
                     const tp_gbuffer *tile, const tp_view_vertex in[3], uint32_t mark,
                     uint32_t t);

/* -- planar maps: render_view.c ------------------------------------------------------ */

/*
 * Pictures of the picture's size, half or a quarter of it, sampled by the water's stages.
 * Maps are drawn before any tile, a few rows at a time to keep the G-buffer small.
 */

#define TP_PLANAR_BAND 4        /* rows drawn at a time */

typedef struct {
    uint32_t *colour;
    uint32_t *samples;          /* G-buffer of one band: four planes, cols wide */
    uint32_t  cols, rows;
    uint32_t  halvings;         /* of the picture's sides, as of a tp_planar_map */
    bool      packed;           /* colours are rgb565, two in a word */
} tp_planar_memory;

/* Allocates the map's memory; pointers are NULL if the arena only counts. */
void tp_planar_layout(tp_planar_memory *store, tp_arena *arena,
                      const tp_module_conditions *conditions, uint32_t halvings,
                      bool packed);

/* Sets *map to the part of the map covered by `box`.  Returns false if the part is
 * empty. */
bool tp_planar_set_bounds(const tp_planar_memory *store, const tp_grid_box *box,
                          tp_planar_map *map);

/* Returns the G-buffer of the band at row y0. */
tp_gbuffer tp_planar_gbuffer(const tp_planar_memory *store, const tp_planar_map *map,
                             int32_t y0);

/* Returns the G-buffer of a band from row y0 on, for a map whose colours are written from
 * its last row to its first.  The band lies in words of the colours that are not in use
 * yet, as tall as fits there: no object is drawn in more bands than needed.  `planes`: 4,
 * or 8 with outlines. */
tp_gbuffer tp_planar_tall_gbuffer(const tp_planar_memory *store, const tp_planar_map *map,
                                  int32_t y0, uint32_t planes);

/* -- shader lists: shader_list.c ----------------------------------------------------- */

/*
 * The span stages of a kind of sample, ordered by place.  A stage of a module finds the
 * module's data in tp_run.mine.
 */

#define TP_SHADERS_WATER 20     /* capacity of the water's list, end included */
#define TP_SHADERS_OTHER 6      /* capacity of any other list */

/* Place of a stage in a list.  Stages of the same place run in the order of addition. */
typedef enum {
    TP_AT_PLACE,                /* a distortion moves texture coordinates */
    TP_AT_COLOUR,               /* textures; fast stages without light */
    TP_AT_SLOPE,                /* ripples and pools change the normals */
    TP_AT_VIEW,                 /* view vectors; fast stages: colours in the water */
    TP_AT_LIGHT,
    TP_AT_REFRACT,              /* colours seen through the water */
    TP_AT_REFLECT,              /* the sky's reflection */
    TP_AT_OBJECTS,              /* reflections of objects, over the sky's */
    TP_AT_FRESNEL,              /* Fresnel share of the reflection */
    TP_AT_MATT,                 /* matt foam on the water */
    TP_AT_GLINT,
    TP_AT_AIR,                  /* haze */
    TP_AT_TONE,                 /* tone mapping */
    TP_AT_GLASS,                /* panes, over tone-mapped colours */
    TP_AT_END
} tp_shader_order;

typedef struct {
    tp_stage    stage;          /* NULL: end of the list */
    const void *mine;           /* data of its module, or NULL */
} tp_shader;

/* The kind of samples in a list. */
typedef enum {
    TP_LIST_SKY,
    TP_LIST_WATER,
    TP_LIST_FAST,               /* water, by fast stages alone */
    TP_LIST_UNDERSIDE,          /* water seen from below */
    TP_LIST_THINGS              /* land, a boat, drops ... */
} tp_list_kind;

typedef struct {
    tp_shader *shader;
    uint8_t   *order;           /* place of each stage */
    const struct tp_drawing *owner;     /* the module of these samples, or NULL */
    uint8_t    kind;            /* tp_list_kind */
    uint8_t    first;           /* first stencil value of the samples */
    uint8_t    count, room;
    bool       rippled;         /* true: a stage changes the slopes */
    bool       shines;          /* true: a stage leaves a glint */
    tp_stage   evens;           /* may leave even columns alone if it is the last, see
                                 * tp_shade.evens_only; or NULL */
    uint8_t    lacks;           /* stages wanted by the scene, missing in the program */
    uint8_t    lacking;         /* 1 + the index, in the program's list, of the first
                                 * module that lacks a stage; 0: no module lacks one */
} tp_shaders;

void tp_shaders_clear(tp_shaders *list);

/* Adds a stage after those of the same place.  NULL is not added but counted as lacking. */
void tp_shaders_add(tp_shaders *list, tp_shader_order order, tp_stage stage,
                    const void *mine);

/* Adds a stage at TP_AT_COLOUR without a module. */
static inline void tp_shaders_add_colour(tp_shaders *list, tp_stage stage)
{
    tp_shaders_add(list, TP_AT_COLOUR, stage, NULL);
}

/* Returns the wanted stage.  If the program lacks it, counts the lack and returns the
 * plainer stage. */
tp_stage tp_shaders_pick(tp_shaders *list, tp_stage wanted, tp_stage plainer);

/* True for water drawn by exact stages, seen from above or below. */
static inline bool tp_shaders_is_exact_water(const tp_shaders *list)
{
    return list->kind == TP_LIST_WATER || list->kind == TP_LIST_UNDERSIDE;
}

/* True if the list has a stage of the place. */
bool tp_shaders_has(const tp_shaders *list, tp_shader_order order);

/* -- stencil values: shader_list.c --------------------------------------------------- */

/*
 * Sky and water have fixed values.  The others are dealt to the modules enabled when a
 * frame is laid out, in the order of the program's list.
 */

#define TP_MARKS (1u << TP_MARK_BITS)

typedef struct {
    tp_shaders *list;           /* lists of sky, water, then the modules */
    uint8_t    *list_of;        /* list index of each stencil value */
    uint16_t    count;          /* stencil values dealt */
    uint8_t     lists;          /* number of lists */
} tp_marks;

/* Starts with the fixed stencil values and the lists of sky and water.  No module has a
 * value yet. */
void tp_marks_init(tp_marks *marks);

/* Deals `wanted` stencil values and one shader list to a module, and returns the first
 * value; 0: none is wanted, or too few are left. */
uint32_t tp_marks_reserve_stencil_values(tp_marks *marks, uint32_t wanted);

/* Allocates the memory of the lists; all stencil values are dealt.  Those of module i of
 * `modules` begin at first[i], 0: it has none. */
void tp_marks_layout(tp_marks *marks, tp_arena *arena, const tp_use *modules,
                     const uint8_t *first, uint32_t count);

static inline tp_shaders *tp_marks_list(const tp_marks *marks, uint32_t mark)
{
    TP_ASSERT(mark < marks->count);
    return &marks->list[marks->list_of[mark]];
}

/* -- callbacks of a module ----------------------------------------------------------- */

struct tp_frame;
struct tp_frame_buffers;

/* Callbacks of a module's drawing.  Any member may be NULL.  `mine` is the memory from
 * `layout`, or NULL. */
typedef struct tp_drawing {
    /* Allocates memory for the life of the frame.  Called twice: first with a counting
     * arena (the result is NULL), then with the frame's block. */
    void *(*layout)(tp_arena *arena, const tp_module_conditions *conditions);
    void  (*init)(struct tp_frame *frame, void *mine);

    /* Returns the number of stencil values for the module's samples, one for each material
     * (its stage reads tp_run.material).  NULL: the module draws no samples.  If too few
     * values are left, the module is not drawn. */
    uint32_t (*marks)(const tp_module_conditions *conditions);

    /* Adds the module's displacement to the water's surface of the drawn moment. */
    void  (*surface)(struct tp_frame *frame, void *mine, tp_surface *surface);

    /* Sets the module's numbers for one picture.  Camera, light and surface are known;
     * frame->under is known to the modules that follow `underwater` only. */
    void  (*begin)(struct tp_frame *frame, void *mine);

    /* Draws a picture for the water's stages, for example a mirror.  All shader lists and
     * numbers are known. */
    void  (*draw_map)(struct tp_frame *frame, void *mine);

    /* Tells mirrors where the module's objects are.  The first module with objects
     * counts. */
    bool  (*anchor)(const struct tp_frame *frame, const void *mine,
                    tp_view_anchor *anchor);

    /* Projects the module's objects for one render view, and widens the box by all pixels
     * of the objects.  Views are placed and drawn one after the other, the picture's view
     * last: `mine` stores the projection of one view only.  Some modules skip all other
     * views. */
    void  (*project)(struct tp_frame *frame, void *mine, tp_view *view, tp_grid_box *box);

    /* Draws the objects of the view placed last: samples with stencil values from `mark`
     * on.  The water is drawn after them. */
    void  (*draw)(const struct tp_frame *frame, const void *mine, const tp_view *view,
                  tp_gbuffer *samples, uint32_t mark);

    /* Adds stages to a list, after the modules earlier in the program's list.  The list of
     * the module's own samples (owner == this drawing) needs a stage at TP_AT_COLOUR;
     * without one the module is not drawn.  `stage` is the program's stage table of the
     * module. */
    void  (*stages)(const struct tp_frame *frame, const void *mine, const tp_stage *stage,
                    tp_shaders *list);

    /* The colours of outlines, if the module adds them to the tiles; frame.h. */
    const struct tp_outlining *outlining;
} tp_drawing;

/* -- drawing.c: loops over the program's modules ------------------------------------- */

/* Asks each module if it is on in this picture; only enabled modules take part. */
void tp_frame_enable_modules(struct tp_frame *frame);

void tp_frame_init_modules(struct tp_frame *frame);
void tp_frame_add_displacements(struct tp_frame *frame, tp_surface *surface);
void tp_frame_begin_modules(struct tp_frame *frame);
void tp_frame_draw_maps(struct tp_frame *frame);
void tp_frame_add_stages(const struct tp_frame *frame, tp_shaders *list);
void tp_frame_project_modules(struct tp_frame *frame, tp_view *view, tp_grid_box *box);
void tp_frame_draw_modules(const struct tp_frame *frame, const tp_view *view,
                           tp_gbuffer *samples);

/* Fills the shader lists of the modules' own samples. */
void tp_frame_fill_module_lists(struct tp_frame *frame);

/* Returns the anchor of the first module with objects; the origin if none has. */
tp_view_anchor tp_frame_objects_anchor(const struct tp_frame *frame);

/* True if a module draws samples before the water. */
bool tp_frame_has_solids(const struct tp_frame *frame);

/* True if a module with one of the bits `kinds` of tp_module.is is on in this picture. */
bool tp_frame_has_module(const struct tp_frame *frame, uint32_t kinds);

/* Memory and stage table of a module; NULL if the module is off in this picture. */
void *tp_frame_module_memory(const struct tp_frame *frame, uint32_t id);
const tp_stage *tp_frame_module_stages(const struct tp_frame *frame, uint32_t id);

/* Returns 1, the number of stencil values of most modules. */
uint32_t tp_marks_one(const tp_module_conditions *conditions);

#endif
