/* SPDX-License-Identifier: MIT */
/* Keeps the preview's state on disk.  First the world is written, with a name that
 * identifies its scene and changes, then the file with the name of the world.  At any crash
 * or power cut the file on disk and the world that it names belong together.
 *
 * A thread writes, from a copy.  An immediate write (session_put) waits for the thread and
 * then writes on the calling thread.  Several previews take turns by a lock on the folder;
 * the last preview to write is the one that --resume continues. */
#define _DEFAULT_SOURCE         /* for flock */
#define _POSIX_C_SOURCE 200809L
#include "session.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <unistd.h>
#include "app/files/atomic_file.h"
#include "app/files/log.h"
#include "app/files/path.h"
#include "app/files/snapshot.h"
#include "session_file.h"

typedef enum { TAKEN, EMPTY, FULL } fill;

struct session {
    char   *folder, *ini;       /* ini: session.ini in the folder */
    snapshot_store keep;        /* .build and .failed */
    bool    failed;             /* writing has failed, after a message */
    /* State to be written.  Owned by the thread while FULL, by session_put while TAKEN;
     * initially TAKEN, owned by the thread. */
    char   *text;
    session_world_name world;
    uint32_t scene, picture;
    void   *copy;
    size_t  bytes;
    pthread_t       thread;
    pthread_mutex_t mutex;      /* guards state and end */
    pthread_cond_t  changed;
    fill    state;
    bool    end;
};

/* -- writing ------------------------------------------------------------------------- */

static bool is_written(const session *s)
{
    FILE *file = fopen(s->ini, "rb");
    const char *c = s->text;
    int byte = EOF;
    while (file && (byte = getc(file)) == (unsigned char)*c && *c)
        c++;
    if (file)
        fclose(file);
    return file && byte == EOF && !*c;
}

/* Removes worlds that the file no longer names. */
static void remove_others(const session *s)
{
    DIR *dir = opendir(s->folder);
    for (struct dirent *entry; dir && (entry = readdir(dir)) != NULL;) {
        const char *name = entry->d_name;
        char *path = NULL;
        if (strncmp(name, SESSION_WORLD, strlen(SESSION_WORLD)) == 0
            && strcmp(name, s->world.name) != 0)
            path = path_join(s->folder, name, "");
        if (path)
            unlink(path);
        free(path);
    }
    if (dir)
        closedir(dir);
}

static int write_file(session *s)
{
    if (is_written(s))
        return EXIT_DONE;
    const bool done = atomic_file_write(s->ini, s->text, strlen(s->text), "", 0);
    if (!done && !s->failed)
        log_line("%s: cannot be saved: %s", s->ini, strerror(errno));
    s->failed = !done;
    if (done)
        remove_others(s);
    return done ? EXIT_DONE : EXIT_INPUT;
}

static int write_both(session *s)
{
    char *name = path_join(s->folder, s->world.name, "");
    const int lock = open(s->folder, O_RDONLY | O_CLOEXEC);
    if (lock >= 0)
        (void)flock(lock, LOCK_EX);
    int code = name ? EXIT_DONE : log_fail_memory(strlen(s->folder));
    s->keep.name = name;
    s->keep.scene = s->scene;
    if (!code)
        code = snapshot_write(&s->keep, s->copy, s->bytes,
                              (snapshot_progress){ .frame = s->picture });
    if (!code)
        code = write_file(s);
    if (lock >= 0)
        close(lock);
    s->keep.name = NULL;
    free(name);
    return code;
}

/* Body of the writing thread.  Reading the whole program for its digest takes 50 ms; on the
 * thread nobody waits for that. */
static void *work(void *user)
{
    static const tp_scene nothing;
    static const tp_assets none;
    session *s = user;
    s->keep = snapshot_begin("", &nothing, &none);
    pthread_mutex_lock(&s->mutex);
    s->state = EMPTY;
    pthread_cond_broadcast(&s->changed);
    while (!s->end || s->state == FULL) {
        if (s->state != FULL) {
            pthread_cond_wait(&s->changed, &s->mutex);
            continue;
        }
        pthread_mutex_unlock(&s->mutex);
        (void)write_both(s);
        pthread_mutex_lock(&s->mutex);
        s->state = EMPTY;
        pthread_cond_broadcast(&s->changed);
    }
    pthread_mutex_unlock(&s->mutex);
    return NULL;
}

/* -- collecting the state ------------------------------------------------------------ */

static bool copy_world(session *s, const tp_world *world, size_t bytes)
{
    if (bytes > s->bytes || !s->copy) {
        void *room = realloc(s->copy, bytes);
        if (!room)
            return false;
        s->copy = room;
    }
    memcpy(s->copy, world, bytes);
    s->bytes = bytes;
    return true;
}

