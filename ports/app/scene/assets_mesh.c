/* SPDX-License-Identifier: MIT */
/* Loads a mesh.
 *
 * The core reads OBJ and MTL text but opens no files; the code here opens them.  An MTL is
 * searched in the folder of the OBJ that names it, a picture in the folder of the MTL.
 * Missing or unusable files, and the core's warnings, are printed, and the mesh is drawn
 * without the part.  With --strict each of these is an error. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"
#include "assets.h"
#include "fixed/arithmetic.h"
#include "mesh/mesh.h"
#include "world/text.h"

enum {
    CHUNK      = 16384,
    SAID       = 16,                /* printed warnings per mesh; more are only counted */
    TEXT_BYTES = 2 * PATH_MAX + 512,
    METRES     = 4000,              /* drawable distance from the mesh's origin, m */
    UNREADABLE = -1                 /* read error; errno has the reason */
};

typedef struct {
    asset_set  *assets;
    tp_obj     *obj;
    const char *path;               /* path of the OBJ */
    unsigned    warnings;
} loading;

/* -- warnings ------------------------------------------------------------------------ */

static int warn(loading *l, const char *remedy, const char *format, ...) LOG_PRINTF(3, 4);

/* Prints a warning; `remedy` says how the program goes on.  With --strict returns
 * EXIT_INPUT. */
static int warn(loading *l, const char *remedy, const char *format, ...)
{
    char text[TEXT_BYTES];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    if (l->assets->options.strict)
        return log_fail(EXIT_INPUT, "%s", text);
    if (l->warnings++ < SAID && !l->assets->options.quiet)
        log_line("%s; %s", text, remedy);
    return EXIT_DONE;
}

static const char *remedy_text(tp_status code)
{
    return code == TP_E_MTL_RANGE ? "the nearest is taken"
         : code == TP_E_MTL_NAME || code == TP_E_OBJ_MATERIALS ? "drawn in grey"
                                                               : "the line is left out";
}

/* Prints the warnings that the core noted in the last step; file: the file just read. */
static int warn_noted(loading *l, const char *file)
{
    const tp_obj *obj = l->obj;
    int code = EXIT_DONE;
    for (uint32_t i = 0; i < obj->warnings && i < TP_OBJ_WARNINGS && !code; i++) {
        const tp_error *err = &obj->warning[i];
        char text[256];
        tp_error_text(err, text, sizeof text);
        code = warn(l, remedy_text(err->code), "%s:%u: %s%s", file, (unsigned)err->where,
                    text, log_check_place(err));
    }
    if (obj->warnings > TP_OBJ_WARNINGS)
        l->warnings += obj->warnings - TP_OBJ_WARNINGS;
    return code;
}

static int warn_counted(loading *l)
{
    const unsigned faces = l->obj->short_faces, far = l->obj->far_texcoords;
    int code = EXIT_DONE;
    if (faces)
        code = warn(l, "left out", "%s: %u face%s of fewer than 3 corners", l->path, faces,
                    faces > 1 ? "s" : "");
    if (far && !code)
        code = warn(l, "taken as 0", "%s: %u texture coordinate%s beyond +-%d", l->path,
                    far, far > 1 ? "s" : "", TP_OBJ_REPEATS);
    return code;
}

static uint32_t farther(tp_fx a, tp_fx b)
{
    const uint32_t low = a < 0 ? 0u - (uint32_t)a : (uint32_t)a;
    const uint32_t high = b < 0 ? 0u - (uint32_t)b : (uint32_t)b;
    return low > high ? low : high;
}

/* Returns the largest distance from the origin on an axis, in units of the file, 48.16. */
static uint64_t max_abs_coordinate(const tp_mesh *mesh)
{
    const uint32_t x = farther(mesh->low.x, mesh->high.x);
    const uint32_t y = farther(mesh->low.y, mesh->high.y);
    const uint32_t z = farther(mesh->low.z, mesh->high.z);
    const uint32_t most = x > y ? x : y;
    return (uint64_t)(most > z ? most : z) << mesh->log2_unit;
}

/* Warns of a mesh larger than METRES: vertices farther away are drawn at that distance. */
static int warn_reach(loading *l, const tp_mesh *mesh, tp_fx scale)
{
    const uint64_t reach = max_abs_coordinate(mesh), most = (uint64_t)METRES << 16;
    const uint64_t metres = reach * (uint64_t)scale >> 16;          /* < 2^38 x 2^23 */
    const tp_fx fitting = reach ? (tp_fx)((most << 16) / reach) : 0;
    char now[16], fits[32] = "boat.scale = ";
    if (metres <= most)
        return EXIT_DONE;
    tp_fx_write(scale, now);
    tp_fx_write(fitting, fits + strlen(fits));
    if (fitting < tp_param_find("boat.scale", 10)->low)
        strcpy(fits, "no boat.scale");
    return warn(l, "farther vertices are moved to this distance",
                "%s: reaches %u m from its origin at boat.scale %s, expected %d at the"
                " most: %s fits", l->path, (unsigned)(metres >> 16), now, METRES, fits);
}

/* -- files --------------------------------------------------------------------------- */

