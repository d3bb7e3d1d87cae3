/* SPDX-License-Identifier: MIT */
/* Rays of sight in the water: where they begin, and what they meet (see inside.h). */
#ifndef TP_SHADE_BEAM_H
#define TP_SHADE_BEAM_H
#include "fx/fx.h"
#include "shade/shade.h"

#define TP_INSIDE_FAR (16000 * TP_FX_ONE)

/* -- places and ways ------------------------------------------------------------------ */

/* The numbers of the view that `shade` has now. */
void tp_inside_view(tp_inside *in, const tp_shade *shade, tp_fx zi_near);

/* A place that is seen, and a way from there, a unit vector in Q1.14. */
#define TP_INSIDE_ROW 16        /* as many as are worked out together */

typedef struct {
    tp_vec3 at;
    tp_ray  way;
    tp_fx   far;                /* m from the eye, roughly */
} tp_beam;

/* sqrt(1 - i / 64), Q1.14. */
extern const uint16_t tp_inside_root[65];

/* sqrt(1 - x) of x in Q28, 0..1; within 2 units of Q1.14 up to 0.8. */
TP_ALWAYS_INLINE int32_t tp_inside_rest(uint32_t x)
{
    const uint16_t *at = tp_inside_root + (x >> 22 & 63);
    return at[0] - ((at[0] - at[1]) * (int32_t)(x >> 8 & 0x3fff) >> 14);
}

/* -in . n, held within 1. */
TP_ALWAYS_INLINE int32_t tp_inside_cosine(tp_ray in, tp_ray n)
{
    return tp_clamp(-((in.x * n.x + in.y * n.y + in.z * n.z) >> 14), -16384, 16384);
}

/* [F4] into the water: `in` goes towards the surface, `n` is its normal out of the water,
 * `ci` the cosine between them, all Q1.14. */
TP_ALWAYS_INLINE tp_ray tp_inside_bent_at(const tp_inside *inside, int channel, tp_ray in,
                                          tp_ray n, int32_t ci)
{
    int32_t  eta = inside->eta[channel];
    uint32_t s2 = (1u << 28) - (uint32_t)(ci * ci);
    int32_t ct = tp_inside_rest((uint32_t)((uint64_t)s2 * (uint32_t)inside->eta2[channel]
                                           >> 14));
    int32_t lean = (eta * ci >> 14) - ct;
    return (tp_ray){ (eta * in.x + lean * n.x) >> 14, (eta * in.y + lean * n.y) >> 14,
                     (eta * in.z + lean * n.z) >> 14, 0 };
}

TP_ALWAYS_INLINE tp_ray tp_inside_bent(const tp_inside *inside, int channel, tp_ray in,
                                       tp_ray n)
{
    return tp_inside_bent_at(inside, channel, in, n, tp_inside_cosine(in, n));
}

/* Fills `beam` with where samples [i, stop) of a run lie; their ways are left alone. */
void tp_inside_places(const tp_shade *shade, const tp_run *run, int32_t i, int32_t stop,
                      tp_beam *beam);

/* -- light ---------------------------------------------------------------------------- */

/* The floor around what a beam would meet. */
tp_bed tp_inside_bed(const tp_shade *shade, const tp_beam *beam);

/* The colour that comes along a beam; `body` is the colour of the water itself. */
uint32_t tp_inside_at(const tp_shade *shade, const tp_bed *bed, const tp_beam *beam,
                      uint32_t body);

/* The floor as it lies under a place: its depth there. */
typedef struct {
    tp_fx   depth, rise_x, rise_z;
    int32_t nl;
} tp_ground;

/* For up to 16 neighbours, between the beds of the first and the last. */
void tp_inside_ground(const tp_shade *shade, const tp_bed ends[2], const tp_beam *beam,
                      int32_t count, tp_ground *under);

/* The colours that come along beams that go down; or their channel at bit `shift` alone,
 * which is added to the other channels in `seen`. */
void tp_inside_row(const tp_shade *shade, const tp_bed ends[2], const tp_beam *beam,
                   int32_t count, const uint32_t *body, uint32_t *seen);
void tp_inside_row_channel(const tp_shade *shade, const tp_ground *under,
                           const tp_beam *beam, int32_t count, const uint32_t *body,
                           int shift, uint32_t *seen);

/* The same where a beam that goes up has reached the surface, whose normal is n: the sky
 * through Snell's window, and the water mirrored by Fresnel's share, all of it beyond
 * 48.6 degrees [F1]. */
uint32_t tp_inside_up(const tp_shade *shade, const tp_bed *bed, const tp_beam *beam,
                      tp_ray n, uint32_t body);

/* The factor of the light on a floor or a wall at a place, 256 is 1. */
int32_t tp_caustic_at(const tp_caustic *caustic, tp_vec3 at);
#endif
