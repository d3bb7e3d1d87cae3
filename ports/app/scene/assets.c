/* SPDX-License-Identifier: MIT */
/* Loads the files that a scene names: textures here, the mesh in assets_mesh.c. */
#define _POSIX_C_SOURCE 200809L
#include "assets.h"
#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "app/files/picture.h"
#include "world/text.h"

#define WHO_BYTES (PATH_MAX + 64)

struct assets_block {
    assets_block *next;
    uint64_t bytes[];           /* aligned for every type of the core */
};

void *assets_take(asset_set *a, size_t bytes)
{
    assets_block *block = malloc(sizeof *block + bytes);
    if (!block) {
        log_fail_memory(bytes);
        return NULL;
    }
    block->next = a->blocks;
    a->blocks = block;
    return block->bytes;
}

void assets_close(asset_set *a)
{
    for (assets_block *block = a->blocks; block;) {
        assets_block *next = block->next;
        free(block);
        block = next;
    }
    *a = (asset_set){ 0 };
}

/* Moves *from to *to.  The pointers in `names` refer to members of the asset_set, which get
 * new addresses here, or to blocks, which stay where they are. */
void assets_move(asset_set *to, asset_set *from)
{
    const void *names[sizeof from->names / sizeof(void *)];
    _Static_assert(sizeof names == sizeof from->names, "names are pointers alone");
    const uintptr_t begin = (uintptr_t)from, end = (uintptr_t)(from + 1);
    assets_close(to);
    *to = *from;
    memcpy(names, &from->names, sizeof names);
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if ((uintptr_t)names[i] >= begin && (uintptr_t)names[i] < end)
            names[i] = (const char *)to + ((uintptr_t)names[i] - begin);
    memcpy(&to->names, names, sizeof names);
    *from = (asset_set){ 0 };
}

/* -- textures ------------------------------------------------------------------------ */

/* Drops the largest mipmap levels until the longer side is at most `most` texels.  Returns
 * the number of bytes dropped; most = 0 drops nothing. */
static size_t discard_large_mips(tp_texture *texture, uint32_t most)
{
    size_t bytes = 0;
    while (most && texture->levels > 1 && 1u << (texture->levels - 1) > most) {
        bytes += sizeof(uint32_t) << (texture->log2_w + texture->log2_h);
        memmove(texture->level, texture->level + 1,
                sizeof texture->level - sizeof *texture->level);
        texture->levels--;
        if (texture->log2_w > 0)
            texture->log2_w--;
        if (texture->log2_h > 0)
            texture->log2_h--;
    }
    return bytes;
}

int assets_texture(asset_set *a, tp_texture *texture, const char *path,
                   char why[PICTURE_WHY])
{
    uint32_t w, h;
    uint32_t *pixels = picture_load_png(path, &w, &h, why);
    if (!pixels)
        return errno == ENOMEM ? log_fail(EXIT_INPUT, "%s: %s", path, why) : EXIT_CHECK;
    const size_t bytes = tp_texture_bytes(w, h);
    void *memory = assets_take(a, bytes);
    tp_error err = { 0 };
    int code = memory ? EXIT_DONE : EXIT_INPUT;
    if (memory
        && tp_texture_init(texture, pixels, w, h, memory, tp_texture_bytes(w, h), &err))
        code = log_fail_error(path, &err);
    free(pixels);
    if (!code)
        a->texture_bytes += bytes - discard_large_mips(texture, a->options.texels);
    return code;
}

static int load_texture(asset_set *a, tp_texture *texture, const char *path,
                        const char *who)
{
    char why[PICTURE_WHY];
    const int code = assets_texture(a, texture, path, why);
    return code == EXIT_CHECK ? log_fail(EXIT_INPUT, "%s: %s: %s", who, path, why) : code;
}

/* -- grey maps ----------------------------------------------------------------------- */

static int load_grey(asset_set *a, tp_grey *grey, const char *path, const char *who)
{
    uint32_t w, h;
    uint16_t *samples = picture_read_grey(path, who, &w, &h);
    if (!samples)
        return EXIT_INPUT;
    const size_t bytes = (size_t)w * h * sizeof *samples;
    uint16_t *memory = assets_take(a, bytes);
    if (memory)
        memcpy(memory, samples, bytes);
    free(samples);
    *grey = (tp_grey){ w, h, memory };
    a->texture_bytes += bytes;
    return memory ? EXIT_DONE : EXIT_INPUT;
}

/* -- the scene ----------------------------------------------------------------------- */

/* Replaces *path of an OBJ by that of the mesh of its rung, if the file exists.
 * Returns an exit code. */