typedef tp_status (*feed)(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
typedef tp_status (*end)(tp_obj *obj, tp_error *err);

/* Passes a whole file through one pass of the reader. */
static int pass(tp_obj *obj, const char *path, feed more, end done)
{
    char chunk[CHUNK];
    tp_error err = { 0 };
    FILE *file = fopen(path, "rb");
    if (!file)
        return UNREADABLE;
    int code = EXIT_DONE;
    errno = 0;
    for (size_t n; !code && (n = fread(chunk, 1, sizeof chunk, file)) > 0;)
        if (more(obj, chunk, n, &err))
            code = log_fail_error(path, &err);
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    if (!code && !error && done(obj, &err))
        code = log_fail_error(path, &err);
    errno = error;
    return error ? UNREADABLE : code;
}

static int pass_obj(loading *l, const char *who, end done)
{
    const int code = pass(l->obj, l->path, tp_obj_feed, done);
    if (code == UNREADABLE)
        return log_fail(EXIT_INPUT, "%s: %s: %s", who, l->path, strerror(errno));
    return code;
}

/* Returns the path of a file beside `path`.  Other systems separate folders by backslashes;
 * if no such file exists, the backslashes become slashes. */
static char *resolve_file_name(const char *path, const char *name)
{
    char *full = path_beside(path, name);
    if (!full)
        log_fail_memory(strlen(path) + strlen(name));
    else if (!path_is_file(full))
        for (char *c = full; *c; c++)
            if (*c == '\\')
                *c = '/';
    return full;
}

/* -- libraries and pictures ---------------------------------------------------------- */

/* Reads a material library.  After a read error the materials read until then are kept. */
static int load_library(loading *l, uint32_t i, const char *library)
{
    if (!path_is_file(library)) {
        errno = ENOENT;
        return UNREADABLE;
    }
    tp_mtl_begin(l->obj, i);
    const int code = pass(l->obj, library, tp_mtl_feed, tp_mtl_end);
    if (code != UNREADABLE)
        return code ? code : warn_noted(l, library);
    const int error = errno;
    (void)tp_mtl_end(l->obj, NULL);
    errno = error;
    return UNREADABLE;
}

static int load_libraries(loading *l)
{
    int code = EXIT_DONE;
    for (uint32_t i = 0; i < l->obj->libraries && !code; i++) {
        char *library = resolve_file_name(l->path, tp_obj_library(l->obj, i));
        if (!library)
            return EXIT_INPUT;
        code = load_library(l, i, library);
        if (code == UNREADABLE)
            code = warn(l, "its materials are drawn in grey", "%s:%u: %s: %s", l->path,
                        (unsigned)tp_obj_library_line(l->obj, i), library,
                        strerror(errno));
        free(library);
    }
    return code;
}

/* *texture stays NULL if the picture is unusable. */
static int load_image(loading *l, uint32_t i, tp_texture *room, const tp_texture **texture)
{
    char why[PICTURE_WHY];
    char *library = resolve_file_name(l->path,
                             tp_obj_library(l->obj, tp_obj_image_library(l->obj, i)));
    char *image = library ? resolve_file_name(library, tp_obj_image(l->obj, i)) : NULL;
    int code = image ? assets_texture(l->assets, room, image, why) : EXIT_INPUT;
    if (!code)
        *texture = room;
    if (code == EXIT_CHECK)
        code = warn(l, "drawn without it", "%s:%u: %s: %s", library,
                    (unsigned)tp_obj_image_line(l->obj, i), image, why);
    free(image);
    free(library);
    return code;
}

/* Loads all images.  *list: the addresses of obj->images textures. */
static int load_images(loading *l, const tp_texture *const **list)
{
    const uint32_t count = l->obj->images;
    tp_texture *textures = assets_take(l->assets, count * sizeof *textures);
    const tp_texture **addresses = assets_take(l->assets, count * sizeof *addresses);
    if (!textures || !addresses)
        return EXIT_INPUT;
    int code = EXIT_DONE;
    for (uint32_t i = 0; i < count && !code; i++) {
        addresses[i] = NULL;
        code = load_image(l, i, &textures[i], &addresses[i]);
    }
    *list = addresses;
    return code;
}

/* -- the mesh ------------------------------------------------------------------------ */

static int load_text(loading *l, const char *who)
{
    tp_obj_begin_count(l->obj);
    int code = pass_obj(l, who, tp_obj_end_count);
    if (code)
        return code;
    void *memory = assets_take(l->assets, tp_obj_memory_bytes(l->obj));
    if (!memory)
        return EXIT_INPUT;
    l->assets->mesh_bytes += tp_obj_memory_bytes(l->obj);
    tp_obj_begin_load(l->obj, memory);
    code = pass_obj(l, who, tp_obj_end_load);
    if (!code)
        code = warn_noted(l, l->path);
    return code ? code : warn_counted(l);
}

static int load_parts(loading *l, tp_mesh *mesh, tp_fx scale)
{
    tp_error err = { 0 };
    const tp_texture *const *textures = NULL;
    int code = load_libraries(l);
    if (!code)
        code = load_images(l, &textures);
    if (!code && tp_obj_finish(l->obj, textures, mesh, &err))
        code = log_fail_error(l->path, &err);
    if (!code)
        code = warn_noted(l, l->path);
    return code ? code : warn_reach(l, mesh, scale);
}

int assets_mesh(asset_set *a, tp_mesh *mesh, const char *path, const char *who, tp_fx scale)
{
    loading l = { .assets = a, .obj = malloc(sizeof *l.obj), .path = path };
    if (!l.obj)
        return log_fail_memory(sizeof *l.obj);
    int code = load_text(&l, who);
    if (!code)
        code = load_parts(&l, mesh, scale);
    free(l.obj);
    if (l.warnings > SAID && !a->options.quiet)
        log_line("%s: and %u more", path, l.warnings - SAID);
    return code;
}
