/* SPDX-License-Identifier: MIT */
#include "bake_assets.h"
#include <inttypes.h>
#include <stdlib.h>
#include "app/files/log.h"
#include "features/water/water.h"
#include "frame/tools.h"
#include "quality/rung_sets.h"

/* -- pictures and grey maps ---------------------------------------------------------- */

const bake_member bake_members[] = {
    { "layer[0]", "layer0", offsetof(tp_assets, layer[0]) },
    { "layer[1]", "layer1", offsetof(tp_assets, layer[1]) },
    { "layer[2]", "layer2", offsetof(tp_assets, layer[2]) },
    { "distortion", "distortion", offsetof(tp_assets, distortion) },
    { "ripple", "ripple", offsetof(tp_assets, ripple) },
    { "foam", "foam", offsetof(tp_assets, foam) },
    { "baked_layer[0]", "baked_layer0", offsetof(tp_assets, baked_layer[0]) },
    { "baked_layer[1]", "baked_layer1", offsetof(tp_assets, baked_layer[1]) },
    { "baked_layer[2]", "baked_layer2", offsetof(tp_assets, baked_layer[2]) },
    { "baked_offset", "baked_offset", offsetof(tp_assets, baked_offset) },
    { "baked_slope", "baked_slope", offsetof(tp_assets, baked_slope) },
    { "sky[0]", "sky_east", offsetof(tp_assets, sky[0]) },
    { "sky[1]", "sky_west", offsetof(tp_assets, sky[1]) },
    { "sky[2]", "sky_up", offsetof(tp_assets, sky[2]) },
    { "sky[3]", "sky_down", offsetof(tp_assets, sky[3]) },
    { "sky[4]", "sky_south", offsetof(tp_assets, sky[4]) },
    { "sky[5]", "sky_north", offsetof(tp_assets, sky[5]) },
    { "tank_wall", "tank_wall", offsetof(tp_assets, tank_wall) },
    { "tank_floor", "tank_floor", offsetof(tp_assets, tank_floor) },
    { "floor_texture", "floor_texture", offsetof(tp_assets, floor_texture) },
};

const bake_member bake_greys[] = {
    { "floor", "floor", offsetof(tp_assets, floor) },
    { "pool_mask", "pool_mask", offsetof(tp_assets, pool_mask) },
    { "field_mask", "field_mask", offsetof(tp_assets, field_mask) },
};

_Static_assert(sizeof bake_members / sizeof *bake_members == BAKE_PICTURES
                   && sizeof bake_greys / sizeof *bake_greys == BAKE_GREYS,
               "the header has the number of members");

const tp_texture *bake_nth_texture(const tp_assets *names, int i)
{
    const void *at = (const char *)names + bake_members[i].offset;
    return *(const tp_texture *const *)at;
}

const tp_grey *bake_nth_grey(const tp_assets *names, int i)
{
    const void *at = (const char *)names + bake_greys[i].offset;
    return *(const tp_grey *const *)at;
}

static void add_picture(bake *b, const tp_texture *texture, const char *part, uint32_t i)
{
    if (!texture || bake_find(b, texture))
        return;
    bake_picture *p = &b->pictures[b->n_pictures++];
    p->texture = texture;
    snprintf(p->name, sizeof p->name, i == UINT32_MAX ? "%s" : "%s%" PRIu32,
             part, i);
}

int bake_list_pictures(bake *b, const tp_assets *names)
{
    const tp_mesh *boat = names->boat;
    const uint32_t materials = boat ? boat->n_materials : 0;
    b->pictures = calloc(BAKE_PICTURES + 2 * (size_t)materials, sizeof *b->pictures);
    if (!b->pictures)
        return log_fail_memory((BAKE_PICTURES + 2 * (size_t)materials) * sizeof *b->pictures);
    for (int i = 0; i < BAKE_PICTURES; i++)
        add_picture(b, bake_nth_texture(names, i), bake_members[i].part, UINT32_MAX);
    for (uint32_t i = 0; i < materials; i++) {
        add_picture(b, boat->materials[i].diffuse_map, "boat_diffuse", i);
        add_picture(b, boat->materials[i].normal_map, "boat_normal", i);
    }
    return EXIT_DONE;
}

/* -- baked layers of fast shading ---------------------------------------------------- */

/* True if nothing reads the layers after baking: all water is drawn by fast stages, and no
 * exposure meter reads the first layer.  The texture of ripples stays: the surface from
 * below needs the texture. */
static bool is_all_quick(const tp_scene *scene, const tp_assets *names, const options *o)
{
    uint32_t open;
    tp_view_costs view;
    const tp_rung_set set = tp_rung_set_named(scene, false, &open);

    return scene->hdr.exposure == TP_EXPOSURE_FIXED
           && tp_plan_view(&view, scene, names, o->width, o->height)
           && tp_set_is_fast(&view, &set);
}

static const tp_texture **baked_texture_slot(tp_assets *names, int i)
{
    return i < TP_LAYERS ? &names->baked_layer[i] : i == TP_LAYERS ? &names->baked_offset
                                                              : &names->baked_slope;
}

/* Drops the layers that only exact stages read, and only from above the water. */
static void drop_layers(tp_assets *names)
{
    for (int i = 0; i < TP_LAYERS; i++)
        names->layer[i] = NULL;
    names->distortion = NULL;
}

int bake_prepare(tp_assets *names, const tp_scene *scene, const options *o,
                 void *memory[TP_BAKED_LAYERS], tp_texture made[TP_BAKED_LAYERS])
{
    const tp_assets from = *names;

    if (scene->quality.shading != TP_SHADING_QUICK)
        return EXIT_DONE;
    for (int i = 0; i < TP_BAKED_LAYERS; i++) {
        const size_t bytes = tp_baked_layer_bytes(&from, i);
        if (bytes == 0)
            continue;
        memory[i] = malloc(bytes);
        if (!memory[i])
            return log_fail_memory(bytes);
        tp_bake_layer(&made[i], scene, &from, i, memory[i]);
        *baked_texture_slot(names, i) = &made[i];
    }
    if (is_all_quick(scene, &from, o))
        drop_layers(names);
    return EXIT_DONE;
}
