/* SPDX-License-Identifier: MIT */
/* The inside of a frame: everything that drawing a tile reads. */
#ifndef TP_FRAME_INSIDE_H
#define TP_FRAME_INSIDE_H
#include "frame/drawing.h"
#include "frame/sight.h"
#include "frame/tools.h"
#include "geom/level.h"
#include "pixel/toned.h"
#include "raster/rows.h"
#include "scene/drawn.h"
#include "scene/plan.h"
#include "scene/sides.h"
#include "wave/wave.h"

/* Lines of points parallel to the horizon, see projected.c. */
typedef struct {
    tp_level_line horizon, top[TP_LEVEL_SIDES];     /* where the water ends */
    int     tops;
    int32_t start;              /* pixels from the horizon to the nearest line */
    tp_fx   towards;            /* the most that waves move a point nearer, m ... */
    tp_fx   share;              /* ... and of -d.y, aside, in pixels of the picture */
} tp_projected;

/* A sea without the waves that are too faint to be seen. */
typedef struct {
    tp_sea  sea;
    tp_turn phases[TP_WAVES];
} tp_thin_sea;

/* Memory behind the frame in its block, for all that the scene needed at init; NULL or 0 for
 * the rest.  A feature that is switched on later finds no memory and is left out. */
typedef struct tp_frame_parts {
    tp_grid         *grid;              /* NULL: no method goes by crossings */
    tp_reach         reach;             /* rungs that there is memory for */
    tp_level        *level;             /* of water that is level at first */
    tp_projected    *projected;
    uint32_t        *slopes;            /* of flat: points of the lattice, row by row */
    uint32_t         slope_cols;
    tp_thin_sea     *thin;
    struct tp_frame_lines *lines;       /* of the grid, lines.h; NULL: rows draw nothing */
    uint32_t         lacks;             /* modules that found too few marks */
    void           **module;            /* memory of each of the program's, or NULL */
    uint8_t         *mark;              /* first mark of each, or 0 */
    uint64_t         laid;              /* a bit for each that was on at init */
    tp_marks         marks;
    uint32_t         module_bytes;      /* of modules that draw no picture for the water, */
    uint32_t         look_bytes;        /* and of those that do */
} tp_frame_parts;

struct tp_frame {
    const tp_program *program;
    const tp_scene  *scene;
    tp_assets        assets;
    tp_config config;                   /* tile sizes filled in */
    uint32_t         across, down;      /* tiles */
    tp_draw_stats stats;
    tp_ram_use ram;
    tp_frame_parts   parts;

    tp_lens          lens;
    const tp_world  *world;
    tp_drawn         drawn;
    tp_surface       surface;
    tp_grid_view     grid_view;
    bool             cull_water;        /* the eye is above every crest */
    tp_rungs         rungs;             /* of this frame */
    tp_rungs         planned, asked;    /* asked: by the port, if `steered` */
    bool             steered;
    uint8_t          quality[sizeof ((tp_scene *)0)->quality];  /* that was planned for */
    tp_visibility    visibility;        /* of this frame */

    tp_sight         sight;             /* the picture itself */
    uint64_t         modules_on;        /* bits, in the order of the program's list */
    uint64_t         modules_drawn;     /* those of them that draw samples */

    bool             under;             /* the eye is in the water */
    uint8_t lacking;                    /* as tp_shaders.lacking, of all lists, or ... */
#define TP_LACKING_SKY 255              /* ... no module draws the sky that is named */

    tp_shade         shade;
    const tp_toned  *toned;             /* pixels are exposed as they are stored, */
    void (*store_toned)(const tp_toned *toned, uint16_t *to, const uint32_t *colours,
                        int count);     /* by this; or NULL */
};

/* The shader list of a kind of sample. */
static inline tp_shaders *tp_frame_list(const tp_frame *frame, uint32_t mark)
{
    return tp_marks_list(&frame->parts.marks, mark);
}

/* carve.c: the block's layout, the frame itself first; with an arena that only counts,
 * then with the block.  Sizes are left in `ram`. */
tp_frame *tp_frame_carve(const tp_program *program, tp_frame_parts *parts,
                         tp_ram_use *ram, tp_arena *arena, const tp_scene *scene,
                         tp_assets *assets, const tp_config *config);
