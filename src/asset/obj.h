/* SPDX-License-Identifier: MIT */
/* Interface between the parts of the OBJ reader.
 *
 * Both passes run the same statements (obj.c, face.c): the scan counts, the load also
 * stores.  Polygons are cut after the whole file is read (shape.c, cut.c), because a face
 * may name vertices that follow it.  Then come the materials (mtl.c) and the mesh (bind.c).
 * Both passes mix every number into a digest.  The digest detects a file that changed
 * between the passes, and seeds the hash tables.
 *
 * A statement that returns a fault stops the reading.  In an MTL, and for an unreadable
 * name, the fault is recorded as a warning instead and the line is skipped. */
#ifndef TP_ASSET_OBJ_H
#define TP_ASSET_OBJ_H
#include "asset/line.h"
#include "asset/names.h"
#include "asset/word.h"
#include "tidepool/modules.h"

/* The state of the reader; a call out of order returns E_ARG. */
enum {
    TP_STAGE_SCAN, TP_STAGE_SCANNED, TP_STAGE_LOAD, TP_STAGE_LOADED, TP_STAGE_MTL,
    TP_STAGE_FAILED
};

enum { TP_NAMES_LIBRARY, TP_NAMES_MATERIAL };

#define TP_NO_TEXCOORD UINT32_MAX

/* Source of a corner's normal: two bits of kind above an index. */
#define TP_NORMAL_FILE  (0u << 30)      /* index of a vn */
#define TP_NORMAL_GROUP (1u << 30)      /* smoothing group; later index of a slot */
#define TP_NORMAL_FLAT  (2u << 30)      /* index of a polygon */
#define TP_NORMAL_KNOWN (3u << 30)      /* the packed normal itself */
#define TP_NORMAL_KIND  (3u << 30)

/* Corners with the same three indices share a vertex.  At the end `corner`
 * becomes `out` in place. */
union tp_obj_vertex {
    struct { uint32_t position, texcoord, normal; } corner;
    tp_mesh_vertex out;
};
_Static_assert(sizeof(union tp_obj_vertex) == sizeof(tp_mesh_vertex), "used as an array");

struct tp_obj_texcoord { tp_fx s, t; };

struct tp_obj_polygon { uint32_t material, corners; };

/* The sum of the area vectors of a smoothing group's faces around one position. */
struct tp_obj_slot { int64_t sum[3]; uint32_t position, group; };

enum { TP_MAP_DIFFUSE, TP_MAP_BUMP, TP_MAPS };

struct tp_obj_made {
    uint64_t area, picture;             /* sums over its faces, in the units of shape.c */
    uint32_t map[TP_MAPS];              /* number of the image, or TP_NO_NAME */
    bool     defined, has_diffuse, has_opacity;
};

/* obj.c: reads the next `most` numbers of a line, at least `need`, in 48.16. */
tp_status tp_obj_read_numbers(const tp_obj *obj, tp_words *words, tp_word keyword,
                         uint32_t need, uint32_t most, int64_t *numbers, uint32_t *found,
                         tp_error *err);

/* obj.c: returns TP_OK if `more` can be added to `now`.  The limit is TP_OBJ_COUNT in the
 * scan, and the total of the scan in the load. */
tp_status tp_obj_check_room(const tp_obj *obj, uint32_t now, uint32_t total, uint32_t more,
                      tp_error *err);

/* obj.c: returns the rest of the line as a name, possibly of no bytes. */
tp_status tp_obj_read_name(const tp_obj *obj, tp_words *words, tp_word *name,
                           tp_error *err);

/* obj.c: returns the error for a line longer than its statement allows. */
tp_status tp_obj_fail_long_line(const tp_obj *obj, tp_error *err);

/* obj.c: records a fault that does not stop the reading.  The scan records none: the load
 * finds the same faults again. */
void tp_obj_warn(tp_obj *obj, const tp_error *fault);

/* obj.c: passes lines to `statement`; a failure ends the reading for good. */
typedef tp_status tp_obj_statement(tp_obj *obj, tp_words *line, tp_error *err);
tp_status tp_obj_lines_feed(tp_obj *obj, const void *text, size_t bytes,
                            tp_obj_statement *statement, tp_error *err);
tp_status tp_obj_lines_end(tp_obj *obj, tp_obj_statement *statement, tp_error *err);
tp_status tp_obj_latch_failure(tp_obj *obj, tp_status status);

/* use.c: the statements usemtl and mtllib.  tp_obj_use_default_material selects the
 * material "", used by faces before any usemtl. */
tp_status tp_obj_usemtl(tp_obj *obj, tp_words *words, tp_error *err);
tp_status tp_obj_mtllib(tp_obj *obj, tp_words *words, tp_error *err);
tp_status tp_obj_use_default_material(tp_obj *obj, tp_error *err);

/* face.c: the statement f, or a part of it. */
tp_status tp_obj_face(tp_obj *obj, tp_words *words, tp_error *err);

/* obj_store.c: lays out the store; an arena without a block only counts. */
void tp_obj_layout(tp_obj *obj, tp_arena *arena);

/* shape.c: turns polygons into faces; computes normals and the final form of vertices. */
tp_status tp_obj_build_geometry(tp_obj *obj, tp_error *err);
#endif
