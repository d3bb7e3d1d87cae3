/* SPDX-License-Identifier: MIT */
/* Meshes for higher ranks: access to a mesh beyond its open struct, and the reader of
 * Wavefront OBJ and MTL, which ports drive. */
#ifndef TP_MESH_MESH_H
#define TP_MESH_MESH_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/assets.h"

/* -- access to a mesh ---------------------------------------------------------------- */

/* Access to a mesh for higher ranks, beyond its open struct: its unit, and unit vectors
 * packed in one word.
 *
 * 511 stands for 1.0: a component is off by at most 1/1022, or 0.06 degrees, less than a
 * step of an 8-bit normal map. */

#define TP_DIR_ONE 511

/* Returns the metres of 1.0 in the mesh's positions.  A unit of the file is `scale` metres,
 * 0 to 100: below 2^15 in 16.16. */
static inline tp_fx tp_mesh_metres_per_unit(const tp_mesh *mesh, tp_fx scale)
{
    return (tp_fx)((uint32_t)scale << mesh->log2_unit);
}

static inline uint32_t tp_dir_pack_component(tp_q30 x)
{
    return (uint32_t)(((int64_t)x * TP_DIR_ONE + (1 << 29)) >> 30) & 1023;
}

/* Packs a direction; |component| <= 1. */
static inline tp_packed_dir tp_dir_pack(tp_dir3 d)
{
    return tp_dir_pack_component(d.x) | tp_dir_pack_component(d.y) << 10
           | tp_dir_pack_component(d.z) << 20;
}

/* Returns bits 0..9 as a signed number. */
static inline int32_t tp_dir_unpack_component(uint32_t part)
{
    return (int32_t)((part & 1023) ^ 512) - 512;
}

/* Components of a packed direction, -511..511. */
static inline int32_t tp_dir_x(tp_packed_dir n) { return tp_dir_unpack_component(n); }
static inline int32_t tp_dir_y(tp_packed_dir n) { return tp_dir_unpack_component(n >> 10); }
static inline int32_t tp_dir_z(tp_packed_dir n) { return tp_dir_unpack_component(n >> 20); }

/* -- the reader ---------------------------------------------------------------------- */

/* The reader of meshes, in the caller's memory.  The core opens no file.
 *
 * A mesh is read from Wavefront OBJ text in two passes.  The first pass checks and counts;
 * the second fills memory of the counted size.
 *
 *     tp_obj_begin_count(&obj);        feed the bytes ...  tp_obj_end_count(&obj, &err)
 *     mem = tp_obj_memory_bytes(&obj)
 *     tp_obj_begin_load(&obj, mem);   feed the same bytes ...  tp_obj_end_load(&obj, &err)
 *     for each i < obj.libraries: read the file tp_obj_library(&obj, i), then
 *         tp_mtl_begin(&obj, i);  feed its bytes ...  tp_mtl_end(&obj, &err)
 *     for each i < obj.images: make a texture of the file tp_obj_image(&obj, i)
 *     tp_obj_finish(&obj, textures, &mesh, &err)
 *
 * Every function with an error argument returns the code of the error.  After a failure
 * only a new tp_obj_begin_count may follow, and no mesh exists.
 *
 * A fault in a part that can be skipped is a warning: tp_obj_end_load, tp_mtl_end and
 * tp_obj_finish store their warnings in obj.warning.  A missing library is skipped: its
 * materials are grey. */

/* -- OBJ and MTL --------------------------------------------------------------------- */

