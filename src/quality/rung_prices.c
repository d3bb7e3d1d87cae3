/* SPDX-License-Identifier: MIT */
#include "quality/rung_prices.h"

#define PART(name) ((uint64_t)1 << TP_PART_##name)

/* Parts of the water's surface, by its pixels and rows. */
#define X(name) | PART(name)
#define SHADED ((0 TP_PIXEL_PARTS(X)) & ~PART(glass))

/* Parts that fast shading can draw for half the columns. */
#define TEXTURES (PART(layers) | PART(linear) | PART(distortion))
#define LIT      (TEXTURES | PART(plain) | PART(light) | PART(glint) | PART(reflection) \
                  | PART(mirrored_sky))

#define FAST_SHADING TP_KIND_SHADING, 1
#define BY_ROWS      TP_KIND_VISIBILITY, 1

const tp_rung_effect tp_rung_effects[TP_RUNG_KINDS] = {
    [TP_KIND_VISIBILITY]  = { 0, TP_SHARE_water, 0, 0 },    /* parts of its own */
    [TP_KIND_SHADING]     = { 0, TP_SHARE_water, 0, 0 },    /* factors of its own */
    [TP_KIND_RATE]        = { LIT, TP_SHARE_water, FAST_SHADING },
    [TP_KIND_sky]         = { PART(sky) | PART(sky_kind), TP_SHARE_sky, 0, 0 },
    [TP_KIND_haze]        = { PART(haze), TP_SHARE_all, 0, 0 },
    [TP_KIND_layers]      = { PART(linear), TP_SHARE_water, 0, 0 },
    [TP_KIND_distortion]  = { PART(distortion), TP_SHARE_water, FAST_SHADING },
    [TP_KIND_ripple]      = { PART(ripple), TP_SHARE_water, FAST_SHADING },
    [TP_KIND_light]       = { LIT, TP_SHARE_water, FAST_SHADING },
    [TP_KIND_foam]        = { PART(foam), TP_SHARE_water, 0, 0 },
    [TP_KIND_objects]     = { PART(objects), TP_SHARE_mirrored, 0, 0 },
    [TP_KIND_refraction]  = { 0, TP_SHARE_water, FAST_SHADING },     /* with fast shading */
    [TP_KIND_caustics]    = { PART(caustic_map), TP_SHARE_water, 0, 0 },
    [TP_KIND_solids]      = { PART(solids) | PART(mirror), TP_SHARE_solid, 0, 0 },
    [TP_KIND_mesh]        = { PART(faces) | PART(solids) | PART(mirror), TP_SHARE_solid,
                              0, 0 },
    [TP_KIND_triangles]   = { PART(visibility) | PART(level) | PART(cells) | PART(edges),
                              TP_SHARE_water, 0, 0 },
    [TP_KIND_lines]       = { SHADED, TP_SHARE_water, 0, 0 },
    [TP_KIND_rows]        = { PART(visibility) | PART(level) | PART(cells) | PART(edges),
                              TP_SHARE_water, BY_ROWS },
    [TP_KIND_waves]       = { PART(waves), TP_SHARE_water, 0, 0 },
    [TP_KIND_blending]    = { PART(store) | PART(exposure) | PART(plain) | PART(sky)
                              | PART(sky_kind), TP_SHARE_water, 0, 0 },
    [TP_KIND_geometry]    = { PART(waves), TP_SHARE_water, 0, 0 },
    [TP_KIND_normals]     = { PART(waves), TP_SHARE_water, 0, 0 },
    [TP_KIND_sine]        = { PART(waves), TP_SHARE_water, 0, 0 },
    [TP_KIND_spray]       = { PART(spray), TP_SHARE_all, 0, 0 },
    [TP_KIND_dispersion]  = { PART(dispersion), TP_SHARE_water, 0, 0 },
    [TP_KIND_exposure]    = { PART(exposure), TP_SHARE_all, 0, 0 },
    [TP_KIND_mirror_size] = { PART(mirror) | PART(faces), TP_SHARE_mirrored, 0, 0 },
    [TP_KIND_vertices]    = { PART(visibility) | PART(level), TP_SHARE_water, 0, 0 },
};                              /* and fewer cells, edges, vertices */

/* SEEN, PARTS(...): the factors of the parts; RUNGS(...): the prices of the rungs. */
#undef X
#define SEEN(...) __VA_ARGS__
#define PARTS(...)
#define RUNGS(...)
const uint16_t tp_seen_factors[TP_VISIBILITIES][TP_PARTS_SEEN] = {
#include "quality/rung_prices.inc"
};
#undef SEEN
#undef PARTS

#define SEEN(...)
#define PARTS(...) __VA_ARGS__
const uint16_t tp_part_factors[TP_SHADED_COUNT][TP_PART_COUNT] = {
#include "quality/rung_prices.inc"
};
#undef PARTS
#undef RUNGS

#define PARTS(...)
#define RUNGS(...) __VA_ARGS__
const tp_rung_price tp_rung_prices[TP_RUNG_KINDS][TP_KIND_RUNGS_MOST] = {
#include "quality/rung_prices.inc"
};
