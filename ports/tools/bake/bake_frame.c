/* SPDX-License-Identifier: MIT */
#include "bake_frame.h"
#include <inttypes.h>
#include "app/files/log.h"
#include "frame/frame.h"

static void put_stencil(const tp_baked_frame *f, FILE *out, const char *name)
{
    fprintf(out, "\nstatic const uint8_t %s_stencil[] = {", name);
    for (uint32_t i = 0; i < f->modules; i++)
        fprintf(out, "%s%u,", i % 16 ? " " : "\n    ", (unsigned)f->stencil[i]);
    fprintf(out, f->modules ? "\n};\n" : " 0 };\n");
}

static const char *word(bool value)
{
    return value ? "true" : "false";
}

static void put_numbers(const tp_baked_frame *f, FILE *out, const char *name)
{
    fprintf(out,
            "static const tp_baked_frame %s_frame = {\n"
            "    .config = &%s_config, .scene = &%s_scene, .assets = &%s_assets,\n"
            "    .stencil = %s_stencil, .enabled = 0x%" PRIx64 ", .laid = 0x%" PRIx64 ",\n",
            name, name, name, name, name, f->enabled, f->laid);
    fprintf(out,
            "    .scratch_bytes = %" PRIu32 ", .renderer_bytes = %" PRIu32
            ", .kept_bytes = %" PRIu32 ",\n"
            "    .across = %u, .down = %u, .extra_rows = %u, .stencil_values = %u,\n"
            "    .lists = %u, .modules = %u, .unmarked = %u, .outlined = %u,\n"
            "    .visibility = %u, .shading = %u, .rate = %u,\n",
            f->scratch_bytes, f->renderer_bytes, f->kept_bytes, f->across, f->down, f->extra_rows,
            f->stencil_values, f->lists, f->modules, f->unmarked, f->outlined, f->visibility,
            f->shading, f->rate);
    fprintf(out,
            "    .half_lines = %s, .packed_rows = %s, .coast = %s,"
            " .needs_samples = %s\n};\n",
            word(f->half_lines), word(f->packed_rows), word(f->coast),
            word(f->needs_samples));
}

static void put_functions(FILE *out, const char *name)
{
    fprintf(out,
            "size_t %s_frame_bytes(void);\nsize_t %s_frame_bytes(void)\n{\n"
            "    return tp_frame_maker.bytes(&%s_frame);\n}\n",
            name, name, name);
    fprintf(out,
            "tp_status %s_frame_init(tp_frame **frame, void *memory, size_t bytes,"
            " tp_error *err);\n"
            "tp_status %s_frame_init(tp_frame **frame, void *memory, size_t bytes,"
            " tp_error *err)\n{\n"
            "    return tp_frame_maker.init(frame, &%s_frame, memory, bytes, err);\n}\n",
            name, name, name);
}

int bake_put_frame(const bake_program *p, const tp_assets *assets, FILE *out,
                   const char *name)
{
    component_list list;
    tp_found_frame found;
    tp_error err = { 0 };
    tp_config config = p->request.config;

    components_list(&list, &p->found.in, &p->request.terms);
    config.program = &list.program;
    config.assets = assets;
    if (tp_frame_find(&found, &config, &p->scene, &err) != TP_OK)
        return log_fail_error("tidepool bake", &err);
    put_stencil(&found.frame, out, name);
    put_numbers(&found.frame, out, name);
    fprintf(out,
            "extern const size_t %s_scratch_bytes, %s_direct_scratch_bytes;\n"
            "const size_t %s_scratch_bytes = %" PRIu32 ";\n"
            "const size_t %s_direct_scratch_bytes = %zu;\n",
            name, name, name, found.frame.scratch_bytes, name,
            tp_frame_direct_scratch_bytes(&config, &p->scene));
    put_functions(out, name);
    return EXIT_DONE;
}
