/* SPDX-License-Identifier: MIT */
/* The reference's picture of one world, drawn on a thread of its own: with 1 sample per
 * pixel, then with 4, then with 16.  Optionally preceded by a pass with 1 sample per 4x4
 * pixels, in a sixteenth of the time. */
#ifndef TP_APP_SESSION_REFERENCE_THREAD_H
#define TP_APP_SESSION_REFERENCE_THREAD_H
#include "app/scene/loaded_scene.h"

typedef struct reference_thread reference_thread;

/* Begins with the current loaded scene, whose frame renderer has just drawn its world.
 * Scene, world and picture are copied; the assets must outlive the reference thread.  NULL:
 * no memory, or no thread. */
reference_thread  *reference_thread_begin(const loaded_scene *s, bool coarse);

/* Stops drawing and ends the thread within some ms.  Accepts NULL. */
void     reference_thread_end(reference_thread *t);

/* Passes of the reference, in order. */
typedef enum {
    REFERENCE_NONE,
    REFERENCE_COARSE,
    REFERENCE_1,
    REFERENCE_4,
    REFERENCE_16
} reference_pass;

/* Copies the frame renderer's picture and the reference's picture of the last finished
 * pass, both 0x00RRGGBB row by row.  Returns the pass; REFERENCE_NONE: none finished,
 * nothing copied. */
reference_pass reference_thread_take(reference_thread *t, uint32_t *ours, uint32_t *theirs);
/* true if a picture is not taken yet */
bool     reference_thread_has_news(reference_thread *t);
/* true if equal */
bool reference_thread_has_same_world(const reference_thread *t, const tp_world *world);

/* Returns the pass in progress, and its percentage; REFERENCE_NONE: all passes are
 * finished. */
reference_pass reference_thread_progress(reference_thread *t, uint32_t *percent);
#endif
