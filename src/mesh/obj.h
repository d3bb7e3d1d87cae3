/* SPDX-License-Identifier: MIT */
/*
 * Interface between the parts of the OBJ reader: the cutting of polygons, the hash of its
 * tables, its tokenizer, sets of names, area vectors, and the state shared by the
 * statements.
 *
 * Both passes run the same statements (obj.c, obj_statements.c): the scan counts, the
 * load also stores.  Polygons are cut after the whole file is read (obj_geometry.c,
 * triangulate.c), because a face may name vertices that follow it.  Then come the
 * materials (mtl.c) and the mesh (obj_finish.c).  Both passes mix every number into a
 * digest.  The digest detects a file that changed between the passes, and seeds the hash
 * tables.
 *
 * A statement that returns a fault stops the reading.  In an MTL, and for an unreadable
 * name, the fault is recorded as a warning instead and the line is skipped.
 *
 * A polygon is cut into triangles of its corners:
 *
 *     place n corners in cut->at, then
 *     tp_cut_begin(cut, n);
 *     while (tp_cut_next(cut, triangle))      n - 2 times
 *
 * The triangles turn the same way as the polygon and use every corner.  The test of a
 * triangle finds the corners near it by a grid (corner_grid.c).
 */
#ifndef TP_MESH_OBJ_H
#define TP_MESH_OBJ_H
#include <stdbool.h>
#include <stdint.h>
#include "base/base.h"
#include "mesh/mesh.h"
#include "tidepool/fixed.h"
#include "tidepool/modules.h"

/* -- triangles of a polygon ---------------------------------------------------------- */

#define TP_NO_CORNER UINT32_MAX

struct tp_obj_cut {
    int32_t  *at[3];                    /* coordinates of each corner, within +-2^30 */
    uint32_t *before, *after;           /* neighbours of the remaining corners */
    const int32_t *u, *v;               /* projected corners, turning left: 0..2^27 */
    uint32_t  start, left;              /* first corner to try; corners left */
    uint64_t  steps;                    /* steps left for tests */
    bool      flat;                     /* no area: corners are cut in order */
    uint32_t *tried;                    /* per corner: what blocked its last test */
    /* The grid of corner_grid.c: */
    uint32_t *cell, *next;              /* first corner of a cell; next in the cell */
    uint32_t  cols, shift;              /* cells in a row; a cell is 2^shift units square */
};

/* Allocates memory for polygons of up to `corners` corners. */
struct tp_obj_cut *tp_cut_layout(tp_arena *arena, uint32_t corners);

/* Begins a polygon of n corners; 3 <= n <= allocated number.  Changes cut->at. */
void tp_cut_begin(struct tp_obj_cut *cut, uint32_t n);

/* Returns the next triangle as three corner numbers; false at the end. */
bool tp_cut_next(struct tp_obj_cut *cut, uint32_t triangle[3]);

/* -- the grid of corners ------------------------------------------------------------- */

/* The corners of a polygon, sorted into a grid of square cells over its extent.  A cell has
 * 8 to 32 corners on average: the test of a small triangle meets only few corners. */

/* True if the corner has been cut off. */
static inline bool tp_cut_is_removed(const struct tp_obj_cut *cut, uint32_t corner)
{
    return cut->before[cut->after[corner]] != corner;
}

/* Returns the number of cells for a polygon of n corners. */
uint32_t tp_cut_grid_cells(uint32_t n);

/* Sorts the n corners into their cells; u and v lie within 0..extent. */
void tp_cut_grid_fill(struct tp_obj_cut *cut, uint32_t n, uint32_t extent_u,
                      uint32_t extent_v);

/* A walk over the corners in the cells within reach of a triangle. */
typedef struct {
    struct tp_obj_cut *cut;
    const uint32_t    *triangle;
    uint32_t          *link;            /* link to the next corner */
    uint32_t           row, last_row;   /* row of the cell; last row of the walk */
    uint32_t           col, last_col, low_col, high_col;
    uint32_t           steps;           /* corners and cells visited */
} tp_cut_walk;

/* `from` is the corner after which the walk begins, where an earlier walk over the same
 * triangle stopped, or TP_NO_CORNER. */
tp_cut_walk tp_cut_walk_begin(struct tp_obj_cut *cut, const uint32_t triangle[3],
                              uint32_t from);

