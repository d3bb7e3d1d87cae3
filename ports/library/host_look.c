/* SPDX-License-Identifier: MIT */
/* Camera modes: the modes of ports/interact, and the camera.follow each mode needs. */
#include <string.h>
#include "app/files/log.h"
#include "host.h"
#include "world/text.h"
#include "world/world.h"

_Static_assert((int)TP_HOST_FREE == CAMERA_FREE && (int)TP_HOST_ORBIT == CAMERA_ORBIT
                   && (int)TP_HOST_TOP == CAMERA_TOP && (int)TP_HOST_BOAT == CAMERA_BOAT
                   && (int)TP_HOST_WAYS == CAMERA_MODES,
               "one order");

/* Sets camera.follow for the mode. loaded_scene_put keeps set_at: the change was not
 * made by the caller. */
int host_follow(tp_host *h)
{
    static const char *const words[] = { "none", "boat" };
    const tp_camera_follow wanted = camera_mode_follow(&h->camera_mode, &h->filed);
    const tp_param *row = tp_param_find("camera.follow", strlen("camera.follow"));
    loaded_scene_value value = loaded_scene_get(&h->loaded, row);
    bool opened = false;
    if ((int32_t)wanted == h->loaded.file.scene.camera.follow)
        return EXIT_DONE;
    strcpy(value.text, words[wanted]);
    return loaded_scene_put(&h->loaded, &h->options, "tp_host_look", row, &value, &opened);
}

static bool begin(tp_host *h, tp_host_way way)
{
    const camera_mode before = h->camera_mode;
    if (!camera_mode_begin(&h->camera_mode, (camera_mode_kind)way, h->loaded.world,
                           &h->loaded.file.scene)) {
        log_line("tp_host_look: %s",
                 way == TP_HOST_BOAT ? "the scene has no boat" : "no such camera mode");
        return false;
    }
    if (host_follow(h)) {
        h->camera_mode = before;
        return false;
    }
    if (h->camera_mode.jump)
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
    return (tp_host_way)host->camera_mode.mode;
}

bool tp_host_pick(const tp_host *host, int32_t x, int32_t y, tp_vec3 *at)
{
    return tp_world_pick(&tp_program_all, host->loaded.world, &host->loaded.file.scene,
                         host->options.width, host->options.height, tp_pixel_middle(x),
                         tp_pixel_middle(y), at);
}
