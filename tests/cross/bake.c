/* SPDX-License-Identifier: MIT */
/* bake SCENE -o FILE.c: a scene, its mesh and its textures as constant C.
 *
 * The parameter table knows every value of a scene by name and place; a name is written
 * as the member it stands for: "wave0.length" is .wave[0].length.  Numbers are written
 * as numbers, not as bytes, so that the same file serves every byte order. */
#include <ctype.h>
#include <inttypes.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include "host/assets.h"
#include "host/scene_file.h"

/* -- the scene ----------------------------------------------------------------- */

/* Whether the member is one of a tp_scene_map in that part of the scene. */
static bool is_map(const char *name, const char *member)
{
    static const char *const parts[] = { "layer", "distortion", "ripple", "foam" };
    static const char *const members[] = { "texture", "size", "drift_x", "drift_z" };

    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            if (!strncmp(name, parts[i], strlen(parts[i])) && !strcmp(member, members[k]))
                return true;
    return false;
}

/* "wave0.length" as ".wave[0].length"; what is called scene.X is X itself. */
static void put_member(FILE *out, const char *name)
{
    if (!strncmp(name, "scene.", 6))
        name += 6;
    const bool layers = strncmp(name, "layer", 5) == 0;
    const bool waves = strncmp(name, "wave", 4) == 0;     /* wave3.phase is wave[3].phase */
    fputc('.', out);
    for (const char *c = name; *c; c++) {
        bool index = (waves || layers) && isdigit((unsigned char)*c);
        if (*c == '.' && is_map(name, c + 1))             /* foam.size is foam.map.size */
            fprintf(out, ".map");
        bool begins = index && !isdigit((unsigned char)c[-1]);
        bool ends = index && !isdigit((unsigned char)c[1]);
        fprintf(out, "%s%c%s", begins ? "[" : "", *c, ends ? "]" : "");
    }
}

static void put_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text; text++)
        if (*text == '"' || *text == '\\' || (unsigned char)*text < 32)
            fprintf(out, "\\%03o", (unsigned char)*text);
        else
            fputc(*text, out);
    fputc('"', out);
}

static void put_scene(FILE *out, const tp_scene *scene)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    fprintf(out, "const tp_scene baked_scene = {\n");
    for (uint32_t i = 0; i < count; i++) {
        const char *value = (const char *)scene + params[i].offset;
        int32_t number;
        fprintf(out, "    ");
        put_member(out, params[i].name);
        fprintf(out, " = ");
        if (params[i].kind >= TP_PARAM_MESH) {        /* a name or a text */
            put_text(out, value);
        } else {
            memcpy(&number, value, sizeof number);
            fprintf(out, "%" PRId32, number);
        }
        fprintf(out, ",\n");
    }
    fprintf(out, "};\n");
}

/* -- textures ------------------------------------------------------------------ */

static uint32_t side(uint32_t log2, uint32_t level)
{
    return log2 > level ? 1u << (log2 - level) : 1;
}

static void put_texture(FILE *out, const char *name, const tp_texture *t)
{
    for (uint32_t level = 0; level < t->levels; level++) {
        uint32_t count = side(t->log2_w, level) * side(t->log2_h, level);
        fprintf(out, "static const uint32_t %s_%" PRIu32 "[%" PRIu32 "] = {", name, level,
                count);
        for (uint32_t i = 0; i < count; i++)
            fprintf(out, "%s0x%08" PRIx32 ",", i % 8 ? "" : "\n    ", t->level[level][i]);
        fprintf(out, "\n};\n");
    }
    fprintf(out, "static const tp_texture %s = {\n    .level = { ", name);
    for (uint32_t level = 0; level < t->levels; level++)
        fprintf(out, "%s_%" PRIu32 ", ", name, level);
    fprintf(out, "},\n    .log2_w = %d, .log2_h = %d, .levels = %d\n};\n", t->log2_w,
            t->log2_h, t->levels);
}

static void put_grey(FILE *out, const char *name, const tp_grey *grey)
{
    const uint32_t count = grey->cols * grey->rows;
    fprintf(out, "static const uint16_t %s_samples[%" PRIu32 "] = {", name, count);
    for (uint32_t i = 0; i < count; i++)
        fprintf(out, "%s0x%04x,", i % 12 ? "" : "\n    ", grey->sample[i]);
    fprintf(out, "\n};\nstatic const tp_grey %s = { %" PRIu32 ", %" PRIu32
            ", %s_samples };\n", name, grey->cols, grey->rows, name);
}

/* -- the mesh ------------------------------------------------------------------ */

/* Several materials may share a map: the first that names it has it written. */
static void put_map(FILE *out, const tp_mesh *mesh, uint32_t upto, const tp_texture *map,
                    bool define)
{
    uint32_t i = 0;
    for (; i < upto; i++)
        if (mesh->materials[i].diffuse_map == map || mesh->materials[i].normal_map == map)
            break;
    if (!map && !define) {
        fprintf(out, "0");
        return;
    }
    if (!map || (define && i < upto))
        return;
    const char *kind = mesh->materials[i].diffuse_map == map ? "diffuse" : "normal";
    char name[32];
    snprintf(name, sizeof name, "%s%" PRIu32, kind, i);
    if (define)
        put_texture(out, name, map);
    else
        fprintf(out, "&%s", name);
}

