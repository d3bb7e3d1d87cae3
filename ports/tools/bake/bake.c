/* SPDX-License-Identifier: MIT */
/* tidepool bake: writes a scene and all files that it names as one file of constant C, for
 * machines without files. */
#include <ctype.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "app/cli/args.h"
#include "app/cli/command_help.h"
#include "app/cli/commands.h"
#include "app/files/log.h"
#include "app/files/output_file.h"
#include "app/scene/loaded_scene.h"
#include "bake_assets.h"
#include "bake_frame.h"
#include "bake_program.h"
#include "bake_world.h"
#include "program_memory.h"

#define IDENTIFIER_BYTES 48

/* The size of picture assumed for the plan, a board's. */
enum { WIDTH = 320, HEIGHT = 240 };

/* -- names --------------------------------------------------------------------------- */

/* True if a name has only letters, digits and underscores, begins with a letter, and does
 * not begin with "tp_". */
static bool can_be_name(const char *name)
{
    const size_t n = strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                  "0123456789_");
    return n > 0 && n < IDENTIFIER_BYTES && name[n] == '\0'
           && isalpha((unsigned char)*name) && strncmp(name, "tp_", 3) != 0
           && strcmp(name, "tp") != 0;
}

/* Makes an identifier: "three-swells" becomes three_swells; a name that is still no
 * identifier, as 64, becomes scene_64. */
static void make_identifier(const char *file, char name[IDENTIFIER_BYTES])
{
    snprintf(name, IDENTIFIER_BYTES, "%s", file);
    for (char *c = name; *c; c++)
        if (!isalnum((unsigned char)*c))
            *c = '_';
    if (can_be_name(name))
        return;
    char whole[IDENTIFIER_BYTES + 8];
    snprintf(whole, sizeof whole, "scene_%s", name);
    memcpy(name, whole, IDENTIFIER_BYTES);
    name[IDENTIFIER_BYTES - 1] = '\0';
}

/* -- the file's head ----------------------------------------------------------------- */

/* Prints text inside a comment: characters that could end or begin a comment, or continue a
 * line, become blanks. */
static void put_remark(FILE *out, const char *text)
{
    for (; *text; text++)
        fputc(strchr("*/\\", *text) || (unsigned char)*text < 32 ? ' ' : *text, out);
}

static void put_bytes(FILE *out, size_t *sum, size_t bytes, const char *part)
{
    fprintf(out, " * %9zu  %s\n", bytes, part);
    *sum += bytes;
}

static void put_contents(const bake *b, const tp_assets *names)
{
    size_t sum = 0;
    char   text[64];
    fprintf(b->out, " *     bytes\n");
    put_bytes(b->out, &sum, sizeof(tp_scene), "the scene's numbers");
    for (uint32_t i = 0; i < b->n_pictures; i++) {
        const tp_texture *t = b->pictures[i].texture;
        snprintf(text, sizeof text, "%s, %u x %u", b->pictures[i].name, 1u << t->log2_w,
                 1u << t->log2_h);
        put_bytes(b->out, &sum, bake_texture_bytes(t), text);
    }
    for (int i = 0; i < BAKE_GREYS; i++)
        if (bake_nth_grey(names, i))
            put_bytes(b->out, &sum, bake_grey_bytes(bake_nth_grey(names, i)), bake_greys[i].part);
    if (names->boat)
        put_bytes(b->out, &sum, bake_mesh_bytes(names->boat), "boat, without pictures");
    if (names->tables)
        put_bytes(b->out, &sum, bake_tables_bytes(&b->program->tables), "tables of frames");
    if (b->coastal_words)
        put_bytes(b->out, &sum, b->coastal_words * sizeof *b->coastal,
                  "waves over the floor");
    fprintf(b->out, " * %9zu  together", sum);
    if (b->program) {
        fputc('\n', b->out);
        bake_put_pieces(b->program, b->out);
        fprintf(b->out, " * Bytes on a Cortex-M4, without the port's own:\n");
        program_memory_print(b->memory, b->out, " * ");
    }
    fprintf(b->out, " */\n");
}

static void put_head(const bake *b, const options *o, const loaded_scene *s)
{
    fprintf(b->out, "/* ");
    put_remark(b->out, s->file.name);
    fprintf(b->out, ", a scene as constants: made by `tidepool bake`; do not edit.\n");
    if (o->texels)
        fprintf(b->out, " * No picture is larger than %" PRIu32 " texels a side.\n",
                o->texels);
    for (uint32_t i = 0; i < o->n_settings; i++) {
        fprintf(b->out, " * Changed: ");
        put_remark(b->out, o->settings[i]);
        fprintf(b->out, "\n");
    }
    fprintf(b->out, " *\n * A program declares:\n"
            " *     extern const tp_scene %s_scene;\n"
            " *     extern const tp_assets %s_assets;\n", b->name, b->name);
    if (b->program)
        fprintf(b->out,
                " *     extern const tp_program %s_program;\n"
                " *     extern const tp_config %s_config;\n"
                " *     extern const size_t %s_world_bytes, %s_scratch_bytes,"
                " %s_direct_scratch_bytes;\n"
                " *     tp_status %s_world_init(tp_world *world, size_t bytes,"
                " tp_error *err);\n"
                " *     size_t %s_frame_bytes(void);\n"
                " *     tp_status %s_frame_init(tp_frame **frame, void *memory, size_t bytes,"
                " tp_error *err);\n",
                b->name, b->name, b->name, b->name, b->name, b->name, b->name, b->name);
    fprintf(b->out, " *\n");
    put_contents(b, &s->assets.names);
    fprintf(b->out, "#include <tidepool/modules.h>\n");
}

