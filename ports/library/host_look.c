/* SPDX-License-Identifier: MIT */
/* Camera modes: the modes of ports/live, and the camera.follow each mode needs. */
#include <string.h>
#include "../host/say.h"
#include "host.h"
#include "scene/value.h"
#include "scene/world.h"

_Static_assert((int)TP_HOST_FREE == LOOK_FREE && (int)TP_HOST_ORBIT == LOOK_ORBIT
                   && (int)TP_HOST_TOP == LOOK_TOP && (int)TP_HOST_BOAT == LOOK_BOAT
                   && (int)TP_HOST_WAYS == LOOK_MODES,
               "one order");

/* Sets camera.follow for the mode. stage_put keeps set_at: the change was not made by
 * the caller. */
int host_follow(tp_host *h)
{
    static const char *const words[] = { "none", "boat" };
    const tp_camera_follow wanted = look_follow(&h->look, &h->filed);
    const tp_param *row = tp_param_find("camera.follow", strlen("camera.follow"));
    stage_value value = stage_get(&h->stage, row);
    bool opened = false;
    if ((int32_t)wanted == h->stage.file.scene.camera.follow)
        return EXIT_DONE;
    strcpy(value.text, words[wanted]);
    return stage_put(&h->stage, &h->options, "tp_host_look", row, &value, &opened);
}

static bool begin(tp_host *h, tp_host_way way)
{
    const look before = h->look;
    if (!look_begin(&h->look, (look_mode)way, h->stage.world, &h->stage.file.scene)) {
        say("tp_host_look: %s",
            way == TP_HOST_BOAT ? "the scene has no boat" : "no such camera mode");
        return false;
    }
    if (host_follow(h)) {
        h->look = before;
        return false;
    }
    if (h->look.jump)
        tp_host_turn(h, NULL);
    return true;
}

bool tp_host_look(tp_host *host, tp_host_way way, tp_host_error *err)
{
    host_call call;
    host_call_begin(&call, err);
    const bool done = begin(host, way);
    host_call_end();
    return done;
}

tp_host_way tp_host_get_way(const tp_host *host)
{
    return (tp_host_way)host->look.mode;
}

bool tp_host_pick(const tp_host *host, int32_t x, int32_t y, tp_vec3 *at)
{
    return tp_world_pick(&tp_program_all, host->stage.world, &host->stage.file.scene,
                         host->options.width, host->options.height, tp_pixel_middle(x),
                         tp_pixel_middle(y), at);
}