/* Returns the next corner that is not cut off, TP_NO_CORNER at the end. */
uint32_t tp_cut_walk_next_corner(tp_cut_walk *walk);

/* -- hash ---------------------------------------------------------------------------- */

/* Sizes and the mixing step shared by the reader's hash tables. */

/* Returns the smallest power of two >= 1.5 n, at least 2; n <= 2^26. */
static inline uint32_t tp_hash_table_size(uint32_t n)
{
    TP_ASSERT(n <= 1u << 26);
    uint32_t size = 2;
    while (size < n + n / 2)
        size *= 2;
    return size;
}

/* Mixes a number into a hash; every bit of both affects the low half.  The multiplier is
 * 2^64 over the golden ratio (Knuth, TAOCP 3, 6.4). */
static inline uint64_t tp_mix(uint64_t hash, uint64_t x)
{
    hash = (hash ^ x) * 0x9e3779b97f4a7c15u;
    return hash ^ hash >> 32;
}

/* -- words of a line ----------------------------------------------------------------- */

/* Splits a line of text into words.  Words are separated by blanks.  Every byte up to the
 * space is a blank: tabs, stray control bytes and NULs too. */

typedef struct { const char *at, *end; } tp_words;
typedef struct { const char *text; uint32_t bytes; } tp_word;

/* True for a space and for all control characters, NUL included. */
static inline bool tp_is_blank(char c) { return (unsigned char)c <= ' '; }

/* Skips blanks.  True if the line ends or a comment follows. */
bool tp_words_at_end(tp_words *words);

/* Skips blanks and returns the next word; a word of no bytes at the end. */
tp_word tp_word_next(tp_words *words);

/* Returns the rest of the line without the blanks around it. */
tp_word tp_word_rest(tp_words *words);

bool tp_word_is(tp_word word, const char *name);
bool tp_word_is_any_case(tp_word word, const char *name);   /* name in lower case */
bool tp_word_holds_nul(tp_word word);

/* Reads the next word as a number in 48.16.  Returns false and takes nothing if the word is
 * not a number.  Too large numbers saturate to +-TP_WIDE_MAX. */
bool tp_words_read_number(tp_words *words, int64_t *x);

/* Reads [+-] digits at the cursor, without skipping blanks; false if there is no number.
 * Saturates at +-INT32_MAX. */
bool tp_words_read_int_prefix(tp_words *words, int32_t *x);

/* -- logical lines ------------------------------------------------------------------- */

/* Builds logical lines from bytes that arrive in pieces of any size.
 *
 * A line ends at LF, CR LF or CR.  A backslash at the end joins the next line; backslash
 * and line end become a space.  Blank lines and lines that begin with # are skipped.
 *
 * A line of more than TP_OBJ_LINE_BYTES arrives in parts.  Parts end at a blank.  Their
 * ends depend on the line alone, not on the pieces. */

void tp_lines_begin(tp_obj_lines *lines);

/* Takes bytes from *at up to `end`.  Returns true for a line, or a part of a long line;
 * lines->first is the number of its first file line.  lines->continues: the part is not the
 * first part of its line.  lines->goes_on: the part is not the last part.  lines->split:
 * the last word is longer than a part and was cut.  Returns false if all bytes are taken
 * and more are needed.  The line stays valid until the next call, and may lie in the
 * caller's piece or in lines->text. */
bool tp_lines_next(tp_obj_lines *lines, const char **at, const char *end,
                   tp_words *line);

/* Call at the end of the file, after tp_lines_next returned false.  Returns true, with the
 * line or its last part, if the file ends without a line end. */
bool tp_lines_last(tp_obj_lines *lines, tp_words *line);

/* -- sets of names ------------------------------------------------------------------- */

/* A set of names in memory counted beforehand: materials, libraries, images.  Each name has
 * a tag; the same text with two tags counts as two names. */

#define TP_NO_NAME UINT32_MAX

/* Empties the set. */
void tp_names_clear(tp_obj_names *names);

/* Returns the number of the name, or TP_NO_NAME.  `seed` must be the same for the
 * life of the set. */
uint32_t tp_names_find(const tp_obj_names *names, tp_word word, uint32_t tag,
                       uint64_t seed);

/* Returns the number of the name like tp_names_find, but adds a missing name, as found in
 * `line`.  Returns TP_NO_NAME if there is no room. */