/* -- the whole file ------------------------------------------------------------------ */

static void put_assets(const bake *b, const tp_assets *names)
{
    fprintf(b->out, "\nextern const tp_assets %s_assets;\n"
            "const tp_assets %s_assets = {\n", b->name, b->name);
    if (names->boat)
        fprintf(b->out, "    .boat = &%s_boat,\n", b->name);
    else
        fprintf(b->out, "    .boat = 0,\n");
    for (int i = 0; i < BAKE_PICTURES; i++) {
        const bake_picture *p = bake_find(b, bake_nth_texture(names, i));
        if (p)
            fprintf(b->out, "    .%s = &%s_%s,\n", bake_members[i].member, b->name,
                    p->name);
    }
    for (int i = 0; i < BAKE_GREYS; i++)
        if (bake_nth_grey(names, i))
            fprintf(b->out, "    .%s = &%s_%s,\n", bake_greys[i].member, b->name,
                    bake_greys[i].part);
    if (names->tables)
        fprintf(b->out, "    .tables = &%s_tables,\n", b->name);
    if (b->coastal_words)
        fprintf(b->out, "    .coastal = (const struct tp_coastal_water *)%s_coastal,\n",
                b->name);
    fprintf(b->out, "};\n");
}

static int put_all(const bake *b, const options *o, const loaded_scene *s)
{
    const tp_assets *names = &s->assets.names;
    put_head(b, o, s);
    for (uint32_t i = 0; i < b->n_pictures; i++)
        bake_texture(b, &b->pictures[i]);
    for (int i = 0; i < BAKE_GREYS; i++)
        if (bake_nth_grey(names, i))
            bake_grey(b, bake_greys[i].part, bake_nth_grey(names, i));
    if (names->boat)
        bake_mesh(b, "boat", names->boat);
    if (b->coastal_words)
        bake_coastal(b);
    bake_scene(b, b->program ? &b->program->scene : &s->file.scene);
    if (names->tables)
        bake_tables_write(b->out, b->name, &b->program->tables);
    put_assets(b, names);
    if (!b->program)
        return EXIT_DONE;
    int code = bake_put_world(b->program, names, b->out, b->name);
    const bool copied = bake_world_is_copied(b->program, names);
    bake_put_program(b->program, b->out, b->name, copied);
    bake_put_world_init(b->program, names, b->out, b->name);
    return code ? code : bake_put_frame(b->program, names, b->out, b->name);
}

/* -- the command --------------------------------------------------------------------- */

static int write_file(bake *b, const options *o, const loaded_scene *s)
{
    output_file out;
    int code = output_file_open(&out, o->out);
    if (code)
        return code;
    b->out = out.file;
    code = put_all(b, o, s);
    const int closed = output_file_close(&out);
    return code ? code : closed;
}

/* Loads the scene together with its world: a scene with an impossible world is refused
 * here, not on the board. */
static int run(loaded_scene *s, const options *o)
{
    char name[IDENTIFIER_BYTES];
    bake b = { .name = name };
    void *memory[TP_BAKED_LAYERS] = { NULL };
    tp_texture made[TP_BAKED_LAYERS];
    if (o->name && !can_be_name(o->name))
        return log_fail(EXIT_USAGE,
                        "tidepool bake: --name %.40s: expected a C identifier that"
                        " begins with a letter, not with tp_",
                        o->name);
    int code = bake_check_options(o);
    if (!code)
        code = loaded_scene_load(s, o);
    if (code)
        return code;
    if (bake_has_program(o) || s->frame.board)  /* the plan is for one size */
        tp_rung_set_apply_some(&s->file.scene, &s->plan.set, s->plan.open);
    make_identifier(o->name ? o->name : s->file.name, name);
    const tp_assets all = s->assets.names;
    bake_program program;
    tp_world *world = NULL;
    program_memory bytes;
    code = bake_prepare(&s->assets.names, &s->file.scene, o, memory, made);
    if (!code && bake_has_program(o)) {
        code = bake_find_program(&program, o, &s->file.scene, &all, &s->assets.names,
                                 NULL);
        b.program = &program;
    }
    if (!code)
        code = bake_list_pictures(&b, &s->assets.names);
    if (!code)
        world = bake_find_coastal(&b, o, &s->assets.names);
    if (!code && b.program) {
        code = program_memory_measure(&bytes, &program, &b, &s->assets.names);
        b.memory = &bytes;
    }
    if (!code)
        code = write_file(&b, o, s);
    if (!code && b.program)
        log_line("%s: %zu bytes of RAM, %zu of flash on a Cortex-M4, without the port's own",
                 s->file.name, program_memory_ram(&bytes), program_memory_flash(&bytes));
    if (b.program)
        bake_close_program(&program);
    free(world);
    free(b.pictures);
    for (int i = 0; i < TP_BAKED_LAYERS; i++)
        free(memory[i]);
    return code;
}

int bake_command(int argc, char **argv)
{
    options o;
    loaded_scene s;
    memset(&s, 0, sizeof s);
    int code = args_read(&o, FOR_BAKE, argc, argv);
    if (!o.sized) {
        o.width = WIDTH;
        o.height = HEIGHT;
    }
    if (!code && o.help)
        command_help_print(FOR_BAKE);
    else if (!code)
        code = run(&s, &o);
    const int end = code ? code : streams_finish();
    loaded_scene_close(&s);
    free(o.settings);
    return end;
}
