/* SPDX-License-Identifier: MIT */
/* Loads scenes for the reference. */
#include "shipped_scene.h"
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "tidepool/modules.h"
#include "world/world.h"

static int make_world(ref_stand *stand, uint32_t ticks)
{
    const tp_scene *scene = &stand->file.scene;
    const size_t bytes = tp_world_bytes(&tp_program_all, scene, &stand->assets.names);
    tp_error err = { 0 };

    stand->world = malloc(bytes + sizeof *stand->world);
    if (!stand->world)
        return log_fail_memory(bytes);
    if (tp_world_init(&tp_program_all, stand->world, bytes, scene, &stand->assets.names,
                      &err))
        return scene_file_refuse(&stand->file, &err);
    while (stand->world->tick < ticks)
        tp_world_step(&tp_program_all, stand->world, scene, NULL);
    return EXIT_DONE;
}

/* The reference always draws the mesh that the scene names. */
static int open_assets(ref_stand *stand)
{
    stand->file.scene.quality.mesh = TP_MESH_FULL;
    return assets_open(&stand->assets, &stand->file);
}

int ref_stand_open(ref_stand *stand, const char *name, const char *const *settings,
                   uint32_t count, uint32_t ticks)
{
    memset(stand, 0, sizeof *stand);
    int code = scene_file_open(&stand->file, name);
    for (uint32_t i = 0; i < count && !code; i++)
        code = scene_file_set(&stand->file, settings[i]);
    if (!code)
        code = open_assets(stand);
    return code ? code : make_world(stand, ticks);
}

void ref_stand_close(ref_stand *stand)
{
    free(stand->world);
    assets_close(&stand->assets);
    scene_file_close(&stand->file);
}
