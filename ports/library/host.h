/* SPDX-License-Identifier: MIT */
/* What a tp_host is made of; tidepool/host.h is what callers see. */
#ifndef LIBRARY_HOST_H
#define LIBRARY_HOST_H
#include "../host/stage.h"
#include "../live/look.h"
#include "../live/poke.h"
#include "tidepool/host.h"

struct tp_host {
    stage stage;
    options options; /* as the program's command line would have them */
    tp_scene filed;  /* of which look_follow wants camera.follow */
    look look;
    poke_queue pokes;
    tp_host_picture picture;
};

/* From here to `after` what this thread says goes to *err, or nowhere. */
typedef struct {
    tp_host_error *err, own;
} host_call;

/* Gives camera.follow what the way to look wants; an exit code, and has said why. */
int host_follow(tp_host *host);

void host_before(host_call *call, tp_host_error *err);
void host_after(void);
#endif