static void put_materials(FILE *out, const tp_mesh *mesh)
{
    for (uint32_t i = 0; i < mesh->n_materials; i++) {
        const tp_material *m = &mesh->materials[i];
        put_map(out, mesh, i, m->diffuse_map, true);
        if (m->normal_map != m->diffuse_map)
            put_map(out, mesh, i, m->normal_map, true);
    }
    fprintf(out, "static const tp_material materials[] = {\n");
    for (uint32_t i = 0; i < mesh->n_materials; i++) {
        const tp_material *m = &mesh->materials[i];
        fprintf(out, "    { 0x%06" PRIx32 ", 0x%06" PRIx32 ", %" PRId32 ", %" PRId32
                ", %" PRId32 ", ", m->diffuse, m->specular, m->shininess, m->opacity,
                m->bump);
        put_map(out, mesh, mesh->n_materials, m->diffuse_map, false);
        fprintf(out, ", ");
        put_map(out, mesh, mesh->n_materials, m->normal_map, false);
        fprintf(out, ", %" PRId32 " },\n", m->texels);
    }
    fprintf(out, "};\n");
}

static void put_point(FILE *out, tp_vec3 p)
{
    fprintf(out, "{ %" PRId32 ", %" PRId32 ", %" PRId32 " }", p.x, p.y, p.z);
}

static void put_mesh(FILE *out, const tp_mesh *mesh)
{
    put_materials(out, mesh);
    fprintf(out, "static const tp_mesh_vertex vertices[] = {\n");
    for (uint32_t i = 0; i < mesh->n_vertices; i++) {
        const tp_mesh_vertex *v = &mesh->vertices[i];
        fprintf(out, "    { ");
        put_point(out, v->position);
        fprintf(out, ", 0x%08" PRIx32 ", %" PRId32 ", %" PRId32 " },\n", v->normal, v->s,
                v->t);
    }
    fprintf(out, "};\nstatic const tp_mesh_face faces[] = {\n");
    for (uint32_t i = 0; i < mesh->n_faces; i++) {
        const tp_mesh_face *f = &mesh->faces[i];
        fprintf(out, "    { { %" PRIu32 ", %" PRIu32 ", %" PRIu32 " }, 0x%08" PRIx32
                ", %" PRIu32 " },\n", f->vertex[0], f->vertex[1], f->vertex[2],
                f->tangent, f->material);
    }
    fprintf(out, "};\nstatic const tp_mesh boat = {\n    .vertices = vertices, "
            ".faces = faces, .materials = materials,\n    .n_vertices = %" PRIu32
            ", .n_faces = %" PRIu32 ", .n_materials = %" PRIu32 ",\n    .low = ",
            mesh->n_vertices, mesh->n_faces, mesh->n_materials);
    put_point(out, mesh->low);
    fprintf(out, ", .high = ");
    put_point(out, mesh->high);
    fprintf(out, "\n};\n");
}

/* -- all of it ----------------------------------------------------------------- */

static bool put_all(FILE *out, const scene_file *file, const tp_assets *names)
{
    fprintf(out, "/* SPDX-License-Identifier: CC0-1.0 */\n"
            "/* Baked from the scene %s: made, not written. */\n"
            "#include \"cortex-m/baked.h\"\n", file->name);
    put_scene(out, &file->scene);
    const struct { const char *name; const tp_texture *texture; } rows[] = {
        { "layer[0]", names->layer[0] }, { "layer[1]", names->layer[1] },
        { "layer[2]", names->layer[2] }, { "distortion", names->distortion },
        { "ripple", names->ripple },     { "foam", names->foam },
        { "sky[0]", names->sky[0] },     { "sky[1]", names->sky[1] },
        { "sky[2]", names->sky[2] },     { "sky[3]", names->sky[3] },
        { "sky[4]", names->sky[4] },     { "sky[5]", names->sky[5] },
        { "tank_wall", names->tank_wall }, { "tank_floor", names->tank_floor },
        { "floor_texture", names->floor_texture },
    };
    enum { ROWS = sizeof rows / sizeof *rows };
    char name[ROWS][16];

    for (int i = 0; i < ROWS; i++) {
        snprintf(name[i], sizeof name[i], "picture%d", i);
        if (rows[i].texture)
            put_texture(out, name[i], rows[i].texture);
    }
    if (names->boat)
        put_mesh(out, names->boat);
    if (names->floor)
        put_grey(out, "sea_floor", names->floor);
    if (names->pool_mask)
        put_grey(out, "pool_mask", names->pool_mask);
    fprintf(out, "const tp_assets baked_assets = {\n    .boat = %s, .floor = %s, "
            ".pool_mask = %s, .field_mask = %s,\n",
            names->boat ? "&boat" : "0", names->floor ? "&sea_floor" : "0",
            names->pool_mask ? "&pool_mask" : "0",
            names->field_mask ? "&field_mask" : "0");
    for (int i = 0; i < ROWS; i++)
        if (rows[i].texture)
            fprintf(out, "    .%s = &%s,\n", rows[i].name, name[i]);
    fprintf(out, "};\n");
    return fflush(out) == 0 && !ferror(out);
}

static int bake(const char *scene, const char *name)
{
    scene_file file;
    assets     named = { 0 };
    int code = scene_file_open(&file, scene);
    if (!code)
        code = assets_open(&named, &file);
    if (!code) {
        FILE *out = fopen(name, "w");
        bool whole = out && put_all(out, &file, &named.names);
        if (out && fclose(out))
            whole = false;
        if (!whole) {
            perror(name);
            remove(name);
            code = 3;
        }
    }
    assets_close(&named);
    scene_file_close(&file);
    return code;
}

int main(int argc, char **argv)
{
    if (argc == 4 && !strcmp(argv[2], "-o"))
        return bake(argv[1], argv[3]);
    fprintf(stderr, "usage: bake SCENE -o FILE.c\n");
    return 2;
}
