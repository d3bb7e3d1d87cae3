/* SPDX-License-Identifier: MIT */
/*
 * Internals of a frame: all data read while drawing a tile.  renderers.h has its water
 * renderers, scanline_grid.h the lines of the scanline grid.
 */
#ifndef TP_FRAME_FRAME_H
#define TP_FRAME_FRAME_H
#include "frame/drawing.h"
#include "frame/tables.h"
#include "frame/tools.h"
#include "pixel/pixel.h"
#include "quality/prices.h"
#include "raster/fast_scanlines.h"
#include "raster/raster.h"
#include "view/fan.h"
#include "view/wave_models.h"
#include "waves/deep_water.h"
#include "world/pools.h"
#include "world/world.h"

/* Data of the screen grid: lines of points parallel to the horizon, see screen_grid.c. */
typedef struct {
    tp_level_line horizon, top[TP_LEVEL_SIDES];     /* outlines of the water's far end */
    int     tops;
    int32_t start;              /* from the horizon to the nearest line, px */
    tp_fx   towards;            /* largest wave motion towards the camera, m */
    tp_fx   share;              /* largest sideways motion, px per unit of -d.y */
} tp_projected;

/* Deep water without waves too faint to be seen. */
typedef struct {
    tp_deep_water deep;
    tp_turn       phases[TP_WAVES];
} tp_culled_deep_water;

/* Layout of the frame's block: memory for all features needed at init, NULL or 0 for the
 * others.  A feature switched on later finds no memory and is left out. */
typedef struct tp_frame_buffers {
    tp_grid         *grid;              /* NULL: no renderer stores grid vertices */
    tp_rung_mask     rung_mask;         /* rungs with memory */
    bool             coast;             /* the grid's vertices are displaced over a floor */
    tp_level        *level;             /* level plane of flat and screen grid */
    tp_projected    *projected;
    tp_own_table    *gradient;          /* of the sky; NULL: baked */
    tp_filtered_waves *filtered;        /* set by the grid's renderer; NULL: none */
    uint32_t        *slopes;            /* flat: slope grid, row by row */
    uint32_t         slope_cols;
    tp_culled_deep_water *culled;
    struct tp_frame_lines *lines;       /* scanline grid; NULL: rows cannot draw */
    struct tp_fast_lines *fast_lines;   /* for its fast rungs; NULL: rows are exact */
    struct tp_walk  *walk;              /* lines of walked water; NULL: it cannot draw */
    uint32_t         renderer_bytes;    /* scratch of the renderers for a tile's columns */
    uint32_t         lacks;             /* modules without enough stencil values */
    void           **module;            /* memory of each module of the program, or NULL */
    uint8_t         *mark;              /* first stencil value of each module, or 0 */
    uint64_t         laid;              /* bit i: module i was on at init */
    tp_marks         marks;
    uint32_t         module_bytes;      /* of modules without a map for the water */
    uint32_t         map_bytes;         /* of modules with a map, such as a mirror */
} tp_frame_buffers;

struct tp_frame {
    const tp_program *program;
    const tp_scene  *scene;
    tp_assets        assets;
    tp_config        config;            /* tile sizes filled in */
    uint32_t         across, down;      /* number of tiles */
    uint32_t         picture;           /* number of pictures begun */
    uint32_t         kept_bytes;        /* of lines in a scratch */
    tp_draw_stats    stats;
    tp_ram_use       ram;
    tp_frame_buffers buffers;

    tp_projection    projection;
    const tp_world  *world;
    tp_drawn         drawn;
    tp_surface       surface;
    tp_grid_view     grid_view;
    bool             cull_water;        /* true: the eye is above every crest */
    tp_rungs         rungs;             /* quality rungs of this frame */
    tp_rungs         asked;             /* by a tool; visibility AUTO: by the scene */
    tp_visibility    visibility;        /* water renderer of this frame */
    /* Finds the modules that are on and the rungs, which a change of the scene's numbers
     * changes.  NULL: the scene is a constant, all of it is known since init. */
    void (*read_scene)(tp_frame *frame);
    tp_cell_drawer  *draw_cell;         /* of the water, by quality.triangles; NULL: exact */
    tp_triangle_drawer *draw_triangle;  /* of the water; NULL: the program lacks it */

