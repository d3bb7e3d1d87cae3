/* SPDX-License-Identifier: MIT */
/* Prints the parts missing in a baked program, for its scene now and for allowed
 * changes, a line each. */
#include <stdio.h>
#include <string.h>
#include "world/module.h"

extern const tp_scene baked_scene;
extern const tp_assets baked_assets;
extern const tp_program baked_program;
extern const tp_config baked_config;

static void tell(const char *change, const tp_scene *scene, const tp_assets *assets)
{
    static uint64_t block[32768];
    tp_config config = baked_config;
    tp_frame *frame;
    tp_error err = { 0 };
    char text[128] = "ok";

    config.assets = assets;
    if (tp_program_check_all(&baked_program, scene, assets, &err) != TP_OK)
        tp_error_text(&err, text, sizeof text);
    printf("%s: %s\n", change, text);
    if (err.code
        && (tp_frame_bytes(&config, scene) != 0
            || tp_world_bytes(&baked_program, scene, assets) != 0
            || tp_frame_init(&frame, &config, scene, block, sizeof block, NULL) != err.code
            || tp_world_init(&baked_program, (tp_world *)(void *)block, sizeof block,
                             scene, assets, NULL)
                   != err.code))
        printf("%s: and taken by an init\n", change);
}

int main(void)
{
    static const tp_mesh boat = { 0 };
    tp_scene scene = baked_scene;
    tp_assets assets = baked_assets;

    tell("as it is", &scene, &assets);
    scene.foam.cells = 32;
    tell("foam", &scene, &assets);
    assets.boat = &boat;
    tell("boat", &scene, &assets);
    assets.boat = NULL;
    strcpy(scene.boat.mesh, "boat.obj");
    tell("boat without its mesh", &scene, &assets);
    scene = baked_scene;
    scene.sky.kind = TP_SKY_NIGHT;
    tell("night", &scene, &assets);
    scene = baked_scene;
    scene.water.clarity = TP_FX_ONE;
    tell("clear water", &scene, &assets);
    return 0;
}
