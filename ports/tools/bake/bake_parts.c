/* SPDX-License-Identifier: MIT */
/* The parts of a baked file: numbers of the scene, textures, grey maps, meshes.
 *
 * The parameter table has the name and offset of every value of a scene.  A name is written
 * as its member in C: "wave0.length" becomes .wave[0].length. */
#include <ctype.h>
#include <inttypes.h>
#include <stdbool.h>
#include <string.h>
#include "bake.h"
#include "world/text.h"

/* -- the scene ----------------------------------------------------------------------- */

/* True if `member` is a member of tp_scene_map, and the parameter belongs to a part of the
 * scene with such a map. */
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

/* Writes a designator: scene.X becomes .X, wave3.phase .wave[3].phase, foam.size
 * .foam.map.size. */
static void put_member(FILE *out, const char *name)
{
    if (!strncmp(name, "scene.", 6))
        name += 6;
    const bool counted = !strncmp(name, "wave", 4) || !strncmp(name, "layer", 5);
    fputc('.', out);
    for (const char *c = name; *c; c++) {
        const bool index = counted && isdigit((unsigned char)*c);
        if (*c == '.' && is_map(name, c + 1))
            fprintf(out, ".map");
        const bool begins = index && !isdigit((unsigned char)c[-1]);
        const bool ends = index && !isdigit((unsigned char)c[1]);
        fprintf(out, "%s%c%s", begins ? "[" : "", *c, ends ? "]" : "");
    }
}

/* Writes a string literal.  Question marks are escaped: two of them would begin a
 * trigraph. */
static void put_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text; text++)
        if (strchr("\"\\?", *text) || (unsigned char)*text < 32)
            fprintf(out, "\\%03o", (unsigned char)*text);
        else
            fputc(*text, out);
    fputc('"', out);
}

void bake_scene(const bake *b, const tp_scene *scene)
{
    uint32_t count;
    const tp_param *params = tp_params(&count);
    fprintf(b->out, "\nextern const tp_scene %s_scene;\nconst tp_scene %s_scene = {\n",
            b->name, b->name);
    for (uint32_t i = 0; i < count; i++) {
        const char *value = (const char *)scene + params[i].offset;
        int32_t number;
        fprintf(b->out, "    ");
        if (params[i].offset >= offsetof(tp_scene, own))
            fprintf(b->out, ".own[%zu]", (params[i].offset - offsetof(tp_scene, own)) / 4);
        else
            put_member(b->out, params[i].name);
        fprintf(b->out, " = ");
        if (tp_param_is_text(&params[i])) {
            put_text(b->out, value);
        } else {
            memcpy(&number, value, sizeof number);
            fprintf(b->out, "%" PRId32, number);
        }
        fprintf(b->out, ",\n");
    }
    fprintf(b->out, "};\n");
}

/* -- textures and grey maps ---------------------------------------------------------- */

static uint32_t side(uint32_t log2, uint32_t level)
{
    return log2 > level ? 1u << (log2 - level) : 1;
}

static size_t level_texel_count(const tp_texture *t, uint32_t level)
{
    return (size_t)side(t->log2_w, level) * side(t->log2_h, level);
}

size_t bake_texture_bytes(const tp_texture *texture)
{
    return tp_texture_bytes(side(texture->log2_w, 0), side(texture->log2_h, 0));
}

static bool are_same(const tp_texture *a, const tp_texture *b)
{
    if (a->log2_w != b->log2_w || a->log2_h != b->log2_h)
        return false;
    for (uint32_t l = 0; l < a->levels; l++)
        if (memcmp(a->level[l], b->level[l], level_texel_count(a, l) * sizeof(uint32_t))
            != 0)
            return false;
    return true;
}

const bake_picture *bake_find(const bake *b, const tp_texture *texture)
{
    for (uint32_t i = 0; texture && i < b->n_pictures; i++)
        if (are_same(b->pictures[i].texture, texture))
            return &b->pictures[i];
    return NULL;
}

void bake_texture(const bake *b, const bake_picture *picture)
{
    const tp_texture *t = picture->texture;
    fprintf(b->out, "\n/* %s: %" PRIu32 " x %" PRIu32 " texels and their halves:"
            " %zu bytes. */\n", picture->name, side(t->log2_w, 0),
            side(t->log2_h, 0), bake_texture_bytes(t));
    for (uint32_t level = 0; level < t->levels; level++) {
        const size_t count = level_texel_count(t, level);
        fprintf(b->out, "static const uint32_t %s_%s_%" PRIu32 "[%zu] = {", b->name,
                picture->name, level, count);
        for (size_t i = 0; i < count; i++)
            fprintf(b->out, "%s0x%08" PRIx32 ",", i % 8 ? "" : "\n    ",
                    t->level[level][i]);
        fprintf(b->out, "\n};\n");
    }
    fprintf(b->out, "static const tp_texture %s_%s = {\n    .level = {", b->name,
            picture->name);
    for (uint32_t level = 0; level < t->levels; level++)
        fprintf(b->out, "%s%s_%s_%" PRIu32 ",", level % 4 ? " " : "\n        ", b->name,
                picture->name, level);
    fprintf(b->out, "\n    },\n    .log2_w = %d, .log2_h = %d, .levels = %d\n};\n",
            t->log2_w, t->log2_h, t->levels);
}