    const struct tp_draw_half_lines *half_lines;    /* named at init; NULL: none */
    uint32_t         extra_rows;        /* of a tile's samples, for half_lines */
    const struct tp_draw_packed_rows *packed_rows;  /* named at init; NULL: none */
    uint8_t          column_bits;       /* of fast rows and walked water, see tp_fast_rows;
                                         * 0: other water */
    const tp_level_linear *level_zi;    /* near / depth of level water, Q1.43, for these */
    /* Shades a run by the depth of level water; NULL: stages read that of the tile. */
    void (*level_keys)(const tp_frame *frame, const tp_shaders *list, tp_run *run);
    tp_grid_box      solids;            /* box of the picture's solids */

    tp_view          view;              /* render view of the picture itself */
    uint64_t         modules_on;        /* bits in the order of the program's list */
    uint64_t         modules_drawn;     /* enabled modules with samples */

    bool             under;             /* true: the eye is in the water */
    uint8_t          outlined;          /* 1 + the index of the module that draws
                                         * outlines; 0: tiles have none */
    uint8_t          lacking;           /* 1 + the index of the first module that lacks
                                         * something, or ... */
#define TP_LACKING_SKY     255          /* ... no module draws the scene's sky, */
#define TP_LACKING_SAMPLES 254          /* no water is known above positions, */
#define TP_LACKING_CELLS   253          /* no triangles of the grid are drawn, */
#define TP_LACKING_ROWS    252          /* the grid's rows are not placed */
    bool             needs_samples;     /* true: a module asks for the water above positions,
                                         * and the program has no samples of swells */
    tp_own_table    *own_table[TP_TABLE_COUNT];     /* in use; NULL: baked, or none */

    tp_shade         shade;
    const tp_rgb565_tone_map *tone_map; /* tone mapping and store in one table, or NULL */
    /* Writes pixels through `toned`; or NULL. */
    tp_tone_mapped_store *store_tone_mapped;
};

/* Returns the shader list of a stencil value. */
static inline tp_shaders *tp_frame_list(const tp_frame *frame, uint32_t mark)
{
    return tp_marks_list(&frame->buffers.marks, mark);
}

/* Counts something as dropped; `who`: as tp_frame.lacking. */
static inline void tp_frame_count_lack(tp_frame *frame, uint8_t who)
{
    frame->stats.dropped++;
    if (!frame->lacking)
        frame->lacking = who;
}

/* frame.c: a frame as found from a config and a scene; `frame` points into the struct. */
typedef struct {
    tp_baked_frame frame;
    tp_config      config;
    tp_assets      assets;
    uint8_t        stencil[TP_MODULES];
} tp_found_frame;

/* Checks config and scene as tp_frame_bytes does.  TP_OK: *to is found. */
tp_status tp_frame_find(tp_found_frame *to, const tp_config *config, const tp_scene *scene,
                        tp_error *err);

/* True if the grid's vertices are displaced over a floor. */
bool tp_frame_has_coast(const tp_program *program, const tp_scene *scene);

/* True if a module asks for the water above positions: things in the water. */
bool tp_frame_asks_samples(const tp_program *program, tp_module_conditions conditions);

/* baked_frame.c: functions of tp_frame_maker.  tp_frame_module_conditions returns the
 * conditions that decide if a module is on, for a frame. */
size_t tp_baked_frame_bytes(const tp_baked_frame *known);
tp_status tp_baked_frame_init(tp_frame **out, const tp_baked_frame *known, void *memory,
                              size_t bytes, tp_error *err);
tp_module_conditions tp_frame_module_conditions(const tp_program *program,
                                                const tp_frame_buffers *buffers,
                                                const tp_scene *scene,
                                                const tp_assets *assets,
                                                const tp_config *config);

/* Returns a solid's colour in the light's colour. */
static inline uint32_t tp_frame_lit_colour(const tp_frame *frame, uint32_t colour)
{
    return tp_colour_times(colour, (uint32_t)frame->scene->light.colour);
}

/* True if the water's grid vertices are streamed, not stored. */
bool tp_frame_is_grid_streamed(const tp_program *program);

/* visibility.c: the rungs of a frame, those with memory, the renderer of this frame's water,
 * and drawing by it. */
const struct tp_water_renderer *tp_frame_renderer(const tp_program *program,
                                                  tp_visibility visibility);
