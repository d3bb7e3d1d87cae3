/* SPDX-License-Identifier: MIT */
/* Conditions under which scanline water draws the same picture as triangles; they depend
 * on camera and sea alone.
 *
 * Scanline water requires that a column of pixels, walked upwards, meets the grid's lines
 * one after the other, each line once.  Hence the eye must stand above all water, every
 * ray of the picture must lead away across the lines, and the camera must neither roll nor
 * be upside down.  Displaced lines must also keep their order along a ray.  A ray goes t
 * metres along the lines for each metre across them; lines are met in order while J_mm - t
 * J_km > 0, k across, m along:
 *     sum |bend_mm - t bend_km| < 1,
 * for any phases.  The sum is convex in t: checking the picture's corners suffices.
 * Relief on the swells is a height and moves nothing sideways.  Breaking waves overhang
 * and are excluded.
 *
 * The widest ray also bounds the distance of two lines along a ray, and with it the
 * deviation from the triangles. */
#include "frame/frame.h"
#include "wave/ocean_tables.h"

#define STEEP   3                       /* t of the widest ray: 71.6 degrees */
#define ROLL    (TP_FX_ONE / 64)        /* sine of the largest roll */
#define ABOVE   (TP_FX_ONE / 8)         /* least height over the highest crest, m */
#define FOLDS   (TP_FX_ONE * 9 / 10)    /* limit of the sum for deep water */
#define STEEPENS (TP_FX_ONE * 3 / 4)    /* for coastal water, whose waves steepen more */

/* A horizontal ray by its components across and along the lines, of any length. */
typedef struct {
    int64_t across, along;
} level_ray;

static bool is_view_along_x(const tp_frame *frame)
{
    const tp_dir3 *back = &frame->projection.turn.z;
    return tp_abs(back->x) > tp_abs(back->z);
}

/* Ray through a corner of the picture, 16.16; pixels lie below 2^12 from the centre, the
 * focal length is below 2^16. */
static level_ray corner_ray(const tp_frame *frame, int corner)
{
    const tp_rotation *turn = &frame->projection.turn;
    int64_t u = (int64_t)frame->config.width << 15, v = (int64_t)frame->config.height << 15;
    int64_t far = frame->projection.focal;

    u = corner & 1 ? u : -u;
    v = corner & 2 ? v : -v;
    int64_t x = (turn->x.x * u + turn->y.x * v - turn->z.x * far) >> 30;
    int64_t z = (turn->x.z * u + turn->y.z * v - turn->z.z * far) >> 30;
    return is_view_along_x(frame) ? (level_ray){ x, z } : (level_ray){ z, x };
}

static bool is_line_order_kept(const tp_frame *frame, tp_fx t)
{
    const tp_deep_water *deep = frame->surface.deep;
    int64_t sum = 0;

    for (uint32_t i = 0; i < deep->count; i++) {
        const tp_swell *w = &deep->swell[i];
        tp_q30  mm = is_view_along_x(frame) ? w->bend_zz : w->bend_xx;
        int64_t b = (mm - ((int64_t)w->bend_xz * t >> 16)) >> 14;
        sum += b < 0 ? -b : b;
    }
    return sum < (frame->surface.coastal ? STEEPENS : FOLDS);
}

/* True if all corner rays lead away across the lines, within the widest angle, and the
 * lines on each keep their order. */
static bool are_lines_ordered_in_view(const tp_frame *frame)
{
    const tp_dir3 *back = &frame->projection.turn.z;
    bool behind = (is_view_along_x(frame) ? back->x : back->z) > 0;

    for (int corner = 0; corner < 4; corner++) {
        level_ray ray = corner_ray(frame, corner);
        int64_t across = behind ? -ray.across : ray.across;
        int64_t along = behind ? -ray.along : ray.along;
        if (across < TP_FX_ONE || (along < 0 ? -along : along) >= STEEP * across)
            return false;
        if (!is_line_order_kept(frame, (tp_fx)(along * TP_FX_ONE / across)))
            return false;
    }
    return true;
}

static bool can_any_wave_overhang(const tp_coastal_water *coastal)
{
    for (uint32_t i = 0; i < coastal->count; i++)
        if (tp_can_overhang(coastal->wave[i].stretch, coastal->slope,
                            coastal->map_cols > 0))
            return true;
    return false;
}

bool tp_frame_can_draw_rows(tp_frame *frame)
{
    return frame->buffers.lines && frame->buffers.grid
           && !(frame->buffers.grid->streams
                && is_view_along_x(frame)) /* read row by row */
           && tp_abs(frame->projection.turn.x.y >> 14) < ROLL
           && frame->projection.turn.y.y > 0
           && frame->projection.eye.y > tp_surface_height_bound(&frame->surface) + ABOVE
           && are_lines_ordered_in_view(frame)
           && !(frame->surface.coastal && can_any_wave_overhang(frame->surface.coastal));
}
