/* SPDX-License-Identifier: MIT */
#include "program_memory.h"
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "bake_assets.h"
#include "bake_world.h"
#include "features/boat/boat.h"
#include "frame/frame.h"
#include "program_links.h"

/* -- the layout of a board ----------------------------------------------------------- */

/* Bytes that a part of a frame takes less on a machine of 32 bits. */
static const struct {
    const char *part;
    uint32_t bytes;
} layouts[] = {
#include "layout_sizes.inc"
};

static size_t smaller(const char *part)
{
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++)
        if (strcmp(layouts[i].part, part) == 0)
            return layouts[i].bytes;
    return 0;
}

/* -- the scene's tables -------------------------------------------------------------- */

/* Bytes of structs on a machine of 32 bits, where pointers take 4. */
enum {
    POINTER = 4,
    TEXTURE = TP_TEXTURE_LEVELS * POINTER + 4,
    GREY = 8 + POINTER,
    MATERIAL = 6 * 4 + 2 * POINTER,
    MESH = 6 * POINTER + 2 * 12 + 4,
    SCENE = offsetof(tp_scene, pictures) + POINTER,
    CONFIG = 5 * 4 + 2 * POINTER + 3 * POINTER + 4,
    ASSETS = sizeof(tp_assets) / sizeof(void *) * POINTER,
    TABLES = 2 * TP_TABLE_COUNT * POINTER,
    WORLD = 3 * POINTER,
    WORLD_BYTES = 4,
    COPIED = 88, MADE = 40,             /* code of NAME_world_init */
    FRAME = sizeof(tp_baked_frame) - 4 * sizeof(void *) + 4 * POINTER,
    SCRATCH_BYTES = 4,
    FRAME_CODE = 48,                    /* of NAME_frame_bytes and NAME_frame_init */
    PROGRAM = sizeof(tp_program) / sizeof(void *) * POINTER,
    USE = sizeof(tp_use) / sizeof(void *) * POINTER,
    LACK = 3 * POINTER,
    UNIT = 8,                   /* of an arena */
};

/* Returns the bytes of the list of refused modules, with their names. */
static size_t refused_bytes(const component_set *refused)
{
    size_t sum = 0;

    for (size_t i = 0; i < component_count; i++)
        if (components[i].kind == COMPONENT_MODULE && refused->has[i])
            sum += LACK + (strlen(components[i].name) + POINTER) / POINTER * POINTER;
    return sum ? sum + LACK : 0;
}

/* Returns the bytes of a list's own tables: of modules, and of the stages of each; and of its
 * frame. */
static size_t list_bytes(const component_set *of)
{
    size_t sum = CONFIG + POINTER + PROGRAM + USE + FRAME + SCRATCH_BYTES, modules = 0;

    for (size_t i = 0; i < component_count; i++) {
        size_t stages = 0;
        if (components[i].kind == COMPONENT_MODULE && of->has[i])
            sum += USE, modules++;
        if (components[i].kind != COMPONENT_DRAWING || !of->has[i])
            continue;
        for (size_t k = i + 1;
             k < component_count && components[k].kind == COMPONENT_MODULE_STAGE; k++)
            stages++;
        sum += (stages ? stages : 1) * POINTER;
    }
    return sum + (modules + POINTER - 1) / POINTER * POINTER;   /* their stencil values */
}

static void add_assets(program_memory *m, const bake *b, const tp_assets *names)
{
    m->scene += SCENE + ASSETS;
    if (names->boat)
        m->scene +=
            MESH + bake_mesh_bytes(names->boat) + names->boat->n_materials * MATERIAL;
    for (uint32_t i = 0; i < b->n_pictures; i++)
        m->pictures += TEXTURE + bake_texture_bytes(b->pictures[i].texture);
    for (int i = 0; i < BAKE_GREYS; i++)
        if (bake_nth_grey(names, i))
            m->pictures += GREY + (bake_grey_bytes(bake_nth_grey(names, i)) + 3) / 4 * 4;
}

static void add_tables_and_world(program_memory *m, const bake_program *program, const bake *b,
                                 const tp_assets *names)
{
    m->scene += names->tables ? TABLES + bake_tables_bytes(&program->tables) : 0;
    m->scene += b->coastal_words * sizeof *b->coastal;
    const bool copied = bake_world_is_copied(program, names);
    m->scene += WORLD_BYTES + (copied ? WORLD + m->world : 0);
    m->code += FRAME_CODE;
    m->code += copied ? COPIED : MADE;
}

/* -- the frame ----------------------------------------------------------------------- */

