/* SPDX-License-Identifier: MIT */
/* Records a film of the running preview: with ffmpeg to NAME-0001.mp4, without ffmpeg to
 * NAME-0001.y4m.  A message names the file and the reason. */
#ifndef TP_APP_SESSION_RECORDER_H
#define TP_APP_SESSION_RECORDER_H
#include <stdbool.h>
#include "app/files/film.h"

typedef struct recorder recorder;

/* Returns NULL after printing the reason. */
recorder *recorder_begin(const char *scene, uint32_t width, uint32_t height);

/* Adds a picture.  A picture of another size ends the film, with a message.  False: the
 * film has ended; the recorded part is complete. */
bool      recorder_add(recorder *r, const picture *p);
int       recorder_end(recorder *r);            /* prints name and duration */
const char *recorder_name(const recorder *r);
uint32_t  recorder_pictures(const recorder *r);
#endif
