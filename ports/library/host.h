/* SPDX-License-Identifier: MIT */
/* The inside of a tp_host; tidepool/host.h is the public header. */
#ifndef TP_LIBRARY_HOST_H
#define TP_LIBRARY_HOST_H
#include "app/scene/loaded_scene.h"
#include "interact/camera_mode.h"
#include "interact/poke.h"
#include "tidepool/host.h"

struct tp_host {
    loaded_scene loaded;
    options options; /* as from the program's command line */
    tp_scene filed;  /* has the free camera's camera.follow */
    camera_mode camera_mode;
    poke_queue pokes;
    tp_host_picture picture;
};

/* Between host_call_begin and host_call_end this thread's messages go to *err, or
 * nowhere. */
typedef struct {
    tp_host_error *err, own;
} host_call;

/* Sets camera.follow for the camera mode.  Returns an exit code; the reason has been
 * said. */
int host_follow(tp_host *host);

void host_call_begin(host_call *call, tp_host_error *err);
void host_call_end(void);
#endif
