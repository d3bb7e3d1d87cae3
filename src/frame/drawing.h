/* SPDX-License-Identifier: MIT */
/* The drawing half of a module: memory, per-picture numbers, shader stages. scene/module.h
 * has the simulation half and decides if the feature is on. */
#ifndef TP_FRAME_DRAWING_H
#define TP_FRAME_DRAWING_H
#include "base/arena.h"
#include "frame/marks.h"
#include "frame/render_view.h"
#include "raster/raster.h"
#include "scene/module.h"
#include "tidepool/modules.h"

struct tp_frame;
struct tp_frame_buffers;

/* Callbacks of a module's drawing.  Any member may be NULL.  `mine` is the memory from
 * `layout`, or NULL. */
typedef struct tp_drawing {
    /* Allocates memory for the life of the frame.  Called twice: first with a counting
     * arena (the result is NULL), then with the frame's block. */
    void *(*layout)(tp_arena *arena, const tp_want *want);
    void  (*init)(struct tp_frame *frame, void *mine);

    /* Returns the number of stencil values for the module's samples, one for each material
     * (its stage reads tp_run.material).  NULL: the module draws no samples.  If too few
     * values are left, the module is not drawn. */
    uint32_t (*marks)(const tp_want *want);

    /* Adds the module's displacement to the water's surface of the drawn moment. */
    void  (*surface)(struct tp_frame *frame, void *mine, tp_surface *surface);

    /* Sets the module's numbers for one picture.  Camera, light and surface are known. */
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
     * on.  The water is drawn after them; `over` draws over the finished water. */
    void  (*draw)(const struct tp_frame *frame, const void *mine, const tp_view *view,
                  tp_gbuffer *samples, uint32_t mark);
    void  (*over)(const struct tp_frame *frame, const void *mine, const tp_gbuffer *samples,
                  uint32_t mark);

    /* Adds stages to a list, after the modules earlier in the program's list.  The list of
     * the module's own samples (owner == this drawing) needs a stage at TP_AT_COLOUR;
     * without one the module is not drawn.  `stage` is the program's stage table of the
     * module. */
    void  (*stages)(const struct tp_frame *frame, const void *mine, const tp_stage *stage,
                    tp_shaders *list);
} tp_drawing;

/* -- drawing.c: loops over the program's modules ------------------------------------- */

/* Lays out the memory of all enabled modules, their stencil values and all shader lists. */
void tp_frame_layout_modules(const tp_program *program, struct tp_frame_buffers *buffers,
                             tp_arena *arena, tp_want want);

/* Asks each module if it is on in this picture; only enabled modules take part. */
void tp_frame_enable_modules(struct tp_frame *frame);

void tp_frame_init_modules(struct tp_frame *frame);
void tp_frame_add_surface(struct tp_frame *frame, tp_surface *surface);
void tp_frame_begin_modules(struct tp_frame *frame);
void tp_frame_draw_maps(struct tp_frame *frame);
void tp_frame_add_stages(const struct tp_frame *frame, tp_shaders *list);
void tp_frame_place_modules(struct tp_frame *frame, tp_view *view, tp_grid_box *box);
void tp_frame_draw_modules(const struct tp_frame *frame, const tp_view *view,
                           tp_gbuffer *samples);
void tp_frame_draw_post_water(const struct tp_frame *frame, const tp_gbuffer *samples);

/* Fills the shader lists of the modules' own samples. */
void tp_frame_fill_module_lists(struct tp_frame *frame);

/* Returns the anchor of the first module with objects; the origin if none has. */
tp_view_anchor tp_frame_anchor(const struct tp_frame *frame);

/* True if a module draws samples before the water. */
bool tp_frame_has_solids(const struct tp_frame *frame);

/* True if a module with one of the bits `kinds` of tp_module.is is on in this picture. */
bool tp_frame_has_module(const struct tp_frame *frame, uint32_t kinds);

/* Memory and stage table of a module; NULL if the module is off in this picture. */
void *tp_frame_module_memory(const struct tp_frame *frame, uint32_t id);
const tp_stage *tp_frame_stages(const struct tp_frame *frame, uint32_t id);

/* Returns 1, the number of stencil values of most modules. */
uint32_t tp_marks_one(const tp_want *want);
#endif
