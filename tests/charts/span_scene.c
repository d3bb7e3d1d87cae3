/* SPDX-License-Identifier: MIT */
/* Scenes of span.h: shipped scenes without boats and foam, and settings. */
#include "cortex-m/baked.h"
#include "world/text.h"
#include "tests/charts/span.h"

#define WATER "boat.mesh= mirror.method=none foam.cells=0 "

/* Settings of the steps: triangles and exact stages. `plane` is the first texture on level
 * water of the fewest vertices, the largest triangles. */
#define MESH  WATER "quality.visibility=triangles quality.shading=exact quality.rate=full "
#define PLANE MESH "wave0.amplitude=0 wave1.amplitude=0 wave2.amplitude=0 " \
    "grid.vertices=64 camera.pitch=-20 water.filter=linear water.specular=0 " \
    "water.reflection=0 ripple.bump=0 distortion.strength=0 sky.kind=gradient " \
    "hdr.share=0 "

/* Settings of the filters and of the shading rates, which only the fast stages have: no
 * glints and no mirrors, which would hide the differences. */
#define LAYERS WATER "quality.visibility=rows water.specular=0 water.reflection=0 " \
    "ripple.bump=0 sky.kind=gradient sky.haze=0 hdr.share=0 "
#define NEAREST LAYERS "quality.shading=exact water.filter=nearest "
#define LINEAR  LAYERS "quality.shading=exact water.filter=linear "
#define QUICK   LAYERS "quality.shading=quick water.filter=nearest "

#define STEPS(from, name, set) \
    { "span", from, name "1", set, 1, false }, { "span", from, name "8", set, 8, false }, \
    { "span", from, name "16", set, 16, false }, \
    { "span", from, name "32", set, 32, false }, \
    { "span", from, name "affine", set, 0, false }

const span_row span_rows[] = {
    STEPS(NULL, "", MESH),
    STEPS("three-swells", "plane;", PLANE),
    { "filter", NULL, "nearest;full", NEAREST "quality.rate=full", 16, false },
    { "filter", NULL, "linear;full", LINEAR "quality.rate=full", 16, false },
    { "filter", NULL, "quick;full", QUICK "quality.rate=full", 16, false },
    { "filter", NULL, "quick;layers", QUICK "quality.rate=layers", 16, false },
    { "filter", NULL, "quick;colour", QUICK "quality.rate=colour", 16, false },
    { "filter", NULL, "nearest-1;full", NEAREST "quality.rate=full", 16, true },
    { "filter", NULL, "linear-1;full", LINEAR "quality.rate=full", 16, true },
    { NULL, NULL, NULL, NULL, 0, false },
};

static size_t until(const char *text, char a, char b)
{
    size_t n = 0;

    while (text[n] && text[n] != a && text[n] != b)
        n++;
    return n;
}

static bool set(tp_scene *scene, const char *text)
{
    while (*text) {
        const size_t bytes = until(text, ' ', ' '), name = until(text, ' ', '=');
        if (name == bytes || tp_param_set(scene, tp_param_find(text, name),
                                          text + name + 1, bytes - name - 1, NULL))
            return false;
        text += bytes + (text[bytes] == ' ');
    }
    return true;
}

static const tp_texture *first_level(tp_texture *to, const tp_texture *from)
{
    if (!from)
        return NULL;
    *to = *from;
    to->levels = 1;
    return to;
}

bool span_begin(span_scene *s, const span_row *row)
{
    s->scene = baked_scene;
    s->assets = baked_assets;
    s->assets.boat = NULL;
    if (row->from)
        for (int i = 1; i < TP_LAYERS; i++)
            s->assets.layer[i] = NULL;
    for (int i = 0; i < TP_LAYERS && row->one_level; i++)
        s->assets.layer[i] = first_level(&s->picture[i], s->assets.layer[i]);
    span_step = row->step;
    return set(&s->scene, row->set);
}
