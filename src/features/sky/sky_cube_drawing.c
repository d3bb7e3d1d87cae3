/* SPDX-License-Identifier: MIT */
/* Draws a sky from a cube map of six textures. */
#include "features/sky/sky.h"
#include "frame/frame.h"

/* Indices in the program's table of stages. */
enum { EMPTY, EMPTY_HDR, REFLECT };

typedef struct {
    tp_cube  cube;
    uint32_t recip[TP_RECIP + 2];
} sky_cube;

static void init(tp_frame *frame, void *mine)
{
    sky_cube *sky = mine;

    tp_cube_init(&sky->cube, frame->assets.sky);
    tp_recip_init(sky->recip);
}

/* Sets the environment.  A face spans 90 degrees, so half of its texels span a tangent of
 * 1; the mipmap level follows from the projection's focal length. */
static void begin(tp_frame *frame, void *mine)
{
    sky_cube *sky = mine;
    tp_env   *env = &frame->shade.env;
    int32_t   focal = tp_log2_q8((uint32_t)frame->projection.focal) - 16 * 256;

    sky->cube.lod = (sky->cube.face[0]->log2_w - 1) * 256 - focal;
    env->kind = TP_ENV_CUBE;
    env->cube = &sky->cube;
    env->recip = sky->recip;
}

static void add_stages(const tp_frame *frame, const void *mine, const tp_stage *stage,
                       tp_shaders *list)
{
    if (list->kind == TP_LIST_SKY && !frame->under)
        tp_shaders_add(list, TP_AT_COLOUR,
                       stage[frame->shade.env.beyond ? EMPTY_HDR : EMPTY], mine);
    if (tp_frame_reflects_sky(frame, list))
        tp_shaders_add(list, TP_AT_REFLECT, stage[REFLECT], mine);
}

/* -- the module ---------------------------------------------------------------------- */

bool tp_sky_cube_enabled(const tp_want *want)
{
    return tp_has_cube(want->scene, want->assets);
}

static void *layout(tp_arena *arena, const tp_want *want)
{
    (void)want;
    return tp_arena_alloc(arena, 1, sizeof(sky_cube));
}

const tp_module tp_sky_cube_module = {
    .name = "sky_cube", .id = TP_SKY_CUBE_ID, .is = TP_MODULE_CUBE,
    .trait = TP_TRAIT_cube, .enabled = tp_sky_cube_enabled,
};

const tp_drawing tp_sky_cube_drawing = {
    .layout = layout, .init = init, .begin = begin, .stages = add_stages,
};