/* Choices where the format leaves room:
 *  - Normals not given by the file are computed.  Within a smoothing group (s N) a normal
 *    is the mean of the faces around a position, weighted by their area.  Without `s`, or
 *    with `s 0` or `s off`, normals are flat.  Groups do not share normals, even at one
 *    position.
 *  - A polygon is cut in its plane, and every corner of the outline is kept.  Triangles
 *    without area are left out and counted in `dropped`, faces of fewer than three corners
 *    in `short_faces`.  A polygon of n corners takes at most 2048 n tests: polygons of up
 *    to 300 corners never need more.  If a larger polygon does, the rest is cut untested.
 *  - Positions may reach TP_OBJ_RANGE units in each direction.  Texture coordinates beyond
 *    +-TP_OBJ_REPEATS count as 0 and are counted in `far_texcoords`.
 *  - The rest of a usemtl, newmtl or map line is one name and may hold spaces.  The rest
 *    of mtllib is read the same way, except that a word ending in ".mtl" also ends a
 *    name.  `#` begins a comment at the start of a line and between numbers, not within
 *    names.  A comment line does not continue and may have any length.
 *  - Faces before any usemtl, and `usemtl` without a name, get the reader's grey.  A
 *    material used but not defined gets the same grey; it is a warning if all libraries
 *    were read (at least one).  Of two definitions, or two maps of one kind, the first
 *    counts; bump and norm are maps of one kind.
 *  - Nothing in an MTL is an error.  An unreadable line is skipped, a number out of range
 *    is clamped, and both are warnings.
 *  - Faces of opacity 0 (`d 0`) are not drawn: they are lids.  Where a lid lies in front
 *    of something solid, water behind the lid is left out and water in front of it is
 *    drawn.  A lid at the gunwale, facing up, keeps a hull dry until a wave stands higher.
 *  - MTL keywords are read in any case.  `d` takes precedence over Tr.  The options of a
 *    map are parsed to find its name, but only -bm has an effect. */

#define TP_OBJ_LINE_BYTES  4096         /* bytes of a logical line, continuations joined; f
                                         * and skipped statements may have any length */
#define TP_OBJ_COUNT       (1u << 24)   /* vertices, faces, corners, ... of one file */
#define TP_OBJ_RANGE       4194304      /* limit of positions in units, not included */
#define TP_OBJ_REPEATS     16384        /* limit of texture coordinates, not included */
#define TP_OBJ_MATERIALS   4096         /* of one mesh; further materials are grey */
#define TP_OBJ_WARNINGS    16           /* number of warnings stored */

/* Private: the counts of one pass over the file; both passes must agree. */
typedef struct {
    uint32_t vertices, texcoords, normals, polygons, corners, triangles;
    uint32_t largest;                   /* corners of the largest polygon */
    uint32_t smooth;                    /* corners that need a smooth normal */
    uint32_t position_bits;             /* bitwise or of the whole parts of all coordinates
                                         * without signs; its highest bit selects the unit
                                         * of the mesh */
    uint32_t bytes;                     /* bytes of text, modulo 2^32 */
    uint64_t digest;                    /* digest of all numbers */
} tp_obj_counts;

/* Private: the logical line under construction. */
typedef struct {
    uint32_t used;                      /* bytes of text */
    uint32_t part;                      /* bytes handed out, as part of a long line */
    uint32_t first, next;               /* file line of its start; of the next byte */
    bool     open;                      /* a line has begun, its end is not yet seen */
    bool     comment;
    bool     after_cr;                  /* a LF next belongs to the CR before */
    bool     continues, goes_on;        /* the part is not its line's first; last */
    bool     split;                     /* the part ends within a word */
    char     text[TP_OBJ_LINE_BYTES];
} tp_obj_lines;

/* Private: the face of the current line. */
typedef struct {
    uint32_t corners;
    int      form;
    int32_t  held[2][3];                /* indices of the first two corners */
    bool     ended;                     /* a comment ended the face */
} tp_obj_face_state;

/* Private: a set of names, each with a tag, numbered in order of arrival. */
typedef struct {
    char     *text;                     /* the names, each terminated */
    uint32_t *start, *tag;              /* by number */
    uint32_t *line;                     /* first file line of each name */
    uint32_t *table;                    /* number + 1 by hash; open addressing */
    uint32_t  count, most;
    uint32_t  used, room;               /* bytes of text */
    uint32_t  mask;                     /* table size - 1 */
} tp_obj_names;

