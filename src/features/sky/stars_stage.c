/* SPDX-License-Identifier: MIT */
/*
 * Stars over a night's dome.
 *
 * The sky is a cube of 6 x 64 x 64 cells.  A hash of the cell decides whether the cell has a
 * star, and its place.  No list is stored, and a pixel examines its own cell only.
 *
 * A star is a round dot of a fixed width in pixels (shade->env.star) at any picture size,
 * so no star falls between two pixels.  Few stars are bright.  Water reflects no stars: the
 * slightest ripple would blur them.
 */
#include "features/sky/sky.h"
#include "shade/env.h"
#include "shade/slope.h"
#include "tidepool/modules.h"

#define CELL_LOG2 10            /* of a face's 65536 units */
#define MARGIN    256           /* distance of stars from their cell's edges */
#define AIR       500           /* height of a direction below which stars are dark, Q1.14 */

TP_ALWAYS_INLINE uint32_t hash(uint32_t n)
{
    n = (n ^ n >> 15) * 0x2c1b3c6du;
    n = (n ^ n >> 12) * 0x297a2d39u;
    return n ^ n >> 15;
}

/* Returns the brightness 0..256 of the dot at (ds, dt) from its centre.  A unit of a face
 * covers a smaller angle farther out; m is the cosine of the angle to the face's centre. */
TP_ALWAYS_INLINE uint32_t dot_brightness(const tp_shade *shade, int32_t ds, int32_t dt,
                                         int32_t cosine)
{
    uint32_t square = (uint32_t)(ds * ds + dt * dt) >> 2;
    uint32_t narrow = (uint32_t)(cosine * cosine) >> 16;          /* Q12 */
    uint32_t down = (uint32_t)((uint64_t)(square * narrow >> 10) * shade->env.star >> 16);
    return down < 256 ? 256 - down : 0;
}

static const uint32_t tints[4] = { 0xffffff, 0xd8e4ff, 0xfff0d8, 0xecf2ff };

/* Returns the hash of the cell at (s, t) of a face. */
TP_ALWAYS_INLINE uint32_t hash_cell(int face, int32_t s, int32_t t)
{
    return hash((uint32_t)(face * 4096 + (t >> CELL_LOG2) * 64 + (s >> CELL_LOG2)) + 1);
}

TP_ALWAYS_INLINE bool has_star(const tp_shade *shade, uint32_t cell_hash)
{
    return (cell_hash & 0xff) < shade->env.stars;
}

/* Returns the light 0x00RRGGBB of a cell's star at (s, t).  `m` is the cosine of the angle
 * to the face's centre, y the height of the direction; Q1.14.  Near the horizon the air
 * absorbs the stars. */
TP_ALWAYS_INLINE uint32_t star_light(const tp_shade *shade, uint32_t h, int32_t s, int32_t t,
                                     int32_t m, int32_t y)
{
    int32_t mask = (1 << CELL_LOG2) - 1, room = mask + 1 - 2 * MARGIN;
    int32_t ds = (s & mask) - MARGIN - (int32_t)((h >> 8 & 0xff) * (uint32_t)room >> 8);
    int32_t dt = (t & mask) - MARGIN - (int32_t)((h >> 16 & 0xff) * (uint32_t)room >> 8);
    uint32_t rank = h >> 24, bright = 56 + (rank * rank * rank >> 16) * 7 / 4;
    uint32_t air = (uint32_t)tp_clamp((y - AIR) >> 3, 0, 256);
    uint32_t share = (dot_brightness(shade, ds, dt, m) * bright >> 8) * air >> 8;

    return tp_colour_scale(tints[h >> 14 & 3], share < 256 ? share : 256);
}

TP_ALWAYS_INLINE uint32_t sample_star(const tp_shade *shade, int32_t x, int32_t y,
                                      int32_t z)
{
    tp_cube_place p = tp_cube_project(shade->env.recip, x, y, z);
    uint32_t h = hash_cell(p.face, p.s, p.t);

    return has_star(shade, h) ? star_light(shade, h, p.s, p.t, p.m, y) : 0;
}

void tp_stage_stars(const tp_shade *shade, tp_run *run)
{
    TP_ASSERT(shade->env.recip != NULL);
    for (int32_t i = 0; i < run->count; i++) {
        if (run->vy[i] < 0)
            run->colour[i] = tp_colour_add(run->colour[i],
                                           sample_star(shade, -run->vx[i], -run->vy[i],
                                                   -run->vz[i]));
    }
}

/* -- the fast rung ------------------------------------------------------------------- */

/* Positions on a face are exact at every 8th column and linear between. */

typedef struct {
    tp_cube_ray at;
    tp_ray  to;
    int32_t s, t;
} star_knot;