uint32_t tp_names_find_or_add(tp_obj_names *names, tp_word word, uint32_t tag,
                              uint32_t line, uint64_t seed);

static inline const char *tp_names_text(const tp_obj_names *names, uint32_t i)
{
    return names->text + names->start[i];
}

/* -- area vectors -------------------------------------------------------------------- */

/* Exact area vectors: a vector along the normal of a triangle, of twice its area, in
 * units of 2^-32 m2.
 *
 * Coordinates lie within +-(2^30 - 1): edges have 31 bits and a sign, products are
 * below 2^62, and each component is below 2^63.  Sums add vectors divided by 2^shift.
 * The shift depends on the extent and on the number of triangles; it is 0 below 32 m
 * and 2^19 triangles. */

typedef struct { int64_t x, y, z; } tp_area;

/* Returns a x b, for edges a and b. */
tp_area tp_area_cross(tp_vec3 a, tp_vec3 b);

/* Returns a p - b q, exact under the same bounds. */
static inline int64_t tp_area_product_difference(int32_t a, int32_t p, int32_t b, int32_t q)
{
    return (int64_t)a * p - (int64_t)b * q;
}

static inline bool tp_area_is_none(tp_area a) { return (a.x | a.y | a.z) == 0; }

/* Returns the shift that keeps the sum of `count` vectors, or of their lengths, in 63 bits,
 * if no component of an edge is longer than `extent`. */
uint32_t tp_area_sum_shift(uint32_t extent, uint32_t count);

tp_area tp_area_divide_pow2(tp_area a,
                            uint32_t shift);        /* towards 0: favours no direction */
uint64_t tp_area_length(tp_area a);                 /* relative error < 2^-29 */

/* -- the reader ---------------------------------------------------------------------- */

/* The state of the reader; a call out of order returns E_ARG. */
enum {
    TP_STAGE_SCAN, TP_STAGE_SCANNED, TP_STAGE_LOAD, TP_STAGE_LOADED, TP_STAGE_MTL,
    TP_STAGE_FAILED
};

enum { TP_NAMES_LIBRARY, TP_NAMES_MATERIAL };

#define TP_NO_TEXCOORD UINT32_MAX

/* Source of a corner's normal: two bits of kind above an index. */
#define TP_NORMAL_FILE  (0u << 30)      /* index of a vn */
#define TP_NORMAL_GROUP (1u << 30)      /* smoothing group; then a tp_obj_slot */
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
    uint64_t area, picture;             /* sums over its faces, see obj_geometry.c */
    uint32_t map[TP_MAPS];              /* number of the image, or TP_NO_NAME */
    bool     defined, has_diffuse, has_opacity;
};

/* obj.c: reads the next `most` numbers of a line, at least `need`, in 48.16. */
tp_status tp_obj_read_numbers(const tp_obj *obj, tp_words *words, tp_word keyword,
                              uint32_t need, uint32_t most, int64_t *numbers,
                              uint32_t *found, tp_error *err);

/* obj.c: returns TP_OK if `more` can be added to `now`.  The limit is TP_OBJ_COUNT in the
 * scan, and the total of the scan in the load. */
tp_status tp_obj_check_room(const tp_obj *obj, uint32_t now, uint32_t total, uint32_t more,
                            tp_error *err);

/* obj.c: returns the rest of the line as a name, possibly of no bytes. */
tp_status tp_obj_read_rest_as_name(const tp_obj *obj, tp_words *words, tp_word *name,
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
/* Returns `status` unchanged; after a status other than TP_OK all later calls of the reader
 * fail. */
tp_status tp_obj_latch_failure(tp_obj *obj, tp_status status);

/* obj_statements.c: the statements usemtl and mtllib. */
tp_status tp_obj_usemtl(tp_obj *obj, tp_words *words, tp_error *err);
tp_status tp_obj_mtllib(tp_obj *obj, tp_words *words, tp_error *err);

/* obj_statements.c: the statement f, or a part of it. */
tp_status tp_obj_face(tp_obj *obj, tp_words *words, tp_error *err);

/* obj_layout.c: lays out the store; an arena without a block only counts. */
void tp_obj_layout(tp_obj *obj, tp_arena *arena);

/* obj_geometry.c: turns polygons into faces; computes normals and the final form of
 * vertices. */
tp_status tp_obj_build_faces(tp_obj *obj, tp_error *err);

#endif