static bool take(session *s, const scene_file *file, const tp_assets *assets,
                 const tp_world *world, size_t bytes, uint32_t picture)
{
    session_world_name name;
    tp_scene *nameless = malloc(sizeof *nameless);
    char *text = nameless ? session_text(file, &name) : NULL;
    const bool taken = text && copy_world(s, world, bytes);
    if (taken) {
        session_nameless(nameless, &file->scene);
        snapshot_set_scene(&s->keep, nameless, assets);
        s->scene = s->keep.scene;
        s->picture = picture;
        s->world = name;
        free(s->text);
        s->text = text;
        text = NULL;
    }
    free(text);
    free(nameless);
    return taken;
}

bool session_offer(session *s, const scene_file *file, const tp_assets *assets,
                   const tp_world *world, size_t bytes, uint32_t picture)
{
    if (!s)
        return false;
    pthread_mutex_lock(&s->mutex);
    const bool taken = s->state == EMPTY && take(s, file, assets, world, bytes, picture);
    if (taken) {
        s->state = FULL;
        pthread_cond_broadcast(&s->changed);
    }
    pthread_mutex_unlock(&s->mutex);
    return taken;
}

int session_put(session *s, const scene_file *file, const tp_assets *assets,
                const tp_world *world, size_t bytes, uint32_t picture)
{
    if (!s)
        return EXIT_INPUT;
    pthread_mutex_lock(&s->mutex);
    while (s->state != EMPTY)
        pthread_cond_wait(&s->changed, &s->mutex);
    s->state = TAKEN;
    pthread_mutex_unlock(&s->mutex);
    const int code = take(s, file, assets, world, bytes, picture) ? write_both(s)
                                                                  : log_fail_memory(bytes);
    pthread_mutex_lock(&s->mutex);
    s->state = EMPTY;
    pthread_mutex_unlock(&s->mutex);
    return code;
}

/* -- beginning and end --------------------------------------------------------------- */

static void say_once(const char *folder, int why)
{
    static bool said;
    if (!said && !folder && !why)
        log_line("tidepool view: neither XDG_STATE_HOME nor HOME is set: nothing is saved"
                 " for --resume");
    else if (!said)
        log_line("tidepool view: %s: nothing is saved for --resume", strerror(why));
    said = true;
}

static void release(session *s)
{
    free(s->folder);
    free(s->ini);
    free(s->text);
    free(s->copy);
    free(s);
}

session *session_begin(void)
{
    int why;
    char *folder = session_folder(true, &why);
    session *s = folder ? calloc(1, sizeof *s) : NULL;
    if (!s) {
        say_once(folder, why);
        free(folder);
        return NULL;
    }
    s->folder = folder;
    s->ini = path_join(folder, SESSION_INI, "");
    pthread_mutex_init(&s->mutex, NULL);
    pthread_cond_init(&s->changed, NULL);
    if (s->ini && pthread_create(&s->thread, NULL, work, s) == 0)
        return s;
    say_once(folder, ENOMEM);
    release(s);
    return NULL;
}

void session_end(session *s)
{
    if (!s)
        return;
    pthread_mutex_lock(&s->mutex);
    s->end = true;
    pthread_cond_broadcast(&s->changed);
    pthread_mutex_unlock(&s->mutex);
    pthread_join(s->thread, NULL);
    pthread_cond_destroy(&s->changed);
    pthread_mutex_destroy(&s->mutex);
    release(s);
}

/* -- resuming ------------------------------------------------------------------------ */

bool session_world(const tp_scene *scene, const tp_assets *assets, tp_world *world,
                   size_t bytes, uint32_t *picture)
{
    int why, code;
    session_world_name name;
    char *folder = session_folder(false, &why);
    char *text = folder ? session_load(folder, &name, &code) : NULL;
    char *path = text ? path_join(folder, name.name, "") : NULL;
    tp_scene *nameless = path ? malloc(sizeof *nameless) : NULL;
    bool taken = false;
    snapshot_progress at;
    if (nameless && access(path, F_OK) != 0) {
        log_line("%s: %s: a fresh start", path, strerror(errno));
    } else if (nameless) {
        session_nameless(nameless, scene);
        const snapshot_store k = snapshot_begin(path, nameless, assets);
        taken = snapshot_read(&k, world, bytes, &at);
        *picture = taken ? at.frame : *picture;
    }
    free(nameless);
    free(path);
    free(text);
    free(folder);
    return taken;
}
