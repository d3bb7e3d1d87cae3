/* SPDX-License-Identifier: MIT */
/* Measures the memory that each part of a frame lays out, here and on a board of 32 bits:
 * structs with pointers are smaller there.  Lines "PART BYTES": the frame itself, its first
 * shader lists, one list more, each water renderer and drawing, a material of the boat; and
 * each table that an asset may replace, which the drawings' lines are without.
 *
 * Every part is laid out by a counting arena, by exact rungs and by the cheapest ones, with
 * and without a floor, whether the scene has its feature on or not; nothing is drawn. */
#include "frame/frame.h"
#include "frame/renderers.h"
#include "quality/rung_sets.h"

#if __STDC_HOSTED__
#include <stdio.h>

static void say(const char *part, size_t bytes)
{
    printf("%s %zu\n", part, bytes);
}
#else
#include "cortex-m/semihost.h"

static void say(const char *part, size_t bytes)
{
    semihost_write(part);
    semihost_decimal(" ", (uint32_t)bytes);
    semihost_write("\n");
}
#endif

enum { MATERIALS = 8 }; /* a whole number of an arena's units, whatever their size */

static const tp_texture texture = { .log2_w = 4, .log2_h = 4, .levels = 5 };
static const tp_grey grey = { .cols = 8, .rows = 8 };
static const tp_mesh meshes[2] = {
    { .n_vertices = 64, .n_faces = 64, .n_materials = 0 },
    { .n_vertices = 64, .n_faces = 64, .n_materials = MATERIALS },
};

static const int32_t numbers[TP_TABLE_NUMBERS];
static const tp_tables tables = { {
#define X(name, count, type) { numbers, numbers },
    TP_TABLE_LIST(X)
#undef X
} };

static const tp_assets assets[2] = {
#define T &texture
#define ALL(mesh)                                                                        \
    {                                                                                    \
        .boat = (mesh), .layer = { T, T, T }, .distortion = T, .ripple = T, .foam = T,   \
        .sky = { T, T, T, T, T, T }, .tank_wall = T, .tank_floor = T,                    \
        .floor_texture = T, .floor = &grey, .pool_mask = &grey, .field_mask = &grey,     \
        .tables = &tables                                                                \
    }
    ALL(&meshes[0]), ALL(&meshes[1])
};

/* Every named renderer, with the streamed ones. */
static const struct {
    const char *name;
    const struct tp_water_renderer *renderer;
} methods[] = {
#define X(name) { "tp_method_" #name, &tp_method_##name },
    TP_METHOD_LIST(X)
#undef X
        { "tp_method_streamed", &tp_method_streamed },
    { "tp_method_streamed_walk", &tp_method_streamed_walk },
};

static void measure_methods(const tp_scene *scene, const tp_config *config)
{
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        tp_frame_buffers buffers = {
            .rung_mask = tp_frame_rung_mask(tp_frame_named_rungs(scene)),
            .coast = tp_frame_has_coast(&tp_program_all, scene),
        };
        tp_arena arena = tp_arena_init(NULL, 0);
        if (!methods[i].renderer->layout)
            continue;
        methods[i].renderer->layout(&buffers, &arena, &tp_program_all, scene, config);
        say(methods[i].name, arena.used);
    }
}

static size_t drawing_bytes(const tp_use *use, const tp_module_conditions *conditions)
{
    tp_arena arena = tp_arena_init(NULL, 0);

    if (use->drawing->layout)
        use->drawing->layout(&arena, conditions);
    return arena.used;
}

/* Lines "table_NAME BYTES" of the tables that the drawings lay out. */
static void measure_tables(const tp_module_conditions *conditions)
{
    static const char *const name[TP_TABLE_COUNT] = {
#define X(name, numbers, type) "table_" #name,
        TP_TABLE_LIST(X)
#undef X
    };

    for (int id = 0; id < TP_TABLE_COUNT; id++) {
        tp_tables others = tables;
        tp_assets lacking = *conditions->assets;
        tp_module_conditions own = *conditions;
        size_t bytes = 0;
        others.table[id].entries = NULL;
        lacking.tables = &others;
        own.assets = &lacking;
        for (const tp_use *u = tp_program_all.modules; u->module; u++)
            if (u->drawing)
                bytes += drawing_bytes(u, &own) - drawing_bytes(u, conditions);
        if (bytes)
            say(name[id], bytes);
    }
}

/* Lines "drawing NAME BYTES": NAME as the module's. */
static void measure_drawings(const tp_scene *scene, const tp_config *config,
                             uint32_t shading)
{
    tp_module_conditions conditions = {
        .scene = scene,
        .assets = &assets[0],
        .water = &tp_program_all.water,
        .width = config->width,
        .height = config->height,
        .shadings = 1u << shading,
        .above = UINT32_MAX,
    };

    for (const tp_use *u = tp_program_all.modules; u->module; u++)
        if (u->drawing)
            say(u->module->name, drawing_bytes(u, &conditions));
    for (const tp_use *u = tp_program_all.modules; u->module; u++) {
        tp_module_conditions more = conditions;
        more.assets = &assets[1];
        if (u->drawing && drawing_bytes(u, &more) != drawing_bytes(u, &conditions))
            say("material",
                (drawing_bytes(u, &more) - drawing_bytes(u, &conditions)) / MATERIALS);
    }
    measure_tables(&conditions);
}

static void measure_lists(void)
{
    tp_marks marks;
    tp_arena first = tp_arena_init(NULL, 0), more = first;

    tp_marks_init(&marks);
    tp_marks_layout(&marks, &first, NULL, NULL, 0);
    say("lists", first.used);
    for (int i = 0; i < 8; i++)
        tp_marks_reserve_stencil_values(&marks, 1);
    tp_marks_layout(&marks, &more, NULL, NULL, 0);
    say("list", (more.used - first.used) / 8);
}

int main(void)
{
    const tp_config config = {
        .width = 320, .height = 240, .tile_width = 320, .tile_height = 16
    };
    static tp_scene scene;

    say("frame", sizeof(tp_frame));
    measure_lists();
    for (int i = 0; i < 4; i++) {
        tp_rung_set set;
        tp_scene_init(&scene);
        scene.floor.depth = i & 1 ? 4 * TP_FX_ONE : 0;
        for (int k = 0; k < TP_RUNG_KINDS; k++)
            set.of[k] = (uint8_t)(i & 2 ? tp_rung_kind_count(k) - 1 : 0);
        tp_rung_set_apply(&scene, &set);
        measure_methods(&scene, &config);
        measure_drawings(&scene, &config, (uint32_t)scene.quality.shading);
    }
    return 0;
}