void tp_frame_choose_rungs(tp_frame *frame);
tp_rungs tp_frame_named_rungs(const tp_scene *scene);       /* by the scene, or exact */
tp_rung_mask tp_frame_rung_mask(tp_rungs named);
void tp_frame_choose_visibility(tp_frame *frame);
void tp_frame_place_surface(tp_frame *frame);
void tp_frame_draw_surface(const tp_frame *frame, tp_gbuffer *tile, void *memory);

/* Draws the surface into a tile without solids, which need not be cleared, if the renderer
 * can; else returns false.  *found receives the rows without and with sky. */
bool tp_frame_draw_surface_alone(const tp_frame *frame, const tp_gbuffer *tile,
                                 void *memory, tp_water_rows *found);

/* slope_grid.c: the level plane and the slope grid of flat water.
 * tp_frame_can_use_level_plane: true if swells of deep water alone move the water (no
 * rings, pools, tank or coastal water), the eye is above all crests, and memory for the
 * level plane was laid out.  The other functions place the level plane, lay out the slopes'
 * memory, and compute the slopes. */
#define TP_LATTICE_CELL 8       /* cell side, px */
bool tp_frame_can_use_level_plane(const tp_frame *frame);
void tp_frame_place_level(tp_frame *frame);
void tp_frame_layout_slopes(tp_frame_buffers *buffers, tp_arena *arena,
                            const tp_scene *scene, const tp_config *config);
void tp_frame_place_slopes(tp_frame *frame);

/* grid_rows.c: baked rows of the grid.  tp_frame_use_baked_rows sets them, and counts them
 * as dropped if the frame's numbers are others.  tp_frame_pack_rows returns the rows placed
 * last as a table without its numbers' memory: `entries` has TP_FRAME_ROWS_WORDS, *count
 * receives how many are filled, 0 if such water cannot be baked. */
#define TP_ROWS_NUMBERS 21
#define TP_FRAME_ROWS_WORDS(rows) (5 + 7 * (rows) + 3 * (TP_ROUGH_STEPS + 1))
bool tp_frame_rows_are_baked(const tp_assets *assets, uint32_t vertices);  /* this budget */
void tp_frame_use_baked_rows(tp_frame *frame);
const tp_filtered_waves *tp_frame_filtered_waves(const tp_frame *frame);    /* or NULL */
void tp_frame_pack_rows(const tp_frame *frame, int32_t numbers[TP_ROWS_NUMBERS],
                        int32_t *entries, uint32_t *count);

static inline bool tp_frame_has_grid_rows(const tp_frame *frame)
{
    const tp_grid *grid = frame->buffers.grid;
    return frame->program->draw.grid_rows || (grid && !grid->fan->placed);
}

/* grid_water.c: starts the grid's lines, then places the points of line j, in order
 * from 0.  A tile reads them through a window in its renderer's memory. */
void tp_frame_begin_grid(tp_frame *frame);
void tp_frame_place_grid_line(tp_frame *frame, uint32_t j);
tp_grid_window tp_frame_grid_window(const tp_frame *frame, const tp_gbuffer *tile,
                                    void *memory);

/* scanline_grid.c: true if scanline water draws this frame as triangles would. */
bool tp_frame_can_draw_rows(tp_frame *frame);

/* True if walls stand around the pool in this picture. */
static inline bool tp_frame_has_tank(const tp_frame *frame)
{
    return tp_has_tank(frame->scene) && tp_frame_has_module(frame, TP_MODULE_WALLS);
}

/* Returns the index, in words, of a tile's first sample in the scratch. */
static inline size_t tp_frame_first_sample(const tp_frame *frame)
{
    return frame->kept_bytes / sizeof(uint32_t);
}

/* tile.c: returns the lines that the tile's strip keeps, for lines of so many bytes; NULL:
 * none.  They lie first in the scratch, before the tile's samples. */
tp_kept_lines *tp_frame_kept_lines(const tp_frame *frame, const tp_gbuffer *tile,
                                   uint32_t line_bytes);

/* tile.c: sets up the run at (x, y) and returns its shader list; shades a run; lets the
 * application draw on the colours of row y.  alike: the whole row of the tile has one
 * stencil value.  level: water is shaded by the depth of level water if the stages read
 * that in tiles without the depth of the drawn water; mirrored objects would come off their
 * hulls by it. */
