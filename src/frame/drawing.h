/* SPDX-License-Identifier: MIT */
/* A module as a picture asks it: memory, numbers, stages.  scene/module.h has the module as
 * the world asks it, and says when the feature is on. */
#ifndef TP_FRAME_DRAWING_H
#define TP_FRAME_DRAWING_H
#include "base/arena.h"
#include "frame/marks.h"
#include "frame/sight.h"
#include "raster/raster.h"
#include "scene/module.h"
#include "tidepool/modules.h"

struct tp_frame;
struct tp_frame_parts;

/* All members may be NULL.  `mine` is the memory that `layout` returned, or NULL. */
typedef struct tp_drawing {
    /* Takes memory that lasts as long as the frame.  It is called twice: with an arena that
     * only counts, where it returns NULL, then with the frame's block. */
    void *(*layout)(tp_arena *arena, const tp_want *want);
    void  (*init)(struct tp_frame *frame, void *mine);

    /* The number of marks that its samples need, one for each kind that its stage tells
     * apart by tp_run.material.  NULL: it draws no samples.  If too few marks are left, the
     * module is not drawn. */
    uint32_t (*marks)(const tp_want *want);

    /* Adds what it raises to the water's surface of the drawn moment. */
    void  (*surface)(struct tp_frame *frame, void *mine, tp_surface *surface);

    /* Sets the numbers of a picture.  Camera, light and surface are known. */
    void  (*begin)(struct tp_frame *frame, void *mine);

    /* Draws a picture that the water's stages read, such as a mirror.  All lists and
     * numbers are known. */
    void  (*look)(struct tp_frame *frame, void *mine);

    /* Tells mirrors where its things are; the first module that has any counts. */
    bool  (*anchor)(const struct tp_frame *frame, const void *mine,
                    tp_sight_anchor *anchor);

    /* Projects its things as this sight sees them, and widens the box by the pixels that
     * they may cover.  Sights are placed and drawn one after the other, the picture's last:
     * `mine` holds what one of them needs.  Some modules are in the picture alone. */
    void  (*place)(struct tp_frame *frame, void *mine, tp_sight *sight, tp_grid_box *box);

    /* Draws the things of the sight that was placed last: samples with marks from `mark`
     * on.  The water is drawn after them; `over` draws over the finished water. */
    void  (*draw)(const struct tp_frame *frame, const void *mine, const tp_sight *sight,
                  tp_samples *samples, uint32_t mark);
    void  (*over)(const struct tp_frame *frame, const void *mine, const tp_samples *samples,
                  uint32_t mark);

    /* Adds stages to a list after the modules above.  The list of the module's own samples,
     * whose owner is this drawing, needs one at TP_AT_COLOUR; without it the module is not
     * drawn.  `stage` is the program's table of the module. */
    void  (*stages)(const struct tp_frame *frame, const void *mine, const tp_stage *stage,
                    tp_shaders *list);
} tp_drawing;

/* -- drawing.c: loops over the program's list ----------------------------------------- */

/* Lays out the memory of all enabled modules, their marks and all shader lists. */
void tp_frame_layout_modules(const tp_program *program, struct tp_frame_parts *parts,
                             tp_arena *arena, tp_want want);

/* Asks which modules are on in this picture; those alone take part in it. */
void tp_frame_enable_modules(struct tp_frame *frame);

void tp_frame_init_modules(struct tp_frame *frame);
void tp_frame_add_surface(struct tp_frame *frame, tp_surface *surface);
void tp_frame_begin_modules(struct tp_frame *frame);
void tp_frame_look_modules(struct tp_frame *frame);
void tp_frame_add_modules(const struct tp_frame *frame, tp_shaders *list);
void tp_frame_place_modules(struct tp_frame *frame, tp_sight *sight, tp_grid_box *box);
void tp_frame_draw_modules(const struct tp_frame *frame, const tp_sight *sight,
                           tp_samples *samples);
void tp_frame_draw_over(const struct tp_frame *frame, const tp_samples *samples);

/* Makes the lists of the modules' own samples. */
void tp_frame_list_modules(struct tp_frame *frame);

/* The anchor of the first module that has things; the origin if none has. */
tp_sight_anchor tp_frame_anchor(const struct tp_frame *frame);

/* True if a module draws samples before the water. */
bool tp_frame_has_solids(const struct tp_frame *frame);

/* True if this picture has a module with one of these bits of tp_module.is. */
bool tp_frame_has_module(const struct tp_frame *frame, uint32_t is);

/* The memory of a module that is on in this picture, or NULL; its table of stages. */
void *tp_frame_part(const struct tp_frame *frame, uint32_t id);
const tp_stage *tp_frame_stages(const struct tp_frame *frame, uint32_t id);

/* One mark: what most modules need. */
uint32_t tp_marks_one(const tp_want *want);
#endif
