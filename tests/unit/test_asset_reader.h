/* SPDX-License-Identifier: MIT */
/* Reads OBJ and MTL texts as a port would, in the way most likely to reveal faults: every
 * piece of text is a heap block of exact size, freed after the call, and the mesh memory
 * has exactly the required size and is filled with 0xA5. */
#ifndef TEST_ASSET_READER_H
#define TEST_ASSET_READER_H
#include <stdlib.h>
#include <string.h>
#include "asset/reader.h"

typedef struct {
    tp_obj   obj;
    tp_error err;
    tp_mesh  mesh;
    void    *mem;               /* NULL until loading begins */
    uint32_t warnings;          /* count over all steps, and the first warning */
    tp_error warned;
} reader;

typedef tp_status feeder(tp_obj *obj, const void *text, size_t bytes, tp_error *err);

static inline tp_status feed_pieces(feeder *feed, tp_obj *obj, const char *text,
                                    size_t bytes, size_t piece, tp_error *err)
{
    tp_status status = TP_OK;
    for (size_t i = 0; i < bytes && status == TP_OK; i += piece) {
        const size_t n = bytes - i < piece ? bytes - i : piece;
        char *const copy = malloc(n);
        memcpy(copy, text + i, n);
        status = feed(obj, copy, n, err);
        free(copy);
    }
    return status;
}

static inline tp_status scan_text(reader *r, const char *text, size_t bytes, size_t piece)
{
    memset(r, 0xA5, sizeof *r);
    r->err.code = r->warned.code = TP_OK;
    r->mem = NULL;
    r->warnings = 0;
    tp_obj_begin_count(&r->obj);
    tp_status status = feed_pieces(tp_obj_feed, &r->obj, text, bytes, piece, &r->err);
    return status != TP_OK ? status : tp_obj_end_count(&r->obj, &r->err);
}

static inline tp_status load_text(reader *r, const char *text, size_t bytes, size_t piece)
{
    r->mem = malloc(tp_obj_bytes(&r->obj));
    memset(r->mem, 0xA5, tp_obj_bytes(&r->obj));
    tp_obj_begin_load(&r->obj, r->mem);
    tp_status status = feed_pieces(tp_obj_feed, &r->obj, text, bytes, piece, &r->err);
    return status != TP_OK ? status : tp_obj_end_load(&r->obj, &r->err);
}

/* Adds the warnings of the step that has just ended. */
static inline void note_warnings(reader *r)
{
    if (r->warnings == 0 && r->obj.warnings > 0)
        r->warned = r->obj.warning[0];
    r->warnings += r->obj.warnings;
}

/* Runs both passes.  Every library that the file names reads `mtl`, if `mtl` is not
 * NULL. */
static inline tp_status read_bytes(reader *r, const char *text, size_t bytes,
                                   const char *mtl, size_t mtl_bytes, size_t piece)
{
    tp_status status = scan_text(r, text, bytes, piece);
    if (status == TP_OK)
        status = load_text(r, text, bytes, piece);
    if (status == TP_OK)
        note_warnings(r);
    for (uint32_t i = 0; mtl && status == TP_OK && i < r->obj.libraries; i++) {
        tp_mtl_begin(&r->obj, i);
        status = feed_pieces(tp_mtl_feed, &r->obj, mtl, mtl_bytes, piece, &r->err);
        if (status == TP_OK)
            status = tp_mtl_end(&r->obj, &r->err);
        if (status == TP_OK)
            note_warnings(r);
    }
    if (status == TP_OK)
        status = tp_obj_finish(&r->obj, NULL, &r->mesh, &r->err);
    if (status == TP_OK)
        note_warnings(r);
    return status;
}

static inline tp_status read_text(reader *r, const char *text, const char *mtl)
{
    return read_bytes(r, text, strlen(text), mtl, mtl ? strlen(mtl) : 0, 4096);
}

static inline void finish(reader *r)
{
    free(r->mem);
    r->mem = NULL;
}

/* Random numbers of all asset tests: splitmix64. */
static inline uint32_t next_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (uint32_t)((z ^ z >> 31) >> 32);
}

static inline uint64_t random_seed(void)
{
    const char *const text = getenv("TP_SEED");
    return text ? strtoull(text, NULL, 0) : 20261121;
}
#endif
