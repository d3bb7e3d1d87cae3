/* SPDX-License-Identifier: MIT */
/* A film while it happens: through ffmpeg into NAME-0001.mp4 where there is one, else
 * NAME-0001.y4m, and says which and why. */
#ifndef HOST_RECORDER_H
#define HOST_RECORDER_H
#include <stdbool.h>
#include "film.h"

typedef struct recorder recorder;

/* NULL: it cannot be had, and said why. */
recorder *recorder_begin(const char *scene, uint32_t width, uint32_t height);

/* A picture; of another size than at the beginning it ends the film, and says so.  False:
 * the film has ended (and what there is of it is whole). */
bool      recorder_add(recorder *r, const picture *p);
int       recorder_end(recorder *r);            /* says what was written, and how long */
const char *recorder_name(const recorder *r);
uint32_t  recorder_pictures(const recorder *r);
#endif
