/* SPDX-License-Identifier: MIT */
/* A world is plain data without pointers, so a copy of its bytes is a snapshot.  The
 * bytes are valid only for one program and one scene: the file's head has digests of
 * both, and a mismatch is refused.
 *
 *     "TPKEEP" 0 3 | scene | build | frame | played | bytes of the world | CRC-32 |
 *     the bytes
 *
 * Numbers are 32 bits in the machine's byte order.  The CRC covers the whole file except
 * the CRC itself.  A CRC detects accidents only: a forged file can have a valid CRC, so
 * the content is checked too before it becomes a world. */
#define _POSIX_C_SOURCE 200809L
#include "snapshot.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "atomic_file.h"
#include "log.h"
#include "pixel/pixel.h"
#include "tidepool/modules.h"
#include "world/world.h"

#define VERSION TP_WORLD_VERSION

typedef struct {
    char     magic[7];
    uint8_t  version;
    uint32_t scene, build;
    snapshot_progress at;
    uint32_t bytes, crc;
} head;

static const char magic[7] = "TPKEEP";

/* -- digests ------------------------------------------------------------------------- */

static uint32_t digest_grey(uint32_t crc, const tp_grey *grey)
{
    if (!grey)
        return crc;
    crc = tp_crc32(crc, &grey->cols, sizeof grey->cols);
    crc = tp_crc32(crc, &grey->rows, sizeof grey->rows);
    return tp_crc32(crc, grey->sample,
                    (size_t)grey->cols * grey->rows * sizeof *grey->sample);
}

/* Digest of every parameter as text, and of the maps used to make a world. */
static uint32_t digest_scene(const tp_scene *scene, const tp_assets *assets)
{
    uint32_t count, crc = 0;
    const tp_param *params = tp_params(&count);
    for (uint32_t i = 0; i < count; i++) {
        char text[256];
        const size_t length = tp_param_text(scene, &params[i], text, sizeof text);
        crc = tp_crc32(crc, text, length < sizeof text ? length + 1 : sizeof text);
    }
    crc = digest_grey(crc, assets->floor);
    crc = digest_grey(crc, assets->pool_mask);
    return digest_grey(crc, assets->field_mask);
}

static uint32_t digest_build(void)
{
    FILE *file = fopen("/proc/self/exe", "rb");
    uint8_t bytes[4096];
    uint32_t crc = 0;
    size_t n;
    while (file && (n = fread(bytes, 1, sizeof bytes, file)) > 0)
        crc = tp_crc32(crc, bytes, n);
    if (file)
        fclose(file);
    return crc;
}

snapshot_store snapshot_begin(const char *name, const tp_scene *scene,
                              const tp_assets *assets)
{
    snapshot_store k = { .name = name };
    if (name) {
        k.scene = digest_scene(scene, assets);
        k.build = digest_build();
    }
    return k;
}

void snapshot_set_scene(snapshot_store *k, const tp_scene *scene, const tp_assets *assets)
{
    k->scene = digest_scene(scene, assets);
}

static uint32_t digest(head h, const void *world)
{
    h.crc = 0;
    return tp_crc32(tp_crc32(0, &h, sizeof h), world, h.bytes);
}

/* -- reading ------------------------------------------------------------------------- */

/* Returns the fault of the file, or NULL. */
static const char *check_file(const snapshot_store *k, const head *h, const void *world,
                              size_t bytes, size_t got, char text[128])
{
    if (got < sizeof *h || memcmp(h->magic, magic, sizeof magic) != 0)
        return "is not a saved world";
    if (h->version != VERSION) {
        snprintf(text, 128, "holds a world of version %u, this program has version %u",
                 h->version, (unsigned)VERSION);
        return text;
    }
    if (h->build != k->build)
        return "was saved by another build";
    if (h->scene != k->scene || h->bytes != bytes)
        return "belongs to another scene";
    if (got != sizeof *h + bytes || h->crc != digest(*h, world))
        return "is incomplete";
    return NULL;
}

/* Returns the fault of the content, or NULL.  Compares with a fresh world, made for the
 * same position in the tape. */
static const char *check_world(const snapshot_store *k, const head *h, const tp_world *kept,
                               const tp_world *fresh, char text[128])
{
    const uint32_t played = h->at.played;
    tp_error err;
    if (played && (!k->remake || !k->remake(k->user, played)))
        return "was saved with another tape";
    if (tp_world_check(&tp_program_all, kept, h->bytes, fresh, &err) == TP_OK)
        return NULL;
    tp_error_text(&err, text, 128);
    if (played)
        (void)k->remake(k->user, 0);
    return text;
}

/* Reads the file.  Asks for one byte more than expected, to detect a longer file. */
static const char *read_file(const snapshot_store *k, FILE *file, head *h, void *copy,
                             size_t bytes, char text[128])
{
    size_t got = fread(h, 1, sizeof *h, file);
    if (got == sizeof *h)
        got += fread(copy, 1, bytes + 1, file);
    return ferror(file) ? "cannot be read" : check_file(k, h, copy, bytes, got, text);
}

/* Returns the fault, or NULL with *world and *at set. */
static const char *take(const snapshot_store *k, FILE *file, tp_world *world, size_t bytes,
                        snapshot_progress *at, char text[128])
{
    head h;
    void *copy = malloc(bytes + 1);
    const char *wrong = copy ? read_file(k, file, &h, copy, bytes, text)
                             : "no memory to read it";
    if (!wrong)
        wrong = check_world(k, &h, copy, world, text);
    if (!wrong) {
        memcpy(world, copy, bytes);
        *at = h.at;
    }
    free(copy);
    return wrong;
}

bool snapshot_read(const snapshot_store *k, tp_world *world, size_t bytes,
                   snapshot_progress *at)
{
    char text[128];
    FILE *file = k->name ? fopen(k->name, "rb") : NULL;
    if (!k->name)
        return false;
    const char *wrong = file ? take(k, file, world, bytes, at, text)
                      : errno == ENOENT ? "no saved world" : strerror(errno);
    if (file)
        fclose(file);
    if (wrong)
        log_line("%s: %s: a fresh start", k->name, wrong);
    return !wrong;
}

/* -- writing ------------------------------------------------------------------------- */

int snapshot_write(snapshot_store *k, const tp_world *world, size_t bytes,
                   snapshot_progress at)
{
    if (!k->name)
        return EXIT_DONE;
    head h = { .version = VERSION, .scene = k->scene, .build = k->build, .at = at,
               .bytes = (uint32_t)bytes };
    memcpy(h.magic, magic, sizeof magic);
    h.crc = digest(h, world);
    const bool done = atomic_file_write(k->name, &h, sizeof h, world, bytes);
    if (!done && !k->failed)
        log_line("%s: cannot be saved: %s", k->name, strerror(errno));
    k->failed = !done;
    return done ? EXIT_DONE : EXIT_INPUT;
}
