/* SPDX-License-Identifier: MIT */
/* A world is plain data without pointers: copying its bytes is a snapshot.  What the bytes
 * mean depends on the program that wrote them and on the scene: both are in the head, and
 * a file of others is not taken.
 *
 *     "TPKEEP" 0 1 | scene | build | frame | bytes of the world | CRC-32 | the bytes
 *
 * Numbers are the machine's own, 32 bits; the CRC is of the whole file but itself. */
#define _POSIX_C_SOURCE 200809L
#include "keep.h"
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "../host/say.h"
#include "tidepool/pixel.h"

#define VERSION 1

typedef struct {
    char     magic[7];
    uint8_t  version;
    uint32_t scene, build, frame, bytes, crc;
} head;

static const char magic[7] = "TPKEEP";

/* -- digests --------------------------------------------------------------------- */

static uint32_t digest_grey(uint32_t crc, const tp_grey *grey)
{
    if (!grey)
        return crc;
    crc = tp_crc32(crc, &grey->cols, sizeof grey->cols);
    crc = tp_crc32(crc, &grey->rows, sizeof grey->rows);
    return tp_crc32(crc, grey->sample,
                    (size_t)grey->cols * grey->rows * sizeof *grey->sample);
}

/* Every parameter as text, and the maps that a world is made of. */
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

keep keep_begin(const char *name, const tp_scene *scene, const tp_assets *assets)
{
    keep k = { .name = name };
    if (name) {
        k.scene = digest_scene(scene, assets);
        k.build = digest_build();
    }
    return k;
}

void keep_scene(keep *k, const tp_scene *scene, const tp_assets *assets)
{
    k->scene = digest_scene(scene, assets);
}

static uint32_t digest(head h, const void *world)
{
    h.crc = 0;
    return tp_crc32(tp_crc32(0, &h, sizeof h), world, h.bytes);
}

/* -- taking ---------------------------------------------------------------------- */

/* What is wrong with it, or NULL. */
static const char *check(const keep *k, const head *h, const void *world, size_t bytes,
                         size_t got)
{
    if (got < sizeof *h || memcmp(h->magic, magic, sizeof magic) != 0)
        return "is no kept world";
    if (h->version != VERSION || h->build != k->build)
        return "was kept by another build";
    if (h->scene != k->scene || h->bytes != bytes)
        return "is of another scene";
    if (got != sizeof *h + bytes || h->crc != digest(*h, world))
        return "is not whole";
    return NULL;
}

bool keep_take(const keep *k, tp_world *world, size_t bytes, uint32_t *frame)
{
    FILE *file = k->name ? fopen(k->name, "rb") : NULL;
    if (!file) {
        if (k->name)
            say("%s: %s: a fresh start", k->name,
                errno == ENOENT ? "nothing is kept" : strerror(errno));
        return false;
    }
    uint8_t *copy = malloc(bytes + 1);          /* one more: a longer file is found out */
    head h;
    size_t got = copy ? fread(&h, 1, sizeof h, file) : 0;
    if (got == sizeof h)
        got += fread(copy, 1, bytes + 1, file);
    fclose(file);
    const char *wrong = copy ? check(k, &h, copy, bytes, got) : "finds no memory";
    if (wrong) {
        say("%s: %s: a fresh start", k->name, wrong);
    } else {
        memcpy(world, copy, bytes);
        *frame = h.frame;
    }
    free(copy);
    return !wrong;
}

/* -- putting --------------------------------------------------------------------- */

static bool write_all(int fd, const void *data, size_t bytes)
{
    const uint8_t *at = data;
    while (bytes > 0) {
        const ssize_t n = write(fd, at, bytes);
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            return false;
        at += n;
        bytes -= (size_t)n;
    }
    return true;
}

/* The rename is on the disk once its folder is. */
static void sync_folder(const char *name)
{
    char folder[4096];
    const char *slash = strrchr(name, '/');
    const size_t length = slash ? (size_t)(slash - name) : 0;
    if (length >= sizeof folder)
        return;
    memcpy(folder, name, length);
    folder[length] = '\0';
    const int fd = open(length ? folder : slash ? "/" : ".", O_RDONLY | O_CLOEXEC);
    if (fd >= 0) {
        (void)fsync(fd);
        close(fd);
    }
}

bool keep_file(const char *name, const void *head_part, size_t head_bytes,
               const void *body, size_t body_bytes)
{
    char fresh[4096];
    if (snprintf(fresh, sizeof fresh, "%s.new", name) >= (int)sizeof fresh) {
        errno = ENAMETOOLONG;
        return false;
    }
    const int fd = open(fresh, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0)
        return false;
    bool done = write_all(fd, head_part, head_bytes) && write_all(fd, body, body_bytes)
             && fsync(fd) == 0;
    done = close(fd) == 0 && done && rename(fresh, name) == 0;
    if (done)
        sync_folder(name);
    return done;
}

int keep_put(keep *k, const tp_world *world, size_t bytes, uint32_t frame)
{
    if (!k->name)
        return EXIT_DONE;
    head h = { .version = VERSION, .scene = k->scene, .build = k->build, .frame = frame,
               .bytes = (uint32_t)bytes };
    memcpy(h.magic, magic, sizeof magic);
    h.crc = digest(h, world);
    const bool done = keep_file(k->name, &h, sizeof h, world, bytes);
    if (!done && !k->failed)
        say("%s: cannot be kept: %s", k->name, strerror(errno));
    k->failed = !done;
    return done ? EXIT_DONE : EXIT_INPUT;
}