const tp_shaders *tp_frame_begin_run(const tp_frame *frame, const tp_gbuffer *tile, int32_t x,
                                     int32_t y, bool alike, tp_run *run);
void tp_frame_run_stages(const tp_frame *frame, const tp_shaders *list, tp_run *run);
void tp_frame_shade_level_run(const tp_frame *frame, const tp_shaders *list, tp_run *run);
static inline void tp_frame_shade_run(const tp_frame *frame, const tp_shaders *list,
                                      bool level, tp_run *run)
{
    if (level && frame->level_keys && TP_MARK(run->key[0]) == TP_MARK_WATER)
        frame->level_keys(frame, list, run);
    else
        tp_frame_run_stages(frame, list, run);
}
void tp_frame_overlay_row(const tp_frame *frame, const tp_gbuffer *tile, int32_t y,
                          uint32_t *colours);

/* tile.c: row y of a tile as 0xffRRGGBB before tone mapping, 0 for sky.  `to` may be the
 * row's normals. */
void tp_frame_colour_row(const tp_frame *frame, const tp_gbuffer *tile, int32_t y,
                         uint32_t *to);

/* outline_colours.c: the colours of outlines; see tp_gbuffer.outline. */
struct tp_outlining {
    /* Colours row y of the tile's outlines, by the stages before `end`.  Returns false if
     * none is visible. */
    bool (*colour_row)(const tp_frame *frame, const tp_gbuffer *tile, int32_t y,
                       uint32_t end, tp_run *run);
    /* Blends the coloured outlines over the colours of a run of the row, or over a row of
     * a planar map: there the sum is premultiplied by its alpha. */
    void (*blend)(const tp_gbuffer *tile, tp_run *run);
    void (*blend_map_row)(const tp_gbuffer *tile, int32_t y, uint32_t *to);
};
extern const struct tp_outlining tp_outlining_by_share;

/* The outlines of this frame's tiles; NULL: none. */
static inline const struct tp_outlining *tp_frame_outlining(const tp_frame *frame)
{
    return frame->outlined ? frame->program->modules[frame->outlined - 1].drawing->outlining
                           : NULL;
}

/* Lets solids draw outlines into the tile, which has the layer's memory. */
static inline void tp_frame_allow_outlines(const tp_frame *frame, tp_gbuffer *tile)
{
    if (frame->outlined)
        tile->outline_shift = tp_outline_shift(frame->shade.focal);
}

/* Sets the shares of the exact law of Fresnel for stages that reflect light; a module that
 * follows another law has set its own. */
static inline void tp_frame_use_fresnel(tp_frame *frame)
{
    if (!frame->shade.fresnel)
        frame->shade.fresnel = tp_fresnel_table;
}

/* shader_list.c: builds the shader lists for the scene, and their numbers. */
void tp_frame_set_up_shading(tp_frame *frame);

/* True if the list is water with a view stage and the scene reflects the sky.  The sky's
 * module then adds a stage at TP_AT_REFLECT. */
static inline bool tp_frame_reflects_sky(const tp_frame *frame, const tp_shaders *list)
{
    return list->kind == TP_LIST_WATER && frame->scene->water.reflection > 0
        && tp_shaders_has(list, TP_AT_VIEW);
}

/* shader_list.c: the sampling numbers of a drifting texture of the water. */
tp_layer tp_frame_layer(const tp_frame *frame, const tp_texture *texture,
                        const tp_scene_map *map);
uint32_t tp_frame_repeats_per_metre(tp_fx size); /* repeats a metre, Q0.32 over Q16.16 */
int32_t tp_frame_lod(const tp_frame *frame, tp_fx texels_per_metre, bool level_ground);

/* frame_begin.c.  Returns the surface that light falls through: the drawn surface, and also
 * the pools that only bend the normals of the drawn surface. */
tp_surface tp_frame_surface_with_all_pools(const tp_frame *frame);

/* -- keys of level water: level_keys.c ----------------------------------------------- */

/* Writes the keys of water at pixels (x, y) to (x + count - 1, y) by the depth of level
 * water. */
void tp_frame_write_level_keys(const tp_frame *frame, int32_t x, int32_t y, int32_t count,
                               uint32_t *key);

/* Sets the keys of a tile drawn alone. */
void tp_frame_write_alone_keys(const tp_frame *frame, const tp_fast_rows *rows,
                               const tp_water_rows *found);

#endif