tp_want tp_frame_want(const tp_program *program, const tp_frame_parts *parts,
                      const tp_scene *scene, const tp_assets *assets,
                      const tp_config *config);
bool tp_frame_is_coastal(const tp_program *program, const tp_scene *scene);

/* True if the water's crossings are streamed, not stored. */
bool tp_frame_streams(const tp_program *program, const tp_scene *scene);
tp_plan_input tp_frame_plan_input(const tp_program *program, const tp_scene *scene,
                                  const tp_assets *assets, const tp_config *config);

/* visibility.c: the plan's rungs, made at init and when the budget changes; by which
 * method this frame's water is drawn, and drawing it by that */
const struct tp_method *tp_frame_method(const tp_program *program,
                                        tp_visibility visibility);
void tp_frame_choose_rungs(tp_frame *frame);
tp_reach tp_frame_reach(const tp_program *program, const tp_scene *scene,
                        const tp_assets *assets, const tp_config *config);
void tp_frame_choose_visibility(tp_frame *frame);
void tp_frame_place_surface(tp_frame *frame);
void tp_frame_draw_surface(const tp_frame *frame, tp_samples *tile, void *memory);

/* lattice.c: water that is level at first.  Whether it is swells and no more, all below
 * the eye, and has memory; its outline; slopes of flat, and their memory. */
#define TP_LATTICE_CELL 8       /* pixels */
bool tp_frame_is_swell(const tp_frame *frame);
void tp_frame_place_level(tp_frame *frame);
void tp_frame_carve_slopes(tp_frame_parts *parts, tp_arena *arena, const tp_scene *scene,
                           const tp_config *config);
void tp_frame_place_slopes(tp_frame *frame);
/* water.c: the grid's lines, then the points of line j, from the first on.  A tile looks
 * at them by a window in its method's memory.  Cells [first, end) of row j: drawn, and the
 * box of what the lens leaves of them, of the line that was placed last and the one before
 * or of any that are stored. */
void tp_frame_begin_water(tp_frame *frame);
void tp_frame_place_line(tp_frame *frame, uint32_t j);
tp_grid_window tp_frame_window(const tp_frame *frame, void *memory);
void tp_frame_draw_cells(const tp_frame *frame, const tp_samples *tile,
                         tp_grid_window *window, uint32_t j, uint32_t first, uint32_t end);
tp_grid_box tp_frame_cells_box(tp_frame *frame, uint32_t j, uint32_t first, uint32_t end);

/* tile.c: row y of a tile, with the application's own spans in it */
void tp_frame_overlay_row(const tp_frame *frame, const void *samples, int32_t y,
                          void *row);

/* holds.c: whether rows draw this frame as triangles would */
bool tp_frame_rows_hold(tp_frame *frame);

/* True if walls stand around the pool in this picture. */
static inline bool tp_frame_has_tank(const tp_frame *frame)
{
    return tp_has_tank(frame->scene) && tp_frame_has_module(frame, TP_MODULE_WALLS);
}

/* tile.c: row y of samples as 0xffRRGGBB, 0 where nothing is, before any exposure; `to`
 * may be its normals. */
void tp_frame_colour_row(const tp_frame *frame, const tp_samples *tile, int32_t y,
                         uint32_t *to);

/* plan.c: the stages that the scene needs, and their numbers. */
void tp_frame_plan(tp_frame *frame);

/* True of a list of water that mirrors what is above it: the sky's module adds a stage at
 * TP_AT_REFLECT. */
static inline bool tp_frame_mirrors(const tp_frame *frame, const tp_shaders *list)
{
    return list->kind == TP_LIST_WATER && frame->scene->water.reflection > 0
        && tp_shaders_has(list, TP_AT_VIEW);
}

/* layer.c: a picture that drifts on the water */
tp_layer tp_frame_layer(const tp_frame *frame, const tp_texture *texture,
                        const tp_scene_map *map);
uint32_t tp_frame_repeats(tp_fx size);          /* a metre, Q0.32 over Q16.16 */
int32_t tp_frame_lod(const tp_frame *frame, tp_fx texels_per_metre, bool level_ground);

/* frame.c: the surface with pools that bend the light alone; it falls through all of them */
tp_surface tp_frame_lit_surface(const tp_frame *frame);

#include "frame/parts.h"
#endif