/* True if a frame may draw its water by a renderer. */
static bool may_draw(const tp_frame *frame, const struct tp_water_renderer *renderer)
{
    for (int v = TP_VISIBILITY_TRIANGLES; v <= TP_VISIBILITY_WALK; v++)
        if (frame->buffers.rung_mask.visibility >> v & 1
            && tp_frame_renderer(frame->program, (tp_visibility)v) == renderer)
            return true;
    return false;
}

/* Takes from the vertices what the renderers lay out less. */
static void shrink_vertices(program_memory *m, const tp_frame *frame)
{
    static const struct {
        const struct tp_water_renderer *renderer;
        const char *part;
    } renderers[] = {
#define X(name) { &tp_method_##name, "tp_method_" #name },
        TP_METHOD_LIST(X)
#undef X
            { &tp_method_streamed, "tp_method_streamed" },
        { &tp_method_streamed_walk, "tp_method_streamed_walk" },
    };

    for (size_t i = 0; i < sizeof renderers / sizeof *renderers; i++)
        if (may_draw(frame, renderers[i].renderer))
            m->vertices -= smaller(renderers[i].part);
}

static size_t drawing_bytes(const tp_drawing *drawing,
                            const tp_module_conditions *conditions)
{
    tp_arena arena = tp_arena_init(NULL, 0);

    drawing->layout(&arena, conditions);
    return arena.used;
}

/* Returns what the tables that a drawing lays out take less.  The frame has a table if the
 * drawing takes less when an asset has it.  A table of words takes the same everywhere. */
static size_t tables_smaller(const tp_frame *frame, const tp_drawing *drawing)
{
    static const char *const name[TP_TABLE_COUNT] = {
#define X(name, numbers, type) "table_" #name,
        TP_TABLE_LIST(X)
#undef X
    };
    static const int32_t numbers[TP_TABLE_NUMBERS];
    tp_module_conditions own = tp_frame_module_conditions(
        frame->program, &frame->buffers, frame->scene, &frame->assets, &frame->config);
    size_t sum = 0;

    own.above = UINT32_MAX;
    for (int id = 0; drawing->layout && id < TP_TABLE_COUNT; id++) {
        tp_tables tables = frame->assets.tables ? *frame->assets.tables : (tp_tables){ 0 };
        tp_assets baked = frame->assets;
        tp_module_conditions less = own;
        tables.table[id] = (tp_table){ numbers, numbers };
        baked.tables = &tables;
        less.assets = &baked;
        if (drawing_bytes(drawing, &less) < drawing_bytes(drawing, &own))
            sum += smaller(name[id]);
    }
    return sum;
}

/* Returns what module `i` of the components lays out less. */
static size_t drawing_smaller(size_t i, const component_terms *terms,
                              const tp_assets *names)
{
    char symbol[64];
    size_t materials = 0;

    component_symbol(i, terms, symbol, sizeof symbol);
    if (strcmp(components[i].name, "boat") == 0 && names->boat)
        materials = names->boat->n_materials < TP_BOAT_MATERIALS
                        ? names->boat->n_materials
                        : TP_BOAT_MATERIALS;
    return smaller(symbol) + materials * smaller("material") / UNIT * UNIT;
}

/* Takes from tables and mirror what modules and shader lists lay out less. */
static void shrink_modules(program_memory *m, const tp_frame *frame,
                           const component_search_result *found,
                           const component_terms *terms, const tp_assets *names)
{
    size_t n = 0;

    for (size_t i = 0; i < component_count; i++) {
        if (components[i].kind == COMPONENT_MODULE && found->in.has[i])
            n++;
        if (components[i].kind != COMPONENT_DRAWING || !found->in.has[i]
            || !(frame->buffers.laid >> (n - 1) & 1))
            continue;
        const size_t less =
            drawing_smaller(i, terms, names)
            + tables_smaller(frame, frame->program->modules[n - 1].drawing);
        if (frame->program->modules[n - 1].drawing->draw_map)
            m->mirror -= less;
        else
            m->tables -= less;
    }
    m->tables -= n * sizeof(void *) - (n * POINTER + UNIT - 1) / UNIT * UNIT;
    m->tables -= smaller("lists");
    m->tables -= (frame->buffers.marks.lists - (TP_LIST_WATER + 1u)) * smaller("list")
                 / UNIT * UNIT;
}