/* Private: the layout of the caller's block. */
typedef struct {
    tp_material           *materials;
    tp_mesh_face          *faces;
    union  tp_obj_vertex  *vertices;    /* one per distinct corner */
    struct tp_obj_made    *made;        /* private data of each material */
    tp_obj_names           material_names, library_names;
    /* Used until tp_obj_end_load: */
    tp_vec3               *positions;
    struct tp_obj_texcoord *texcoords;
    tp_packed_dir         *normals;
    uint32_t              *corners;     /* vertex indices, polygon after polygon */
    struct tp_obj_polygon *polygons;
    struct tp_obj_slot    *slots;       /* sums of smooth normals */
    struct tp_obj_cut     *cut;         /* state of polygon cutting */
    uint32_t              *table;       /* index + 1 of vertices, then of slots */
    uint32_t               mask;
    uint32_t               n_vertices, n_faces, n_slots;
    /* Used after tp_obj_end_load, in the same memory: */
    tp_obj_names           image_names;
} tp_obj_memory;

/* The reader.  Takes about 9 KB; open in layout so that it can be static. */
typedef struct tp_obj {
    uint32_t libraries;                 /* files named by mtllib, each once */
    uint32_t images;                    /* pictures named by materials, each once */
    uint32_t skipped;                   /* statements not known or not used */
    uint32_t dropped;                   /* triangles without area, left out */
    uint32_t short_faces;               /* faces of fewer than 3 corners, left out */
    uint32_t far_texcoords;             /* texture coordinates out of range, taken as 0 */
    uint32_t warnings;                  /* number of warnings of loading, of the last
                                         * library, or of binding */
    tp_error warning[TP_OBJ_WARNINGS];  /* the first warnings */
    /* -- private part -- */
    uint32_t stage;
    size_t   bytes;
    tp_obj_counts now, total;           /* counts of this pass; of the scan */
    uint32_t name_most[2], name_room[2];/* bounds for libraries, materials */
    uint32_t name_longest;              /* longest material name, bytes */
    bool     crowded;                   /* more than TP_OBJ_MATERIALS were found */
    uint32_t material;                  /* material of the following faces */
    uint32_t group;                     /* smoothing group of the following faces */
    uint32_t library, libraries_read;
    uint32_t area_shift, picture_shift; /* scales of the sums of areas */
    uint32_t log2_unit;                 /* unit of positions, as in the mesh */
    uint32_t statement;                 /* statement of a line that arrives in parts */
    tp_vec3  low, high;
    tp_obj_face_state face;
    tp_obj_memory store;
    tp_obj_lines lines;
    char     seen[2048];                /* scan: names already counted */
} tp_obj;

void      tp_obj_begin_count(tp_obj *obj);
tp_status tp_obj_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
tp_status tp_obj_end_count(tp_obj *obj, tp_error *err);
size_t tp_obj_memory_bytes(const tp_obj *obj); /* size of the memory, aligned to 8, */
void      tp_obj_begin_load(tp_obj *obj, void *mem);  /* for loading and binding together */
tp_status tp_obj_end_load(tp_obj *obj, tp_error *err);

const char *tp_obj_library(const tp_obj *obj, uint32_t i);  /* as written, terminated */
uint32_t    tp_obj_library_line(const tp_obj *obj, uint32_t i); /* line in the OBJ */
void      tp_mtl_begin(tp_obj *obj, uint32_t library);
tp_status tp_mtl_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
tp_status tp_mtl_end(tp_obj *obj, tp_error *err);

const char *tp_obj_image(const tp_obj *obj, uint32_t i);
uint32_t    tp_obj_image_library(const tp_obj *obj, uint32_t i);    /* library number */
uint32_t    tp_obj_image_line(const tp_obj *obj, uint32_t i);       /* library's line */

/* `textures` holds one texture per image, or NULL for a missing image: its materials
 * keep their plain colour.  The mesh points into the memory given to tp_obj_begin_load and
 * to the textures. */
tp_status tp_obj_finish(tp_obj *obj, const tp_texture *const *textures, tp_mesh *mesh,
                        tp_error *err);

/* Returns the number of bytes from the start of the memory that the mesh uses after
 * tp_obj_finish; the rest is free for other use. */
size_t    tp_obj_finished_mesh_bytes(const tp_obj *obj);

#endif
