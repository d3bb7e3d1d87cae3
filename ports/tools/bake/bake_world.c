/* SPDX-License-Identifier: MIT */
#include "bake_world.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "world/module.h"

/* Bytes of the code that makes a world of swells, on a Cortex-M4. */
enum { MAKING = 2400 };

size_t bake_world_bytes(const bake_program *p, const tp_assets *assets)
{
    component_list list;

    components_list(&list, &p->found.in, &p->request.terms);
    return tp_world_bytes(&list.program, &p->scene, assets);
}

bool bake_world_is_copied(const bake_program *p, const tp_assets *assets)
{
    return !assets->coastal     /* the place of tables is no number */
           && bake_world_bytes(p, assets) <= MAKING;
}

tp_world *bake_find_coastal(bake *b, const options *o, tp_assets *assets)
{
    const tp_scene *scene = b->program ? &b->program->scene : NULL;
    const size_t bytes = scene && !o->with
                             ? tp_world_bytes(&tp_program_all, scene, assets) : 0;
    tp_world *world = bytes ? malloc(bytes) : NULL;

    if (!world
        || tp_world_init(&tp_program_all, world, bytes, scene, assets, NULL) != TP_OK)
        return world;
    assets->coastal = tp_world_coastal(world);
    b->coastal = (const uint64_t *)(const void *)assets->coastal;
    if (b->coastal)
        b->coastal_words = tp_coastal_table_bytes(assets->coastal) / sizeof *b->coastal;
    return world;
}

/* Makes the world by the program, and writes it. */
static int write_copy(const bake_program *p, const tp_assets *assets, FILE *out,
                      const char *name, size_t bytes)
{
    component_list list;
    tp_error err = { 0 };
    tp_world *world = malloc(bytes);
    const unsigned char *at = (const unsigned char *)world;

    components_list(&list, &p->found.in, &p->request.terms);
    if (!world)
        return log_fail_memory(bytes);
    if (tp_world_init(&list.program, world, bytes, &p->scene, assets, &err) != TP_OK) {
        free(world);
        return log_fail_error("tidepool bake", &err);
    }
    fprintf(out, "\nstatic const uint32_t %s_world_words[%zu] = {", name, bytes / 4);
    for (size_t i = 0; i < bytes / 4; i++, at += 4)
        fprintf(out, "%s0x%" PRIx32 ",", i % 8 ? "" : "\n    ",
                (uint32_t)(at[0] | at[1] << 8 | at[2] << 16) | (uint32_t)at[3] << 24);
    fprintf(out, "\n};\nstatic const tp_baked_world %s_world = {\n"
            "    &%s_scene, %s_world_words, sizeof %s_world_words\n};\n", name, name, name,
            name);
    free(world);
    return EXIT_DONE;
}

int bake_put_world(const bake_program *p, const tp_assets *assets, FILE *out,
                   const char *name)
{
    const size_t bytes = bake_world_bytes(p, assets);

    fprintf(out, "\nextern const size_t %s_world_bytes;\n"
            "const size_t %s_world_bytes = %zu;\n", name, name, bytes);
    return bake_world_is_copied(p, assets) ? write_copy(p, assets, out, name, bytes)
                                           : EXIT_DONE;
}

void bake_put_world_init(const bake_program *p, const tp_assets *assets, FILE *out,
                         const char *name)
{
    fprintf(out,
            "\ntp_status %s_world_init(tp_world *world, size_t bytes, tp_error *err);\n"
            "tp_status %s_world_init(tp_world *world, size_t bytes, tp_error *err)\n{\n",
            name, name);
    if (bake_world_is_copied(p, assets))
        fprintf(out,
                "    uint32_t *to = (uint32_t *)(void *)world;\n\n"
                "    if (TP_WORLD_IS_BAKED && world && bytes >= sizeof %s_world_words) {\n"
                "        for (size_t i = 0; i < %s_world.bytes / 4; i++)\n"
                "            to[i] = %s_world_words[i];\n"
                "        return TP_OK;\n    }\n"
                "    if (TP_WORLD_IS_BAKED && err)\n"
                "        *err = (tp_error){ .code = world ? TP_E_NOSPACE : TP_E_NULL };\n"
                "    if (TP_WORLD_IS_BAKED)\n"
                "        return world ? TP_E_NOSPACE : TP_E_NULL;\n", name, name, name);
    fprintf(out,
            "    return tp_world_init(&%s_program, world, bytes, &%s_scene, &%s_assets,"
            " err);\n}\n", name, name, name);
}
