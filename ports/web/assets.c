/* SPDX-License-Identifier: MIT */
/* Files named by a scene, supplied by the page: each file once, by its name under
 * assets/, and kept.  The page decodes PNGs.  OBJ and MTL files go in pieces to the
 * core's reader.  The page asks for the next wanted file until none is wanted:
 *
 *     while ((kind = wanted()))           its name is in words()
 *         piece by piece into words(), feed(bytes); given()
 *
 * An MTL is looked up beside its OBJ, a picture beside its MTL, as on the host.  An OBJ
 * is wanted twice, because its reader needs two passes. */
#include "base/base.h"
#include "mesh/mesh.h"
#include "web.h"

#define FILES 128

enum { SCAN, LOAD, LIBRARIES, IMAGES, BOUND };     /* next step of an OBJ */

typedef struct {
    char name[TP_NAME_BYTES];
    int  kind;
    union {
        tp_texture texture;
        tp_grey    grey;
        struct { tp_mesh mesh; int stage; uint32_t library; };
    };
} file;

static struct {
    file     files[FILES];
    uint32_t count;
    file    *reading;           /* the OBJ being read */
    tp_obj   obj;               /* reader of that OBJ */
    void    *memory, *pixels;   /* of the picture being received */
    uint32_t w, h;
    tp_error error;
} all;

tp_assets web_assets;
int       web_kind;
char      web_name[TP_NAME_BYTES];

/* -- names --------------------------------------------------------------------------- */

static bool same(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return *a == *b;
}

/* Writes the path of `name` beside the file `path`; '\' in `name` becomes '/'. */
static void beside(char full[TP_NAME_BYTES], const char *path, const char *name)
{
    size_t slash = 0, n;
    for (n = 0; path[n] && n < TP_NAME_BYTES - 1; n++)
        if ((full[n] = path[n]) == '/')
            slash = n + 1;
    for (n = slash; *name && n < TP_NAME_BYTES - 1; name++)
        full[n++] = *name == '\\' ? '/' : *name;
    full[n] = 0;
}

/* Returns the file of that name and kind.  If it is missing, makes it the wanted file
 * and returns NULL. */
static file *have(const char *name, int kind)
{
    for (uint32_t i = 0; i < all.count; i++)
        if (all.files[i].kind == kind && same(all.files[i].name, name))
            return &all.files[i];
    beside(web_name, "", name);
    web_kind = kind;
    return NULL;
}

/* Adds the wanted file.  Returns NULL if there are too many files. */
static file *add(void)
{
    if (all.count == FILES)
        return NULL;
    file *f = &all.files[all.count++];
    *f = (file){ .kind = web_kind };
    beside(f->name, "", web_name);
    return f;
}

/* -- pictures ------------------------------------------------------------------------ */

/* Returns memory for the pixels of the wanted picture: 0xAARRGGBB, or 16-bit greys.
 * NULL: too large. */
EXPORT(void *, room, uint32_t w, uint32_t h)
{
    const bool grey = web_kind == WEB_GREY;
    const size_t pixels = (size_t)w * h * (grey ? sizeof(uint16_t) : sizeof(uint32_t));
    const size_t bytes = grey ? pixels : tp_texture_bytes(w, h);
    all.w = w;
    all.h = h;
    all.memory = bytes ? web_take(bytes) : NULL;
    all.pixels = all.memory;
    if (all.memory && !grey) {              /* beyond the arena's top, until copied */
        const uintptr_t mark = web_mark();
        all.pixels = web_take(pixels);
        web_restore_mark(mark);
    }
    return all.pixels;
}

static tp_status take_picture(void)
{
    file *f = add();
    if (!f || !all.pixels)
        return TP_FAIL(&all.error, TP_E_TEXTURE, 0, all.w, all.h);
    if (web_kind == WEB_GREY) {
        f->grey = (tp_grey){ all.w, all.h, all.memory };
        return TP_OK;
    }
    return tp_texture_init(&f->texture, all.pixels, all.w, all.h, all.memory,
                           tp_texture_bytes(all.w, all.h), &all.error);
}

/* -- meshes -------------------------------------------------------------------------- */

/* Names the next file wanted by the OBJ being read.  Returns false if there is none; the
 * mesh is then complete. */
static bool want_of_mesh(file *f)
{
    const tp_texture *textures[FILES];
    char library[TP_NAME_BYTES], image[TP_NAME_BYTES];

    if (f->stage == LIBRARIES && f->library < all.obj.libraries) {
        beside(web_name, f->name, tp_obj_library(&all.obj, f->library));
        web_kind = WEB_TEXT;
        tp_mtl_begin(&all.obj, f->library);
        return true;
    }
    for (uint32_t i = 0; i < all.obj.images && i < FILES; i++) {
        beside(library, f->name,
               tp_obj_library(&all.obj, tp_obj_image_library(&all.obj, i)));
        beside(image, library, tp_obj_image(&all.obj, i));
        const file *picture = have(image, WEB_PICTURE);
        if (!picture)
            return true;
        textures[i] = &picture->texture;
    }
    tp_obj_finish(&all.obj, textures, &f->mesh, &all.error);
    f->stage = BOUND;
    all.reading = NULL;
    return false;
}

