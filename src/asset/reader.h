/* SPDX-License-Identifier: MIT */
/* Textures and meshes, in the caller's memory.  The core opens no file.
 *
 * A mesh is read from Wavefront OBJ text twice: once to check and count it, once to
 * fill memory of the size that the counting found.
 *
 *     tp_obj_scan(&obj);        feed the bytes ...  tp_obj_scanned(&obj, &err)
 *     mem = tp_obj_bytes(&obj)
 *     tp_obj_load(&obj, mem);   feed the same bytes ...  tp_obj_loaded(&obj, &err)
 *     for each i < obj.libraries: read the file tp_obj_library(&obj, i), then
 *         tp_mtl_begin(&obj, i);  feed its bytes ...  tp_mtl_end(&obj, &err)
 *     for each i < obj.images: make a texture of the file tp_obj_image(&obj, i)
 *     tp_obj_bind(&obj, textures, &mesh, &err)
 *
 * Every function that takes an error returns its code; after a failure nothing but
 * a new tp_obj_scan may follow, and no mesh exists.
 *
 * What is wrong and can be left out is a warning: tp_obj_loaded, tp_mtl_end and
 * tp_obj_bind leave theirs in obj.warning.  A library that cannot be had is passed over:
 * its materials are grey. */
#ifndef TP_ASSET_READER_H
#define TP_ASSET_READER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "tidepool/assets.h"

/* -- OBJ and MTL ----------------------------------------------------------------
 *
 * Where the format leaves a choice:
 *  - Normals that the file does not give are computed: within a smoothing group (s N)
 *    the mean of the faces around a position, weighted by their area; flat where there
 *    is no `s`, or `s 0`, `s off`.  Groups do not share normals, even at one position.
 *  - A polygon is cut in its plane, every corner of the outline kept; triangles without
 *    area are left out and counted in `dropped`, faces of fewer than three corners in
 *    `short_faces`.  A polygon of n corners takes 2048 n tests at the most: those of up to
 *    300 never need so many, and of a larger one that does the rest is cut untested.
 *  - Positions may reach TP_OBJ_RANGE units either way; texture coordinates beyond
 *    +-TP_OBJ_REPEATS are taken as 0 and counted in `far_texcoords`.
 *  - The rest of a usemtl, newmtl or map line is one name and may hold spaces; so is the
 *    rest of mtllib, but that a word ending in ".mtl" also ends a name.  `#` begins a
 *    comment at the start of a line and between numbers, not within names; a comment
 *    line does not continue and may have any length.
 *  - `usemtl` without a name, and faces before any usemtl, get a grey of the reader's, and
 *    so does a material that is used and not defined: that is a warning if all libraries
 *    were read (at least one).  Of two definitions, and of two maps of one kind, the first
 *    counts, so bump before norm or norm before bump.
 *  - Nothing in an MTL is an error.  A line that cannot be read is left out, a number out
 *    of its range is held within it, and both are warnings.
 *  - Faces of opacity 0 (`d 0`) are not drawn: they are lids.  Where one lies before
 *    something solid, water beyond the lid is left out and water before it is not, so a
 *    lid at the gunwale, facing up, keeps a hull dry until a wave stands higher.
 *  - MTL keywords are read in any case; `d` goes before Tr; the options of a map are
 *    understood to find its name, but only -bm has an effect. */

#define TP_OBJ_LINE_BYTES  4096         /* of one logical line, continuations joined; an f,
                                         * and what is passed over, may have any length */
#define TP_OBJ_COUNT       (1u << 24)   /* of vertices, faces, corners, ... of one file */
#define TP_OBJ_RANGE       4194304      /* of positions in units, not included */
#define TP_OBJ_REPEATS     16384        /* of texture coordinates, not included */
#define TP_OBJ_MATERIALS   4096         /* of one mesh; the others are grey */
#define TP_OBJ_WARNINGS    16           /* that are kept */

/* Private: what one reading of the file has met; two readings must agree. */
typedef struct {
    uint32_t vertices, texcoords, normals, polygons, corners, triangles;
    uint32_t largest;                   /* corners of the largest polygon */
    uint32_t smooth;                    /* corners that need a smooth normal */
    uint32_t reach;                     /* all whole units of positions, or'ed */
    uint32_t bytes;                     /* of text, modulo 2^32 */
    uint64_t digest;                    /* of every number */
} tp_obj_counts;

/* Private: a logical line being put together. */
typedef struct {
    uint32_t used;                      /* bytes of text */
    uint32_t part;                      /* of them handed out, as part of a long line */
    uint32_t first, next;               /* file line of its start; of the next byte */
    bool     open;                      /* begun, its end not seen */
    bool     comment;
    bool     after_cr;                  /* a LF now belongs to the CR before */
    bool     continues, goes_on;        /* this part is not its line's first; not its last */
    bool     split;                     /* the part ends within a word */
    char     text[TP_OBJ_LINE_BYTES];
} tp_obj_lines;

