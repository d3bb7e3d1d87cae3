/* SPDX-License-Identifier: MIT */
/* Loading what a scene names.
 *
 * The core reads OBJ and MTL text and opens no file: here are the files.  An MTL is
 * found beside the OBJ that names it, a picture beside the MTL. */
#include "assets.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "path.h"
#include "picture.h"
#include "say.h"

#define WHO_BYTES 512
#define CHUNK     65536

struct assets_block {
    assets_block *next;
    uint64_t bytes[];           /* aligned as the core wants it */
};

static void *take(assets *a, size_t bytes)
{
    assets_block *block = malloc(sizeof *block + bytes);
    if (!block) {
        fail_memory(bytes);
        return NULL;
    }
    block->next = a->blocks;
    a->blocks = block;
    return block->bytes;
}

void assets_close(assets *a)
{
    for (assets_block *block = a->blocks; block;) {
        assets_block *next = block->next;
        free(block);
        block = next;
    }
    *a = (assets){ 0 };
}

/* Names point into the assets themselves, or to blocks, which stay where they are. */
void assets_move(assets *to, assets *from)
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
    *from = (assets){ 0 };
}

/* -- textures -------------------------------------------------------------------- */

/* The largest copy that is wanted becomes the picture; how many bytes that is less. */
static size_t leave_out(tp_texture *texture, uint32_t most)
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

static int load_texture(assets *a, tp_texture *texture, const char *path, const char *who)
{
    uint32_t w, h;
    uint32_t *pixels = picture_read_png(path, who, &w, &h);
    if (!pixels)
        return EXIT_INPUT;
    const size_t bytes = tp_texture_bytes(w, h);
    void *memory = take(a, bytes);
    tp_error err = { 0 };
    int code = memory ? EXIT_DONE : EXIT_INPUT;
    if (memory && tp_texture_init(texture, pixels, w, h, memory, &err))
        code = fail_at(path, &err);
    free(pixels);
    if (!code)
        a->texture_bytes += bytes - leave_out(texture, a->texels);
    return code;
}

/* -- greys ----------------------------------------------------------------------- */

static int load_grey(assets *a, tp_grey *grey, const char *path, const char *who)
{
    uint32_t w, h;
    uint16_t *samples = picture_read_grey(path, who, &w, &h);
    if (!samples)
        return EXIT_INPUT;
    const size_t bytes = (size_t)w * h * sizeof *samples;
    uint16_t *memory = take(a, bytes);
    if (memory)
        memcpy(memory, samples, bytes);
    free(samples);
    *grey = (tp_grey){ w, h, memory };
    a->texture_bytes += bytes;
    return memory ? EXIT_DONE : EXIT_INPUT;
}

/* -- the mesh -------------------------------------------------------------------- */

