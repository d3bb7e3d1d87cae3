/* SPDX-License-Identifier: MIT */
#include "bake_world.h"
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"

/* Bytes of the code that makes a world of swells, on a Cortex-M4. */
enum { MAKING = 2400 };

bool bake_world_is_copied(const bake_program *p, const tp_assets *assets)
{
    component_list list;

    components_list(&list, &p->found.in, &p->request.terms);
    return !assets->coastal     /* the place of tables is no number */
           && tp_world_bytes(&list.program, &p->scene, assets) <= MAKING;
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
    component_list list;

    components_list(&list, &p->found.in, &p->request.terms);
    const size_t bytes = tp_world_bytes(&list.program, &p->scene, assets);
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