/* Returns the mesh of that name, or NULL if a file is wanted first. */
static const tp_mesh *have_mesh(const char *name)
{
    file *f = have(name, WEB_TEXT);
    if (!f) {
        f = all.reading = add();
        if (f)
            tp_obj_begin_count(&all.obj);
    }
    if (!f || f->stage <= LOAD)
        return NULL;
    return f->stage == BOUND || !want_of_mesh(f) ? &f->mesh : NULL;
}

/* Passes `bytes` of the wanted file from web_text to its reader.  Returns 0, or an error
 * with its text in web_text. */
EXPORT(int, feed, size_t bytes)
{
    const file *f = all.reading;
    const tp_status status = f->stage == LIBRARIES
        ? tp_mtl_feed(&all.obj, web_text, bytes, &all.error)
        : tp_obj_feed(&all.obj, web_text, bytes, &all.error);
    return status ? web_refuse(&all.error) : 0;
}

static tp_status take_text(void)
{
    file *f = all.reading;
    void *memory;
    if (f->stage == SCAN) {
        if (tp_obj_end_count(&all.obj, &all.error))
            return all.error.code;
        memory = web_take(tp_obj_memory_bytes(&all.obj));
        if (!memory)
            return TP_FAIL(&all.error, TP_E_NOSPACE, 0, tp_obj_memory_bytes(&all.obj), 0);
        tp_obj_begin_load(&all.obj, memory);
    } else if (f->stage == LOAD) {
        if (tp_obj_end_load(&all.obj, &all.error))
            return all.error.code;
    } else {
        f->library++;
        return tp_mtl_end(&all.obj, &all.error);
    }
    f->stage++;
    return TP_OK;
}

/* -- calls of the page --------------------------------------------------------------- */

/* The wanted file is complete.  Returns 0, or an error with its text in web_text. */
EXPORT(int, given, void)
{
    const tp_status status = web_kind == WEB_TEXT ? take_text() : take_picture();
    return status ? web_refuse(&all.error) : 0;
}

/* Drops incomplete files after a failure. */
EXPORT(void, forget, void)
{
    all.reading = NULL;
    while (all.count && all.files[all.count - 1].kind == WEB_TEXT
           && all.files[all.count - 1].stage < BOUND)
        all.count--;
}

/* -- the scene ----------------------------------------------------------------------- */

/* Returns false if a named file is wanted.  Names in scenes are relative to the scenes'
 * folder: "../skies/day-up.png" is assets/skies/day-up.png. */
static bool place(const tp_texture **slot, const char *name)
{
    const file *f = *name ? have(name, WEB_PICTURE) : NULL;
    *slot = f ? &f->texture : NULL;
    return f || !*name;
}

static bool place_grey(const tp_grey **slot, const char *name)
{
    const file *f = *name ? have(name, WEB_GREY) : NULL;
    *slot = f ? &f->grey : NULL;
    return f || !*name;
}

bool web_find_assets(const tp_scene *s)
{
    tp_assets *a = &web_assets;
    const struct { const tp_texture **slot; const char *name; } pictures[] = {
        { &a->layer[0], s->layer[0].map.texture },
        { &a->layer[1], s->layer[1].map.texture },
        { &a->layer[2], s->layer[2].map.texture },
        { &a->distortion, s->distortion.map.texture },
        { &a->ripple, s->ripple.map.texture },
        { &a->foam, s->foam.map.texture },
        { &a->sky[0], s->sky.east }, { &a->sky[1], s->sky.west },
        { &a->sky[2], s->sky.up }, { &a->sky[3], s->sky.down },
        { &a->sky[4], s->sky.south }, { &a->sky[5], s->sky.north },
        { &a->tank_wall, s->tank.wall }, { &a->tank_floor, s->tank.floor },
        { &a->floor_texture, s->floor.texture },
    };
    const struct { const tp_grey **slot; const char *name; } greys[] = {
        { &a->floor, s->floor.map },
        { &a->pool_mask, s->pool.mask },
        { &a->field_mask, s->field.mask },
    };

    a->boat = NULL;
    if (s->boat.mesh[0] && !(a->boat = have_mesh(s->boat.mesh)))
        return false;
    for (size_t i = 0; i < sizeof pictures / sizeof *pictures; i++)
        if (!place(pictures[i].slot, pictures[i].name))
            return false;
    for (size_t i = 0; i < sizeof greys / sizeof *greys; i++)
        if (!place_grey(greys[i].slot, greys[i].name))
            return false;
    return true;
}