/* Sets the position from `at`. */
static void place_knot(star_knot *knot, const uint32_t *recip)
{
    const int32_t r = tp_cube_recip(recip, knot->at.m);

    knot->s = tp_clamp(32768 + (knot->at.right * r >> 14), 0, 65535);
    knot->t = tp_clamp(32768 + (knot->at.down * r >> 14), 0, 65535);
}

static void set_star_knot(star_knot *knot, const tp_shade *shade,
                          const tp_quick_ray_row *row, int32_t x)
{
    const tp_ray v = tp_quick_ray_inline(shade, row, 16 * x + 8);

    knot->to = (tp_ray){ -v.x, -v.y, -v.z, 0 };
    knot->at = tp_cube_face(-v.x, -v.y, -v.z);
    place_knot(knot, shade->env.recip);
}

/* Sets the knot in the middle of two knots of one face. */
static void set_middle_knot(star_knot *knot, const tp_shade *shade, const star_knot *a,
                            const star_knot *b)
{
    knot->to = (tp_ray){ 0, (a->to.y + b->to.y) / 2, 0, 0 };
    knot->at = (tp_cube_ray){ a->at.face, (a->at.right + b->at.right) / 2,
                              (a->at.down + b->at.down) / 2, (a->at.m + b->at.m) / 2 };
    place_knot(knot, shade->env.recip);
}

/* True if the columns between two knots of one face lie in one cell or in two neighbours,
 * without a star. */
static bool is_starless(const tp_shade *shade, const star_knot *a, const star_knot *b)
{
    const int32_t s = (b->s >> CELL_LOG2) - (a->s >> CELL_LOG2);
    const int32_t t = (b->t >> CELL_LOG2) - (a->t >> CELL_LOG2);

    if (tp_abs(s) + tp_abs(t) > 1 || has_star(shade, hash_cell(a->at.face, a->s, a->t)))
        return false;
    return s + t == 0 || !has_star(shade, hash_cell(a->at.face, b->s, b->t));
}

/* Adds the stars of columns [k, end) of the eight between two knots of one face; `to` is
 * column k. */
static void add_stars_of_face(const tp_shade *shade, const star_knot *a, const star_knot *b,
                              uint32_t *to, int32_t k, int32_t end)
{
    const int32_t ds = b->s - a->s, dt = b->t - a->t, y = (a->to.y + b->to.y) / 2;
    int32_t  s = 8 * a->s + ds * k, t = 8 * a->t + dt * k, cell = -1;
    uint32_t h = 0;
    bool     found = false;

    if (is_starless(shade, a, b))
        return;
    for (; k < end; k++, to++, s += ds, t += dt) {
        const int32_t here = (t >> (CELL_LOG2 + 3)) * 64 + (s >> (CELL_LOG2 + 3));
        if (here != cell) {
            cell = here;
            h = hash_cell(a->at.face, s >> 3, t >> 3);
            found = has_star(shade, h);
        }
        if (found)
            *to = tp_colour_add(*to, star_light(shade, h, s >> 3, t >> 3, a->at.m, y));
    }
}

/* Adds the stars of columns [k, end) of the 16 between two knots; `to` is column k. */
static void add_stars_of_block(const tp_shade *shade, const star_knot *a,
                               const star_knot *b, uint32_t *to, int32_t k, int32_t end)
{
    const tp_ray p = a->to, q = b->to;
    star_knot middle;

    if (a->at.face != b->at.face) {
        for (; k < end; k++, to++)
            *to = tp_colour_add(*to, sample_star(shade, p.x + ((q.x - p.x) * k >> 4),
                                                 p.y + ((q.y - p.y) * k >> 4),
                                                 p.z + ((q.z - p.z) * k >> 4)));
        return;
    }
    set_middle_knot(&middle, shade, a, b);
    const int32_t right = k > 8 ? k : 8;
    add_stars_of_face(shade, a, &middle, to, k, end < 8 ? end : 8);
    add_stars_of_face(shade, &middle, b, to + (right - k), right - 8, end - 8);
}

void tp_stage_stars_fast(const tp_shade *shade, tp_run *run)
{
    TP_ASSERT(shade->env.recip != NULL);
    const tp_quick_ray_row row = tp_quick_ray_row_make(shade, run->y);
    star_knot knot[2];
    int32_t   n = 0;

    set_star_knot(&knot[0], shade, &row, run->x & ~15);
    for (int32_t i = 0; i < run->count; n ^= 1) {
        int32_t stop = tp_block_end(run, i), k = (run->x + i) & 15;
        const star_knot *a = &knot[n], *b = &knot[n ^ 1];
        set_star_knot(&knot[n ^ 1], shade, &row, run->x + i - k + 16);
        if (a->to.y > AIR || b->to.y > AIR)
            add_stars_of_block(shade, a, b, run->colour + i, k, k + stop - i);
        i = stop;
    }
}

const tp_stage tp_stars_stages[] = {
#define X(name) tp_stage_##name,
    TP_STAGES_OF_stars(X)
#undef X
};