size_t bake_grey_bytes(const tp_grey *grey)
{
    return (size_t)grey->cols * grey->rows * sizeof *grey->sample;
}

void bake_grey(const bake *b, const char *part, const tp_grey *grey)
{
    const size_t count = (size_t)grey->cols * grey->rows;
    fprintf(b->out, "\n/* %s: %zu bytes. */\n", part, bake_grey_bytes(grey));
    fprintf(b->out, "static const uint16_t %s_%s_samples[%zu] = {", b->name, part, count);
    for (size_t i = 0; i < count; i++)
        fprintf(b->out, "%s0x%04x,", i % 12 ? "" : "\n    ", grey->sample[i]);
    fprintf(b->out, "\n};\nstatic const tp_grey %s_%s = { %" PRIu32 ", %" PRIu32
            ", %s_%s_samples };\n", b->name, part, grey->cols, grey->rows, b->name, part);
}

void bake_coastal(const bake *b)
{
    fprintf(b->out, "\n/* Waves over the floor: %zu bytes. */\n",
            b->coastal_words * sizeof *b->coastal);
    fprintf(b->out, "static const uint64_t %s_coastal[%zu] = {", b->name, b->coastal_words);
    for (size_t i = 0; i < b->coastal_words; i++)
        fprintf(b->out, "%s0x%" PRIx64 ",", i % 5 ? "" : "\n    ", b->coastal[i]);
    fprintf(b->out, "\n};\n");
}

/* -- meshes -------------------------------------------------------------------------- */

size_t bake_mesh_bytes(const tp_mesh *mesh)
{
    return mesh->n_vertices * sizeof *mesh->vertices
         + mesh->n_faces * sizeof *mesh->faces;
}

static void put_map(const bake *b, const tp_texture *map)
{
    const bake_picture *picture = bake_find(b, map);
    if (picture)
        fprintf(b->out, "&%s_%s, ", b->name, picture->name);
    else
        fprintf(b->out, "0, ");
}

static void put_point(FILE *out, tp_vec3 p)
{
    fprintf(out, "{ %" PRId32 ", %" PRId32 ", %" PRId32 " }", p.x, p.y, p.z);
}

static void put_materials(const bake *b, const char *part, const tp_mesh *mesh)
{
    fprintf(b->out, "static const tp_material %s_%s_materials[] = {\n", b->name, part);
    for (uint32_t i = 0; i < mesh->n_materials; i++) {
        const tp_material *m = &mesh->materials[i];
        fprintf(b->out, "    { 0x%06" PRIx32 ", 0x%06" PRIx32 ", %" PRId32 ", %" PRId32
                ", %" PRId32 ", ", m->diffuse, m->specular, m->shininess, m->opacity,
                m->bump);
        put_map(b, m->diffuse_map);
        put_map(b, m->normal_map);
        fprintf(b->out, "%" PRId32 " },\n", m->texels);
    }
    fprintf(b->out, "};\n");
}

static void put_vertices(const bake *b, const char *part, const tp_mesh *mesh)
{
    fprintf(b->out, "static const tp_mesh_vertex %s_%s_vertices[] = {\n", b->name, part);
    for (uint32_t i = 0; i < mesh->n_vertices; i++) {
        const tp_mesh_vertex *v = &mesh->vertices[i];
        fprintf(b->out, "    { ");
        put_point(b->out, v->position);
        fprintf(b->out, ", 0x%08" PRIx32 ", %" PRId32 ", %" PRId32 " },\n", v->normal,
                v->s, v->t);
    }
    fprintf(b->out, "};\n");
}

static void put_faces(const bake *b, const char *part, const tp_mesh *mesh)
{
    fprintf(b->out, "static const tp_mesh_face %s_%s_faces[] = {\n", b->name, part);
    for (uint32_t i = 0; i < mesh->n_faces; i++) {
        const tp_mesh_face *f = &mesh->faces[i];
        fprintf(b->out, "    { { %" PRIu32 ", %" PRIu32 ", %" PRIu32 " }, 0x%08" PRIx32
                ", %" PRIu32 " },\n", f->vertex[0], f->vertex[1], f->vertex[2],
                f->tangent, f->material);
    }
    fprintf(b->out, "};\n");
}

void bake_mesh(const bake *b, const char *part, const tp_mesh *mesh)
{
    fprintf(b->out, "\n/* %s: %" PRIu32 " vertices, %" PRIu32 " faces: %zu bytes. */\n",
            part, mesh->n_vertices, mesh->n_faces, bake_mesh_bytes(mesh));
    put_materials(b, part, mesh);
    put_vertices(b, part, mesh);
    put_faces(b, part, mesh);
    fprintf(b->out, "static const tp_mesh %s_%s = {\n    .vertices = %s_%s_vertices, "
            ".faces = %s_%s_faces,\n    .materials = %s_%s_materials,\n", b->name, part,
            b->name, part, b->name, part, b->name, part);
    fprintf(b->out, "    .n_vertices = %" PRIu32 ", .n_faces = %" PRIu32
            ", .n_materials = %" PRIu32 ",\n    .low = ", mesh->n_vertices, mesh->n_faces,
            mesh->n_materials);
    put_point(b->out, mesh->low);
    fprintf(b->out, ", .high = ");
    put_point(b->out, mesh->high);
    fprintf(b->out, ",\n    .log2_unit = %" PRIu32 "\n};\n", mesh->log2_unit);
}