static int choose_mesh(const asset_set *a, const scene_file *file, char **path)
{
    static const char *const ends[] = { [TP_MESH_MIDDLE] = "-mid.obj",
                                        [TP_MESH_LOW] = "-low.obj" };
    const int32_t named = file->scene.quality.mesh, rung = named ? named : a->options.mesh;
    if (rung < TP_MESH_MIDDLE || !path_ends(*path, ".obj"))
        return EXIT_DONE;
    const size_t stem = strlen(*path) - strlen(".obj"), end = strlen(ends[rung]);
    char *other = malloc(stem + end + 1);
    if (!other)
        return log_fail_memory(stem + end + 1);
    memcpy(other, *path, stem);
    memcpy(other + stem, ends[rung], end + 1);
    const bool exists = path_is_file(other);
    free(exists ? *path : other);
    *path = exists ? other : *path;
    return EXIT_DONE;
}

/* Loads the file named by the parameter `name`; *there: true if the scene names a file. */
static int load(asset_set *a, const scene_file *file, const char *name, void *into,
                bool *there)
{
    const tp_param *param = tp_param_find(name, strlen(name));
    char text[TP_NAME_BYTES], who[WHO_BYTES];
    *there = tp_param_text(&file->scene, param, text, sizeof text) > 0;
    if (!*there)
        return EXIT_DONE;
    char *path = scene_file_resolve_path(file, param);
    if (!path)
        return log_fail_memory(sizeof text);
    scene_file_who(file, param, who, sizeof who);
    int code = param->kind == TP_PARAM_MESH ? choose_mesh(a, file, &path) : EXIT_DONE;
    if (!code)
        code = param->kind == TP_PARAM_MESH ? assets_mesh(a, into, path, who,
                                                          file->scene.boat.scale)
             : param->kind == TP_PARAM_GREY ? load_grey(a, into, path, who)
                                            : load_texture(a, into, path, who);
    free(path);
    return code;
}

/* A sky of cube faces needs all six pictures: a cube with a missing face is no sky. */
const char *assets_lack(const asset_set *a, const scene_file *file)
{
    static const char *const faces[TP_FACES] = { "sky.east", "sky.west", "sky.up",
                                                 "sky.down", "sky.south", "sky.north" };
    for (int i = 0; i < TP_FACES && file->scene.sky.kind == TP_SKY_CUBE; i++)
        if (!a->names.sky[i])
            return faces[i];
    return NULL;
}

int assets_refuse(const scene_file *file, const char *lacking)
{
    char who[WHO_BYTES];
    scene_file_who(file, tp_param_find("sky.kind", 8), who, sizeof who);
    return log_fail(EXIT_INPUT, "%s: a cube needs six pictures; %s names none", who,
                    lacking);
}

int assets_open(asset_set *a, const scene_file *file)
{
    return assets_load(a, file, &(assets_options){ 0 });
}

int assets_load(asset_set *a, const scene_file *file, const assets_options *options)
{
    static const char *const pictures[ASSETS_PICTURES] = {
        "layer0.texture", "layer1.texture", "layer2.texture", "distortion.texture",
        "ripple.texture", "foam.texture", "sky.east", "sky.west", "sky.up", "sky.down",
        "sky.south", "sky.north", "tank.wall", "tank.floor", "floor.texture",
    };
    *a = (asset_set){ .options = *options };
    const tp_texture **const slots[ASSETS_PICTURES] = {
        &a->names.layer[0], &a->names.layer[1], &a->names.layer[2],
        &a->names.distortion, &a->names.ripple, &a->names.foam, &a->names.sky[0],
        &a->names.sky[1], &a->names.sky[2], &a->names.sky[3], &a->names.sky[4],
        &a->names.sky[5], &a->names.tank_wall, &a->names.tank_floor,
        &a->names.floor_texture,
    };
    const struct { const char *name; tp_grey *into; const tp_grey **slot; } greys[] = {
        { "floor.map", &a->floor, &a->names.floor },
        { "pool.mask", &a->pool_mask, &a->names.pool_mask },
        { "field.mask", &a->field_mask, &a->names.field_mask },
    };
    bool there;
    int code = load(a, file, "boat.mesh", &a->boat, &there);
    a->names.boat = there ? &a->boat : NULL;
    for (int i = 0; i < ASSETS_PICTURES && !code; i++) {
        code = load(a, file, pictures[i], &a->picture[i], &there);
        *slots[i] = there ? &a->picture[i] : NULL;
    }
    if (!code && assets_lack(a, file))
        code = assets_refuse(file, assets_lack(a, file));
    for (size_t i = 0; i < sizeof greys / sizeof *greys && !code; i++) {
        code = load(a, file, greys[i].name, greys[i].into, &there);
        *greys[i].slot = there ? greys[i].into : NULL;
    }
    if (code)
        assets_close(a);
    return code;
}
