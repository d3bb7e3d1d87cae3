/* SPDX-License-Identifier: MIT */
/* The table of old names of rows.
 *
 * The table is here, not in the core: tp_scene_set serves programs, whose names are
 * corrected once, in their source; ports read the texts of users.  Only a port that
 * asks for old names links this file: a board with little memory refuses them and pays
 * nothing. */
#include "old_names.h"
#include "tidepool/tidepool.h"
#include "world/text.h"

_Static_assert(TP_VERSION < 3000, "0.3 reads no old name: remove these or move the end");

#define POOL(part) \
    { part ".feed_low", part ".drive_min" }, \
    { part ".feed_high", part ".drive_max" }, \
    { part ".feed", part ".drive_amplitude" }, \
    { part ".poke", part ".splash_height" }, \
    { part ".poke_size", part ".splash_width" }, \
    { part ".poke_every", part ".splash_interval" }, \
    { part ".edges", part ".boundary" }, \
    { part ".range", part ".max_height" }, \
    { part ".cells", part ".cell_bits" }

#define WAVE(n) { "wave" #n ".power", "wave" #n ".exponent" }

static const old_name names[] = {
    { "scene.shows", "scene.description" },
    { "hdr.value", "hdr.exposure_factor" },
    { "water.clear", "water.clarity" },
    { "water.deep", "water.deep_colour" },
    { "water.pool_bump", "water.pool_normal_strength" },
    { "mirror.objects", "mirror.method" },
    { "mirror.bend", "mirror.distortion" },
    WAVE(0), WAVE(1), WAVE(2), WAVE(3), WAVE(4), WAVE(5), WAVE(6), WAVE(7),
    WAVE(8), WAVE(9), WAVE(10), WAVE(11), WAVE(12), WAVE(13), WAVE(14), WAVE(15),
    { "surf.k0", "surf.tilt_decay" },
    { "surf.kx", "surf.widening_decay" },
    { "surf.ky", "surf.flattening_decay" },
    POOL("pool"),
    POOL("field"),
    { "drops.into", "drops.target" },
    { "drops.every", "drops.interval" },
    { "drops.scatter", "drops.scatter_radius" },
    { "drops.speed", "drops.ring_speed" },
    { "drops.decay", "drops.ring_decay" },
    { "drops.spread", "drops.ring_spread" },
    { "drops.attack", "drops.ring_rise_time" },
};

enum { NAMES = sizeof names / sizeof names[0] };

const old_name *old_names(uint32_t *count)
{
    *count = NAMES;
    return names;
}

const old_name *old_name_find(const char *name, size_t bytes)
{
    for (uint32_t i = 0; i < NAMES; i++)
        if (tp_string_view_equals((tp_string_view){ name, bytes }, names[i].old))
            return &names[i];
    return NULL;
}

const char *old_name_why_gone(const char *name, size_t bytes)
{
    static const char *const gone[] = { "quality.lod", "grid.cols", "grid.rows", "grid.cell",
                                        "grid.reach", "grid.follow" };

    for (size_t i = 0; i < sizeof gone / sizeof *gone; i++)
        if (tp_string_view_equals((tp_string_view){ name, bytes }, gone[i]))
            return "grid.vertices sets the detail of the grid at every distance";
    return NULL;
}

static size_t length(const char *text)
{
    size_t n = 0;
    while (text[n])
        n++;
    return n;
}

const tp_param *old_name_param(const char *name, size_t bytes)
{
    const tp_param *param = tp_param_find(name, bytes);
    const old_name *old = param ? NULL : old_name_find(name, bytes);
    return old ? tp_param_find(old->now, length(old->now)) : param;
}
