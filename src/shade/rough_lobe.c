/* SPDX-License-Identifier: MIT */
/* Light of rough water: the variance at a depth, and the lobe at a variance. */
#include "shade/rough_lobe.h"
#include "fixed/arithmetic.h"

const tp_entry16 tp_sqrt_table[258] = {
#include "shade/sqrt_table.inc"
};

/* -- variance ------------------------------------------------------------------------ */

static uint32_t add_variance(uint32_t a, uint32_t b)
{
    const uint32_t sum = a + b;
    return sum < TP_ROUGH_ONE ? sum : TP_ROUGH_ONE;
}

uint32_t tp_rough_ripple_variance(const tp_ripple_variance *ripple, int32_t log_depth)
{
    const int level = tp_mip_level_choose(ripple->lod, log_depth, true, ripple->levels);
    const uint64_t lost = (uint64_t)ripple->lost[level] * ripple->gain_square >> 16;

    return lost < TP_ROUGH_ONE ? (uint32_t)lost : TP_ROUGH_ONE;
}

tp_slope_variance tp_rough_variance(const tp_shade *shade, int32_t log_depth)
{
    tp_slope_variance sum = tp_filtered_waves_lookup(shade->filtered, log_depth);
    const uint32_t lost =
        shade->ripple ? tp_rough_ripple_variance(shade->ripple, log_depth) : 0;

    return (tp_slope_variance){ add_variance(sum.along, lost),
                                add_variance(sum.across, lost), sum.left };
}

static uint32_t level_side(uint32_t log2_side, uint32_t level)
{
    return log2_side > level ? 1u << (log2_side - level) : 1;
}

/* Slopes are at most 8. */
static int64_t product(tp_texel_slopes a, tp_texel_slopes b)
{
    return (int64_t)a.x * b.x + (int64_t)a.z * b.z;
}

/* Returns 9 times the mean square of the slopes between four texels, a b over c d, as
 * linear filtering shows them: |a|^2 stands for the squares of all four. */
static int64_t patch_square(tp_texel_slopes a, tp_texel_slopes b, tp_texel_slopes c,
                            tp_texel_slopes d)
{
    return 4 * product(a, a) + 2 * (product(a, b) + product(a, c))
         + (product(a, d) + product(b, c)) / 2;
}

/* Returns the mean square of the filtered slopes of a level, an axis, Q24. */
static uint32_t mean_square(const tp_texture *texture, uint32_t level,
                            tp_texel_slopes (*slopes)(uint32_t texel))
{
    const uint32_t w = level_side(texture->log2_w, level);
    const uint32_t h = level_side(texture->log2_h, level);
    int64_t sum = 0;

    for (uint32_t y = 0; y < h; y++) {
        const uint32_t *row = texture->level[level] + (size_t)y * w;
        const uint32_t *below = texture->level[level] + (size_t)((y + 1) % h) * w;
        tp_texel_slopes a = slopes(row[0]), c = slopes(below[0]);
        for (uint32_t x = 1; x <= w; x++) {
            const tp_texel_slopes b = slopes(row[x % w]), d = slopes(below[x % w]);
            sum += patch_square(a, b, c, d);
            a = b;
            c = d;
        }
    }
    return (uint32_t)(sum / (int64_t)(18 * (uint64_t)w * h));
}

void tp_ripple_variance_init(tp_ripple_variance *ripple, const tp_texture *texture,
                             tp_texel_slopes (*slopes)(uint32_t texel))
{
    uint32_t whole = 0;

    for (uint32_t l = 0; l < texture->levels; l++) {
        const uint32_t kept = mean_square(texture, l, slopes);
        whole = l == 0 ? kept : whole;
        ripple->lost[l] = kept < whole ? whole - kept : 0;
    }
    ripple->levels = texture->levels;
}

/* -- the lobe ------------------------------------------------------------------------ */

int32_t tp_rough_narrowing(uint32_t exponent, uint32_t variance)
{
    TP_ASSERT(exponent <= 1000 && variance <= TP_ROUGH_ONE);
    const uint32_t k = (1u << 19) + (uint32_t)((uint64_t)variance * exponent >> 3);
    const int up = tp_clz(k);                                   /* of k, Q19 */

    return (int32_t)(((uint32_t)tp_recip_rough(k << up) + (1u << (28 - up))) >> (29 - up));
}

/* Returns the root of the product of two Q14 numbers, up to 1; the product is scaled to
 * 1/4..1. */
static int32_t geometric_mean(int32_t a, int32_t b)
{
    const uint32_t product = (uint32_t)(a * b);
    const int up = (tp_clz(product | 1) - 3) & ~1;

    return tp_sqrt_nearest(up > 0 ? product << up : product) >> (up > 0 ? up / 2 : 0);
}

/* Returns 1 + ln s for s of 1..4, by ln s = 2 (y + y^3 / 3), y = (s - 1) / (s + 1). */
static tp_fx one_plus_log(tp_fx s)
{
    const tp_fx y = tp_fx_div(s - TP_FX_ONE, s + TP_FX_ONE);
    return TP_FX_ONE + 2 * y + 2 * tp_fx_mul(y, tp_fx_mul(y, y)) / 3;
}