/* Private: the face of the line that is being read. */
typedef struct {
    uint32_t corners;
    int      form;
    int32_t  held[2][3];                /* indices of the first two: there may be no third */
    bool     ended;                     /* by a comment */
} tp_obj_face_state;

/* Private: a set of names, each with a tag, numbered in the order of their coming. */
typedef struct {
    char     *text;                     /* the names, each terminated */
    uint32_t *start, *tag;              /* by number */
    uint32_t *line;                     /* of the file, where it was met first */
    uint32_t *table;                    /* number + 1 by hash; open addressing */
    uint32_t  count, most;
    uint32_t  used, room;               /* bytes of text */
    uint32_t  mask;                     /* of the table */
} tp_obj_names;

/* Private: the caller's block, carved. */
typedef struct {
    tp_material           *materials;
    tp_mesh_face          *faces;
    union  tp_obj_vertex  *vertices;    /* one for each different corner */
    struct tp_obj_made    *made;        /* of each material, what only the reader needs */
    tp_obj_names           material_names, library_names;
    /* Until tp_obj_loaded: */
    tp_vec3               *positions;
    struct tp_obj_texcoord *texcoords;
    tp_packed_dir         *normals;
    uint32_t              *corners;     /* indices of vertices, polygon after polygon */
    struct tp_obj_polygon *polygons;
    struct tp_obj_slot    *slots;       /* smooth normals being summed */
    struct tp_obj_cut     *cut;         /* the polygon being cut */
    uint32_t              *table;       /* of vertices, then of slots: index + 1 */
    uint32_t               mask;
    uint32_t               n_vertices, n_faces, n_slots;
    /* After it, in the same place: */
    tp_obj_names           image_names;
} tp_obj_store;

/* The reader.  About 9 KB, for any place; open in layout so that it can be static. */
typedef struct tp_obj {
    uint32_t libraries;                 /* files named by mtllib, each once */
    uint32_t images;                    /* pictures named by the materials, each once */
    uint32_t skipped;                   /* statements not known or not used, counted */
    uint32_t dropped;                   /* triangles without area, left out */
    uint32_t short_faces;               /* faces of fewer than 3 corners, left out */
    uint32_t far_texcoords;             /* texture coordinates out of range, taken as 0 */
    uint32_t warnings;                  /* of loading, of the last library, of binding: */
    tp_error warning[TP_OBJ_WARNINGS];  /* the first of them */
    /* -- private part -- */
    uint32_t stage;
    size_t   bytes;
    tp_obj_counts now, total;           /* of this pass; of the scan */
    uint32_t name_most[2], name_room[2];/* of libraries and materials: bounds */
    uint32_t name_longest;              /* of materials, bytes */
    bool     crowded;                   /* there are more than TP_OBJ_MATERIALS */
    uint32_t material;                  /* of the faces that follow */
    uint32_t group;                     /* smoothing group of the faces that follow */
    uint32_t library, libraries_read;
    uint32_t area_shift, picture_shift; /* scales of the sums of areas */
    uint32_t log2_unit;                 /* of positions, as in the mesh */
    uint32_t statement;                 /* of the line, while it comes in parts */
    tp_vec3  low, high;
    tp_obj_face_state face;
    tp_obj_store store;
    tp_obj_lines lines;
    char     seen[2048];                /* while scanning: names that were counted */
} tp_obj;

void      tp_obj_scan(tp_obj *obj);
tp_status tp_obj_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
tp_status tp_obj_scanned(tp_obj *obj, tp_error *err);
size_t    tp_obj_bytes(const tp_obj *obj);      /* of memory aligned to 8, all that */
void      tp_obj_load(tp_obj *obj, void *mem);  /* loading and binding will need */
tp_status tp_obj_loaded(tp_obj *obj, tp_error *err);

const char *tp_obj_library(const tp_obj *obj, uint32_t i);  /* as written, terminated */
uint32_t    tp_obj_library_line(const tp_obj *obj, uint32_t i); /* of the OBJ */
void      tp_mtl_begin(tp_obj *obj, uint32_t library);
tp_status tp_mtl_feed(tp_obj *obj, const void *text, size_t bytes, tp_error *err);
tp_status tp_mtl_end(tp_obj *obj, tp_error *err);

const char *tp_obj_image(const tp_obj *obj, uint32_t i);
uint32_t    tp_obj_image_library(const tp_obj *obj, uint32_t i);    /* that names it */
uint32_t    tp_obj_image_line(const tp_obj *obj, uint32_t i);       /* of that library */

/* `textures`: one for each image, or NULL for those that could not be had: their materials
 * keep their plain colour.  The mesh points into the memory given to tp_obj_load and at
 * the textures. */
tp_status tp_obj_bind(tp_obj *obj, const tp_texture *const *textures, tp_mesh *mesh,
                      tp_error *err);

/* After tp_obj_bind the mesh uses no more than this many bytes from the start of the
 * memory; the rest may serve other ends. */
size_t    tp_obj_kept_bytes(const tp_obj *obj);
#endif