typedef tp_status (*feed)(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
typedef tp_status (*end)(tp_obj *obj, tp_error *err);

/* A whole file through one of the reader's passes. */
static int pass(tp_obj *obj, const char *path, const char *who, feed more, end done)
{
    static char chunk[CHUNK];
    tp_error err = { 0 };
    FILE *file = fopen(path, "rb");
    if (!file)
        return fail(EXIT_INPUT, "%s: %s: %s", who, path, strerror(errno));
    int code = EXIT_DONE;
    errno = 0;
    for (size_t n; !code && (n = fread(chunk, 1, sizeof chunk, file)) > 0;)
        if (more(obj, chunk, n, &err))
            code = fail_at(path, &err);
    if (!code && ferror(file))
        code = fail(EXIT_INPUT, "%s: %s: %s", who, path, strerror(errno));
    fclose(file);
    if (!code && done(obj, &err))
        code = fail_at(path, &err);
    return code;
}

/* Folders of names written on other systems are parted by backslashes. */
static char *named_in(const char *path, const char *name)
{
    char *full = path_beside(path, name);
    if (!full)
        fail_memory(strlen(path) + strlen(name));
    else if (!path_is_file(full))
        for (char *c = full; *c; c++)
            if (*c == '\\')
                *c = '/';
    return full;
}

static int load_libraries(tp_obj *obj, const char *path)
{
    int code = EXIT_DONE;
    for (uint32_t i = 0; i < obj->libraries && !code; i++) {
        char *library = named_in(path, tp_obj_library(obj, i));
        if (!library)
            return EXIT_INPUT;
        tp_mtl_begin(obj, i);
        code = pass(obj, library, path, tp_mtl_feed, tp_mtl_end);
        free(library);
    }
    return code;
}

static int load_image(assets *a, const tp_obj *obj, uint32_t i, const char *path,
                      tp_texture *texture)
{
    char *library = named_in(path, tp_obj_library(obj, tp_obj_image_library(obj, i)));
    char *image = library ? named_in(library, tp_obj_image(obj, i)) : NULL;
    const int code = image ? load_texture(a, texture, image, library) : EXIT_INPUT;
    free(image);
    free(library);
    return code;
}

/* obj->images textures and, in *list, their addresses. */
static int load_images(assets *a, const tp_obj *obj, const char *path,
                       const tp_texture *const **list)
{
    tp_texture *textures = take(a, obj->images * sizeof *textures);
    const tp_texture **addresses = take(a, obj->images * sizeof *addresses);
    if (!textures || !addresses)
        return EXIT_INPUT;
    int code = EXIT_DONE;
    for (uint32_t i = 0; i < obj->images && !code; i++) {
        addresses[i] = &textures[i];
        code = load_image(a, obj, i, path, &textures[i]);
    }
    *list = addresses;
    return code;
}

static int load_mesh_by(assets *a, tp_obj *obj, tp_mesh *mesh, const char *path,
                        const char *who)
{
    tp_error err = { 0 };
    tp_obj_scan(obj);
    int code = pass(obj, path, who, tp_obj_feed, tp_obj_scanned);
    if (code)
        return code;
    void *memory = take(a, tp_obj_bytes(obj));
    if (!memory)
        return EXIT_INPUT;
    a->mesh_bytes += tp_obj_bytes(obj);
    tp_obj_load(obj, memory);
    code = pass(obj, path, who, tp_obj_feed, tp_obj_loaded);
    if (!code)
        code = load_libraries(obj, path);
    const tp_texture *const *textures = NULL;
    if (!code)
        code = load_images(a, obj, path, &textures);
    if (!code && tp_obj_bind(obj, textures, mesh, &err))
        code = fail_at(path, &err);
    return code;
}

static int load_mesh(assets *a, tp_mesh *mesh, const char *path, const char *who)
{
    tp_obj *obj = malloc(sizeof *obj);
    if (!obj)
        return fail_memory(sizeof *obj);
    const int code = load_mesh_by(a, obj, mesh, path, who);
    free(obj);
    return code;
}

/* -- the scene ------------------------------------------------------------------- */

/* Loads what the row called `name` names; *there tells whether it names anything. */
static int load(assets *a, const scene_file *file, const char *name, void *into,
                bool *there)
{
    const tp_param *param = tp_param_find(name, strlen(name));
    char text[TP_NAME_BYTES], who[WHO_BYTES];
    *there = tp_param_text(&file->scene, param, text, sizeof text) > 0;
    if (!*there)
        return EXIT_DONE;
    char *path = scene_file_path_of(file, param);
    if (!path)
        return fail_memory(sizeof text);
    scene_file_who(file, param, who, sizeof who);
    const int code = param->kind == TP_PARAM_MESH ? load_mesh(a, into, path, who)
                   : param->kind == TP_PARAM_GREY ? load_grey(a, into, path, who)
                                                  : load_texture(a, into, path, who);
    free(path);
    return code;
}

/* Six pictures or none: a cube with a hole is no sky. */
const char *assets_lack(const assets *a, const scene_file *file)
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
    return fail(EXIT_INPUT, "%s: a cube needs six pictures; %s names none", who, lacking);
}

int assets_open(assets *a, const scene_file *file)
{
    return assets_open_within(a, file, 0);
}

int assets_open_within(assets *a, const scene_file *file, uint32_t texels)
{
    static const char *const pictures[ASSETS_PICTURES] = {
        "layer0.texture", "layer1.texture", "layer2.texture", "distortion.texture",
        "ripple.texture", "foam.texture", "sky.east", "sky.west", "sky.up", "sky.down",
        "sky.south", "sky.north", "tank.wall", "tank.floor", "floor.texture",
    };
    *a = (assets){ .texels = texels };
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