/* A lobe of strength s shows min(1, s exp(-n d)), whose sum is e / n with e = s for s up to
 * 1, else 1 + ln s.  Spread by k its peak is e / k, once below 1; up to there its peak, of
 * s at k = 1, is nearly linear in 1 / k. */
tp_lobe_form tp_lobe_form_make(tp_fx shininess, tp_fx strength)
{
    tp_lobe_form form = { (uint32_t)tp_clamp(shininess >> 16, 1, 1000), 16384, 16384 };

    if (strength <= TP_FX_ONE + 256)
        return form;
    const tp_fx e = one_plus_log(strength);
    form.weak = tp_fx_div(e, strength) >> 2;
    form.strong = tp_fx_div(TP_FX_ONE - tp_fx_recip(strength),
                            TP_FX_ONE - tp_fx_recip(e)) >> 2;
    return form;
}

int32_t tp_rough_peak(const tp_lobe_form *form, int32_t narrowing)
{
    const int32_t weak = narrowing * form->weak >> 14;
    const int32_t strong = 16384 - ((16384 - narrowing) * form->strong >> 14);

    return weak > strong ? weak : strong;
}

/* -- the view ------------------------------------------------------------------------ */

/* Forms of tp_rough_view by the root of the variance, in 32nds; root is that of `square`.
 * Fitted to the mean share [F1] of normals whose slopes spread by a variance, rms 0.003
 * for N.V of -0.2 to 0.8.  Waves hide what faces away: a slope counts by its N.V as seen.
 * Ripples bend normals of a surface that is seen as it is: every slope counts, by an N.V
 * of at least 1/10 (RIPPLED_VIEW).
 *
 * fall: 1 less `height`.  A slope counts for the mirrored sky by its reflected share, and
 * slopes towards low rays reflect more: the sky's mean is the sky at a lower height than
 * that of the bent N.V.  Fitted to the mean of a day's and a dusk's gradient [V3]. */
typedef struct {
    int16_t bend, lift, root, fall;
} view_form;

static const view_form of_waves[17] = {
    { 0, 0, 0, 0 }, { 264, 195, 540, 508 }, { 600, 314, 1141, 1475 },
    { 1014, 349, 1813, 2228 }, { 1539, 349, 2523, 2916 }, { 2166, 265, 3316, 3621 },
    { 2917, 58, 4244, 4243 }, { 3827, -266, 5317, 4751 }, { 4932, -697, 6539, 5226 },
    { 6262, -1182, 7868, 5636 }, { 7804, -1681, 9255, 6029 },
    { 9589, -2212, 10730, 6357 }, { 11541, -2608, 12086, 6685 },
    { 12288, -1968, 11881, 6963 }, { 12288, -548, 10532, 7225 },
    { 12288, 553, 9503, 7471 }, { 12288, 1451, 8672, 7700 },
};
static const view_form of_ripples[17] = {
    { 1638, 1638, 0, 0 }, { 1692, 1619, 208, 262 }, { 1851, 1562, 490, 885 },
    { 2112, 1474, 822, 1589 }, { 2477, 1351, 1209, 2294 }, { 2948, 1200, 1642, 2933 },
    { 3523, 1030, 2113, 3539 }, { 4204, 843, 2619, 4145 }, { 4989, 646, 3152, 4653 },
    { 5878, 441, 3713, 5161 }, { 6865, 235, 4290, 5571 }, { 7932, 36, 4868, 6013 },
    { 9083, -159, 5453, 6357 }, { 10257, -316, 5987, 6734 },
    { 11466, -463, 6507, 7078 }, { 12700, -587, 6995, 7406 },
    { 13946, -693, 7456, 7684 },
};

/* Returns a + (b - a) part / whole. */
static int32_t form_interpolate(int32_t a, int32_t b, int32_t part, int32_t whole)
{
    return a + (b - a) * part / whole;
}

static view_form form_mix(view_form a, view_form b, int32_t part, int32_t whole)
{
    return (view_form){ (int16_t)form_interpolate(a.bend, b.bend, part, whole),
                        (int16_t)form_interpolate(a.lift, b.lift, part, whole),
                        (int16_t)form_interpolate(a.root, b.root, part, whole),
                        (int16_t)form_interpolate(a.fall, b.fall, part, whole) };
}

tp_rough_view tp_rough_view_make(uint32_t ripples, uint32_t waves)
{
    TP_ASSERT(ripples <= TP_ROUGH_ONE && waves <= TP_ROUGH_ONE);
    const uint32_t sum = add_variance(ripples, waves);
    const int32_t root = tp_sqrt_nearest(sum << 4), at = root < 8191 ? root : 8191;
    const int32_t i = at >> 9, part = at & 511;
    const view_form w = form_mix(of_waves[i], of_waves[i + 1], part, 512);
    const view_form r = form_mix(of_ripples[i], of_ripples[i + 1], part, 512);
    const view_form form = form_mix(w, r, (int32_t)(ripples * 255 / (sum | 1)), 255);

    return (tp_rough_view){ form.bend, form.lift, (uint32_t)(form.root * form.root),
                            16384 - form.fall };
}

