/* SPDX-License-Identifier: MIT */
/* The plain sky, which other skies' modules replace, and the numbers of what water makes
 * of it: Fresnel's share and glitter. */
#include "frame/frame.h"

static void plan_fresnel(tp_frame *frame)
{
    const bool shortcut = frame->scene->water.fresnel == TP_FRESNEL_SCHLICK;
    frame->shade.fresnel = shortcut ? tp_schlick_table : tp_fresnel_table;
}

/* Glitter of the water, by the light's model. */
static void plan_glint(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;

    if (scene->light.model == TP_LIGHT_BLINN)
        tp_shade_shine_blinn(&frame->shade, scene->water.shininess,
                             scene->water.specular);
    else
        tp_shade_shine(&frame->shade, scene->water.shininess, scene->water.specular);
}

const struct tp_draw_fresnel tp_draw_fresnel = { plan_fresnel };
const struct tp_draw_glint tp_draw_glint = { plan_glint };

void tp_frame_plan_sky(tp_frame *frame)
{
    const tp_scene *scene = frame->scene;
    static const tp_entry8 none[257] = { 0 };
    tp_shade *shade = &frame->shade;

    shade->fresnel = none;
    if (frame->kit->draw.fresnel)
        frame->kit->draw.fresnel->plan(frame);
    tp_shade_sky(shade, (uint32_t)scene->sky.horizon, (uint32_t)scene->sky.zenith);
    shade->env = (tp_env){ .beyond = (uint32_t)scene->hdr.share * TP_WHITES >> 8 };
}

/* The plain gradient has no light beyond white; only objects in the mirror ask for more
 * than the fused stage. */
bool tp_frame_mirrors_apart(const tp_frame *frame)
{
    return frame->shade.env.kind != TP_ENV_GRADIENT
        || frame->scene->mirror.objects != TP_MIRROR_NONE;
}