static int add_frame(program_memory *m, const component_search_result *found,
                     const component_terms *terms, const tp_config *config,
                     const tp_scene *scene, const tp_assets *names)
{
    const size_t bytes = tp_frame_bytes(config, scene);
    void *const block = malloc(bytes);
    tp_error err = { 0 };
    tp_frame *frame;

    if (!block)
        return log_fail_memory(bytes);
    if (tp_frame_init(&frame, config, scene, block, bytes, &err)) {
        free(block);
        return log_fail_error("tidepool", &err);
    }
    const tp_ram_use ram = tp_frame_ram(frame);
    m->frame = ram.frame - ram.vertices - ram.tables - ram.mirror - smaller("frame");
    m->vertices = ram.vertices;
    m->tables = ram.tables;
    m->mirror = ram.mirror;
    m->tile = ram.scratch;
    shrink_vertices(m, frame);
    shrink_modules(m, frame, found, terms, names);
    free(block);
    return EXIT_DONE;
}

/* -- a program ----------------------------------------------------------------------- */

size_t program_memory_ram(const program_memory *m)
{
    size_t sum = 0;
#define X(use) sum += m->use;
    PROGRAM_RAM_LIST(X)
#undef X
    return sum;
}

size_t program_memory_flash(const program_memory *m)
{
    size_t sum = 0;
#define X(use) sum += m->use;
    PROGRAM_FLASH_LIST(X)
#undef X
    return sum;
}

int program_memory_measure(program_memory *m, const bake_program *program, const bake *b,
                           const tp_assets *names)
{
    const component_search_request *request = &program->request;
    component_list list;
    component_terms terms = request->terms;
    tp_config config = request->config;

    *m = (program_memory){ .scene = list_bytes(&program->found.in)
                                    + refused_bytes(&program->found.refused) };
    terms.world = bake_world_is_copied(program, names);
    m->world = bake_world_bytes(program, names);
    add_assets(m, b, names);
    add_tables_and_world(m, program, b, names);
    program_links_add(m, &program->found, &terms);
    components_list(&list, &program->found.in, &terms);
    config.program = &list.program;
    config.assets = names;
    return add_frame(m, &program->found, &terms, &config, &program->scene, names);
}

/* Returns the options by which bake would find the list, for a board without a user and for
 * pictures of at most so many columns. */
static options options_for_search(const options *o, uint32_t columns)
{
    enum { ROWS_LEAST = 16 };
    options small = *o;

    small.no_input = true;
    small.with = small.without = NULL;
    if (o->width > columns) {
        small.width = columns;
        small.height = o->height * columns / o->width;
        small.height = small.height < ROWS_LEAST ? ROWS_LEAST : small.height;
    }
    return small;
}

enum { COLUMNS = 320, COLUMNS_OF_MANY = 96 };

static int find_program(bake_program *program, bake *b, const tp_scene *scene,
                        const tp_assets *all, tp_assets *names, const options *o,
                        component_search_worlds *worlds)
{
    const options small = options_for_search(o, worlds ? COLUMNS_OF_MANY : COLUMNS);
    int code = bake_find_program(program, &small, scene, all, names, worlds);

    program->request.config.width = o->width;
    program->request.config.height = o->height;
    return code ? code : bake_list_pictures(b, names);
}

int program_memory_find(program_memory *m, const tp_scene *scene, const tp_assets *all,
                        const options *o, component_search_worlds *worlds)
{
    tp_assets names = *all;
    void *memory[TP_BAKED_LAYERS] = { NULL };
    tp_texture made[TP_BAKED_LAYERS];
    bake_program program = { .scene = *scene };
    bake b = { .name = "", .program = &program };
    tp_world *world = NULL;
    int code = bake_prepare(&names, scene, o, memory, made);

    code = code ? code : find_program(&program, &b, scene, all, &names, o, worlds);
    if (!code)
        world = bake_find_coastal(&b, o, &names);
    code = code ? code : program_memory_measure(m, &program, &b, &names);
    bake_close_program(&program);
    free(world);
    free(b.pictures);
    for (int i = 0; i < TP_BAKED_LAYERS; i++)
        free(memory[i]);
    return code;
}

/* -- as text ------------------------------------------------------------------------- */

void program_memory_print(const program_memory *m, FILE *out, const char *before)
{
#define NAME(use)  fprintf(out, "%9s", #use);
#define BYTES(use) fprintf(out, "%9zu", m->use);
    fprintf(out, "%s     ", before);
    PROGRAM_RAM_LIST(NAME)
    fprintf(out, "%9s\n%sRAM  ", "in all", before);
    PROGRAM_RAM_LIST(BYTES)
    fprintf(out, "%9zu\n%s     %9s%10s%9s%9s%9s\n", program_memory_ram(m), before, "code",
            "constants", "scene", "pictures", "in all");
    fprintf(out, "%sflash%9zu%10zu%9zu%9zu%9zu\n", before, m->code, m->constants,
            m->scene, m->pictures, program_memory_flash(m));
#undef NAME
#undef BYTES
}