/* -- the lobe of a sample ------------------------------------------------------------ */

/* Returns 1 / (2 (1 - ly^2)), Q14, up to 1: half the square of an angle over that of its
 * rise, by the light's height. */
static int32_t slant(int32_t ly)
{
    const int32_t rest = 16384 - (ly * ly >> 14);
    return rest > 8192 ? (1 << 27) / rest : 16384;
}

/* Returns the form of N.V at variances of waves and of ripples: a view from above meets
 * slopes less by the square of its height vy, Q14. */
static tp_rough_view view_make(const tp_shade *shade, uint32_t waves, uint32_t lost,
                               int32_t vy)
{
    const int32_t rest = (1 << 14) - (vy * vy >> 14);      /* vy may be rounded above 1 */
    const uint32_t level = rest > 0 ? (uint32_t)rest : 0;
    tp_rough_view view = tp_rough_view_make((uint32_t)((uint64_t)lost * level >> 14),
                                            (uint32_t)((uint64_t)waves * level >> 14));
    if (shade->env.kind == TP_ENV_CUBE)     /* a coarser level of the cube is the mean */
        view.height = 16384;
    return view;
}

/* Returns the variance that widens the lobe: without the loss of interpolation, which is
 * the same over many pixels and so moves a glint, but does not spread it. */
static tp_slope_variance lobe_variance(tp_slope_variance v, uint32_t lost)
{
    const uint32_t both = (v.along + v.across) >> 8 | 1;
    const uint32_t part = v.left >> 8 < both ? (v.left >> 8) * 256 / both : 256;    /* Q8 */

    return (tp_slope_variance){ add_variance((v.along >> 8) * part, lost),
                                add_variance((v.across >> 8) * part, lost), 0 };
}

/* For a variance s^2 of N.V and u = N.V / s the mean is s Phi(u) / (u Phi(u) + phi(u)),
 * and the root here is within 10 % of it. */
int32_t tp_rough_seen_rise(int32_t nv, uint32_t variance)
{
    const uint32_t square = variance * 5 / 2 * 16 + (uint32_t)(nv * nv);
    const int32_t root = tp_sqrt_nearest(square < 1u << 28 ? square : 1u << 28);

    return root > nv ? (root - nv) * 201 >> 8 : 0;
}

/* Returns what waves of a variance along the view add to N.L, Q14: those that face the eye
 * hide the others, so water before the sun shows its dark sides. */
static int32_t seen_light(const tp_shade *shade, uint32_t waves, int32_t vy, int32_t lv)
{
    const int32_t level = 16384 - (vy * vy >> 14), nv = tp_clamp(vy, 0, 16384);

    if (waves == 0 || level < 64)
        return 0;
    const int32_t rise =
        tp_rough_seen_rise(nv, (uint32_t)((uint64_t)waves * (uint32_t)level >> 14));
    return tp_clamp(rise * (lv - (vy * shade->world.ly >> 14)) / level, -16384, 16384);
}

/* Returns the square of the half vector's cosine with the view, (1 + L.V) / 2; Q15. */
static uint32_t half_cosine_square(int32_t lv)
{
    return (uint32_t)tp_clamp(16384 + lv, 0, 32768);
}

/* Returns Blinn's lobe: normals spread about the half vector, by both axes alike. */
static tp_rough_lobe blinn_lobe(const tp_shade *shade, tp_slope_variance v,
                                tp_rough_view view, int32_t seen)
{
    const int32_t n = tp_rough_narrowing(shade->lobe.exponent, (v.along + v.across) / 2);
    return (tp_rough_lobe){ view, n, n, 0, tp_rough_peak(&shade->lobe, n), seen };
}

tp_rough_lobe tp_rough_lobe_make(const tp_shade *shade, uint32_t key, int32_t vy,
                                 int32_t lv, bool blinn)
{
    const int32_t log_depth = tp_log_depth(shade, key);
    const tp_slope_variance waves = tp_filtered_waves_lookup(shade->filtered, log_depth);
    const uint32_t lost =
        shade->ripple ? tp_rough_ripple_variance(shade->ripple, log_depth) : 0;
    const tp_slope_variance v = lobe_variance(waves, lost);
    const tp_rough_view view = view_make(shade, waves.along, lost, vy);
    const int32_t seen = seen_light(shade, waves.along, vy, lv);
    if (blinn)
        return blinn_lobe(shade, v, view, seen);
    const uint32_t across = (uint32_t)((uint64_t)v.across * half_cosine_square(lv) >> 15);
    const int32_t n_across = tp_rough_narrowing(shade->lobe.exponent, across);
    const int32_t n_along = tp_rough_narrowing(shade->lobe.exponent, v.along);

    return (tp_rough_lobe){
        .view = view, .across = n_across, .along = n_along,
        .slant = slant(shade->world.ly),
        .peak = tp_rough_peak(&shade->lobe, geometric_mean(n_across, n_along)),
        .seen = seen,
    };
}
