/* SPDX-License-Identifier: MIT */
/* Which rungs a scene is drawn by: those that it names, else the exact ones. */
#include "tidepool/plan.h"

tp_rungs tp_rungs_of(const tp_scene *scene, const tp_assets *assets, uint32_t width,
                     uint32_t height)
{
    tp_rungs rungs = {
        (tp_visibility)scene->quality.visibility, (tp_shading)scene->quality.shading,
        (tp_rate)scene->quality.rate, (tp_lod)scene->quality.lod,
    };

    (void)assets, (void)width, (void)height;
    if (rungs.visibility == TP_VISIBILITY_AUTO)
        rungs.visibility = TP_VISIBILITY_TRIANGLES;
    if (rungs.shading == TP_SHADING_AUTO)
        rungs.shading = TP_SHADING_EXACT;
    if (rungs.rate == TP_RATE_AUTO)
        rungs.rate = TP_RATE_FULL;
    if (rungs.lod == TP_LOD_AUTO)
        rungs.lod = TP_LOD_OFF;
    return rungs;
}
