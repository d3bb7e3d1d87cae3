/* SPDX-License-Identifier: MIT */
/*
 * Light of rough water: the slope variance of what a sample does not show widens the lobe
 * [V1] and bends N.V for Fresnel's share and the mirrored height (tp_rough_view).
 *
 * A lobe of exponent n is close to exp(-n d), d = 1 - R.V.  Slopes of variance s2 spread
 * the mirrored ray by 4 s2 in the plane of view, and across the plane by 4 s2 (V.H)^2, H
 * half way to the light: facets that glint have H as their normal.
 * The wider lobe is exp(-n d / k), k = 1 + 4 n s2:
 * the same table at d / k, times a peak that keeps the light's sum.  One table serves all
 * levels, and both axes: d is half the squared distance of the mirrored ray from the
 * light, and its part in the plane of view is that of their heights.
 */
#ifndef TP_SHADE_ROUGH_LOBE_H
#define TP_SHADE_ROUGH_LOBE_H
#include "shade/shade.h"

/* Entry i is sqrt(i / 256), Q1.14. */
extern const tp_entry16 tp_sqrt_table[258];

/* Returns the root of a Q28 number, up to 1, Q14.  The error is below 0.6 % from 2^-13, and
 * below 1/512 at less. */
TP_ALWAYS_INLINE int32_t tp_sqrt_nearest(uint32_t q28)
{
    const int up = q28 < 1u << 22 ? 3 : 0;
    const uint32_t q = q28 << 2 * up, i = q >> 20 < 256 ? q >> 20 : 256;
    int32_t  a = (int32_t)tp_sqrt_table[i], b = (int32_t)tp_sqrt_table[i + 1];

    return (a + ((b - a) * (int32_t)(q >> 12 & 255) >> 8)) >> up;
}

/* N.V whose share of reflected light is the mean share of slopes of a variance: a smooth
 * bend from a floor to N.V, lift + h + sqrt(h^2 + square), h = (N.V - bend) / 2.  height:
 * factor of the mirrored height at that N.V, where a gradient has its mean over the
 * mirrored rays [V3].  Q14; square: Q28. */
typedef struct {
    int32_t  bend, lift;
    uint32_t square;
    int32_t  height;
} tp_rough_view;

/* Returns the form at slope variances along the view, Q24: of ripples and of waves. */
tp_rough_view tp_rough_view_make(uint32_t ripples, uint32_t waves);

/* Returns N.V as rough water shows it; nv and the result are Q14, the result is 0..1. */
TP_ALWAYS_INLINE int32_t tp_rough_view_cosine(int32_t nv, const tp_rough_view *view)
{
    const int32_t h = ((nv > -4096 ? nv : -4096) - view->bend) >> 1;
    const int32_t size = h < 0 ? -h : h;
    const int32_t root = tp_sqrt_nearest((uint32_t)(h * h) + view->square);

    return tp_clamp(view->lift + h + (root > size ? root : size), 0, 16384);
}

/* The lobe at one variance.  across, along: factors of the two parts of d, Q14.  slant: of
 * the squared difference of the heights, Q14.  peak: factor of the table, Q14.  seen: added
 * to N.L of diffuse light, Q14. */
typedef struct {
    tp_rough_view view;
    int32_t across, along, slant, peak, seen;
} tp_rough_lobe;

/* Returns the lobe of a sample by its key, the height vy of the vector V to its eye, and
 * L.V; Q14. */
tp_rough_lobe tp_rough_lobe_make(const tp_shade *shade, uint32_t key, int32_t vy,
                                 int32_t lv, bool blinn);

/* Returns the largest R.V at which the lobe is dark, Q14; below -16384: nowhere.  The lobe's
 * cosine is at most that of the narrower of both factors. */
TP_ALWAYS_INLINE int32_t tp_rough_lobe_dark_cosine(const tp_shade *shade,
                                                   const tp_rough_lobe *lobe)
{
    const int32_t least = lobe->across < lobe->along ? lobe->across : lobe->along;
    const int32_t end = (16384 - shade->dark * (16384 / TP_SHINE) + 1) * 16384;

    return least > 0 ? 16384 - (end + least - 1) / least : INT32_MIN;
}

/* Returns the cosine to look the lobe up by.  rv: that of a smooth lobe; rise: height of
 * the mirrored view minus the light's; all Q14. */
TP_ALWAYS_INLINE int32_t tp_rough_lobe_cosine(const tp_rough_lobe *lobe, int32_t rv,
                                              int32_t rise)
{
    int32_t d = 16384 - rv, tall = (rise * rise >> 14) * lobe->slant >> 14;

    tall = tall < d ? tall : d;
    return 16384 - (((d - tall) * lobe->across + tall * lobe->along) >> 14);
}

/* Returns the slope variance that a sample at log2 of a depth, Q8, does not show. */
tp_slope_variance tp_rough_variance(const tp_shade *shade, int32_t log_depth);

/* Returns the part of it lost by the ripples' mipmap level, an axis. */
uint32_t tp_rough_ripple_variance(const tp_ripple_variance *ripple, int32_t log_depth);

/* Returns what slopes of waves that are seen add to N.V in the mean, since they count by
 * their N.V.  nv: 0..1, and the result, Q14; variance: of N.V, Q24. */
int32_t tp_rough_seen_rise(int32_t nv, uint32_t variance);

/* Returns the factor 1 / (1 + 4 n s2), Q14; n up to 1000, s2 up to 1, Q24. */
int32_t tp_rough_narrowing(uint32_t exponent, uint32_t variance);

/* Returns the peak of a lobe, Q14, for the factor above.  The light adds no more than
 * white, so a strong lobe loses its top: only what shows is spread. */
int32_t tp_rough_peak(const tp_lobe_form *form, int32_t narrowing);
tp_lobe_form tp_lobe_form_make(tp_fx shininess, tp_fx strength);

/* Fills the variance that each level of a texture of slopes has lost against level 0,
 * Q24.  `slopes` unpacks the two slopes of a texel, Q12. */
typedef struct {
    int32_t x, z;
} tp_texel_slopes;
void tp_ripple_variance_init(tp_ripple_variance *ripple, const tp_texture *texture,
                             tp_texel_slopes (*slopes)(uint32_t texel));

#endif
