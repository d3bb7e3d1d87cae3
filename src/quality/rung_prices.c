/* SPDX-License-Identifier: MIT */
#include "quality/rung_prices.h"

#define PART(name) (1u << TP_PART_##name)

/* Parts of a pixel of water. */
#define SHADED (PART(plain) | PART(layers) | PART(distortion) | PART(ripple) | PART(light) \
                | PART(glint) | PART(reflection) | PART(haze) | PART(foam) | PART(objects) \
                | PART(refraction) | PART(dispersion) | PART(caustics) | PART(exposure))

#define FAST_SHADING TP_KIND_SHADING, 1
#define BY_ROWS      TP_KIND_VISIBILITY, 1

const tp_rung_effect tp_rung_effects[TP_RUNG_KINDS] = {
    [TP_KIND_VISIBILITY]  = { PART(visibility) | PART(vertices), TP_SHARE_water, 0, 0 },
    [TP_KIND_SHADING]     = { 0, TP_SHARE_water, 0, 0 },
    [TP_KIND_RATE]        = { SHADED, TP_SHARE_water, FAST_SHADING },
    [TP_KIND_sky]         = { PART(sky), TP_SHARE_sky, 0, 0 },
    [TP_KIND_haze]        = { PART(haze), TP_SHARE_all, 0, 0 },
    [TP_KIND_layers]      = { PART(layers) | PART(distortion), TP_SHARE_water, 0, 0 },
    [TP_KIND_distortion]  = { SHADED, TP_SHARE_water, FAST_SHADING },
    [TP_KIND_ripple]      = { SHADED, TP_SHARE_water, FAST_SHADING },
    [TP_KIND_light]       = { SHADED, TP_SHARE_water, FAST_SHADING },
    [TP_KIND_foam]        = { PART(foam), TP_SHARE_water, 0, 0 },
    [TP_KIND_objects]     = { PART(objects), TP_SHARE_mirrored, 0, 0 },
    [TP_KIND_refraction]  = { 0, TP_SHARE_water, FAST_SHADING },     /* with fast shading */
    [TP_KIND_caustics]    = { PART(caustics), TP_SHARE_water, 0, 0 },
    [TP_KIND_solids]      = { PART(solids) | PART(mirror), TP_SHARE_solid, 0, 0 },
    [TP_KIND_mesh]        = { PART(faces) | PART(solids) | PART(mirror), TP_SHARE_solid,
                              0, 0 },
    [TP_KIND_triangles]   = { PART(visibility) | PART(vertices), TP_SHARE_water, 0, 0 },
    [TP_KIND_lines]       = { SHADED, TP_SHARE_water, 0, 0 },
    [TP_KIND_rows]        = { PART(visibility), TP_SHARE_water, BY_ROWS },
    [TP_KIND_waves]       = { PART(vertices), TP_SHARE_water, 0, 0 },
    [TP_KIND_blending]    = { PART(plain), TP_SHARE_water, 0, 0 },
    [TP_KIND_geometry]    = { PART(vertices), TP_SHARE_water, 0, 0 },
    [TP_KIND_normals]     = { PART(vertices), TP_SHARE_water, 0, 0 },
    [TP_KIND_sine]        = { PART(vertices), TP_SHARE_water, 0, 0 },
    [TP_KIND_spray]       = { PART(spray), TP_SHARE_all, 0, 0 },
    [TP_KIND_dispersion]  = { PART(dispersion) | PART(refraction), TP_SHARE_water, 0, 0 },
    [TP_KIND_exposure]    = { PART(exposure), TP_SHARE_all, 0, 0 },
    [TP_KIND_mirror_size] = { PART(mirror) | PART(faces), TP_SHARE_mirrored, 0, 0 },
    [TP_KIND_vertices]    = { PART(visibility), TP_SHARE_water, 0, 0 },  /* and vertices */
};

/* PARTS(...): the factors of the parts; RUNGS(...): the prices of the rungs. */
#define RUNGS(...)
#define PARTS(...) __VA_ARGS__
const uint16_t tp_part_factors[TP_SHADINGS][TP_PART_COUNT] = {
#include "quality/rung_prices.inc"
};
#undef RUNGS
#undef PARTS

#define RUNGS(...) __VA_ARGS__
#define PARTS(...)
const tp_rung_price tp_rung_prices[TP_RUNG_KINDS][TP_KIND_RUNGS_MOST] = {
#include "quality/rung_prices.inc"
};
