/* SPDX-License-Identifier: MIT */
/* Pixel coverage of a triangle: by pictures, by the fill rule in exact integers, and by
 * closed meshes, where every pixel is drawn exactly once. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "../reference/triangle.h"
#include "tests/lib/random.h"
#include "tests/lib/frames.h"

#define BAND (8192 * 16)        /* farthest corners from the picture's centre, 28.4 */

static uint64_t chance;

static tp_screen_vertex corner(int32_t u, int32_t v)
{
    return (tp_screen_vertex){ .u = u, .v = v, .zi = 1u << 30 };
}

static bool is_drawn(const test_tile *tile, int32_t x, int32_t y)
{
    return tile->samples.key[tile_at(tile, x, y)] != 0;
}

/* -- pictures ------------------------------------------------------------------------- */

/* Pixel coverage of triangles, as pictures of 16 x 16 pixels.  Corners are in
 * 28.4: 16 units per pixel; the centre of pixel (x, y) is (16 x + 8, 16 y +
 * 8).  The n-th triangle is drawn as the digit n, a pixel in two triangles as
 * X. */
static const struct {
    const char *name;
    int         count;          /* number of triangles */
    int32_t     at[24][2];      /* corners of the triangles */
    const char *rows[16];
} pictures[] = {
    { "edges on centres: left and top are in, right and bottom are not",
      2,
      { { 24, 24 }, { 152, 24 }, { 152, 152 },
        { 24, 24 }, { 152, 152 }, { 24, 152 } },
      { "................",
        ".11111111.......",
        ".21111111.......",
        ".22111111.......",
        ".22211111.......",
        ".22221111.......",
        ".22222111.......",
        ".22222211.......",
        ".22222221.......",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................" } },
    { "the diagonal through centres belongs to the triangle on its right",
      2,
      { { 24, 24 }, { 152, 24 }, { 24, 152 },
        { 152, 24 }, { 152, 152 }, { 24, 152 } },
      { "................",
        ".11111111.......",
        ".11111112.......",
        ".11111122.......",
        ".11111222.......",
        ".11112222.......",
        ".11122222.......",
        ".11222222.......",
        ".12222222.......",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................" } },
    { "an edge two left and three down meets the centre of every third row",
      2,
      { { 24, 8 }, { 200, 8 }, { 40, 248 },
        { 200, 8 }, { 232, 248 }, { 40, 248 } },
      { ".11111111111....",
        "..11111111112...",
        "..11111111122...",
        "..11111111222...",
        "..11111111222...",
        "..11111112222...",
        "..11111122222...",
        "..11111122222...",
        "..111112222222..",
        "..111122222222..",
        "..111122222222..",
        "..111222222222..",
        "..112222222222..",
        "..112222222222..",
        "..122222222222..",
        "................" } },
    { "an edge three right and two down, steeper than its pixels",
      2,
      { { 8, 24 }, { 248, 24 }, { 248, 184 },
        { 8, 24 }, { 248, 184 }, { 8, 184 } },
      { "................",
        "111111111111111.",
        "221111111111111.",
        "222111111111111.",
        "222221111111111.",
        "222222111111111.",
        "222222221111111.",
        "222222222111111.",
        "222222222221111.",
        "222222222222111.",
        "222222222222221.",
        "................",
        "................",
        "................",
        "................",
        "................" } },
    { "a level edge on centres belongs to the triangle below",
      2,
      { { 16, 8 }, { 240, 104 }, { 16, 104 },
        { 16, 104 }, { 240, 104 }, { 240, 250 } },
      { "................",
        ".11.............",
        ".11111..........",
        ".1111111........",
        ".111111111......",
        ".111111111111...",
        ".22222222222222.",
        "...222222222222.",
        "....22222222222.",
        "......222222222.",
        ".......22222222.",
        ".........222222.",
        "..........22222.",
        "............222.",
        ".............22.",
        "................" } },
    { "a level edge between rows of centres",
      2,
      { { 16, 8 }, { 240, 96 }, { 16, 96 },
        { 16, 96 }, { 240, 96 }, { 240, 250 } },
      { "................",
        ".111............",
        ".11111..........",
        ".11111111.......",
        ".1111111111.....",
        ".1111111111111..",
        "..2222222222222.",
        "...222222222222.",
        ".....2222222222.",
        "......222222222.",
        "........2222222.",
        ".........222222.",
        "..........22222.",
        "............222.",
        ".............22.",
        "................" } },
    { "an upright edge on centres belongs to the triangle on its right",
      2,
      { { 8, 8 }, { 120, 16 }, { 120, 240 },
        { 120, 16 }, { 250, 100 }, { 120, 240 } },
      { "................",
        ".1111112........",
        ".111111222......",
        "..111112222.....",
        "..11111222222...",
        "...11112222222..",
        "...111122222222.",
        "....1112222222..",
        "....1112222222..",
        ".....11222222...",
        ".....1122222....",
        "......12222.....",
        "......1222......",
        ".......22.......",
        ".......2........",
        "................" } },
    { "eight around a centre share it out",
      8,
      { { 120, 120 }, { 8, 8 }, { 120, 8 },
        { 120, 120 }, { 120, 8 }, { 232, 8 },
        { 120, 120 }, { 232, 8 }, { 232, 120 },
        { 120, 120 }, { 232, 120 }, { 232, 232 },
        { 120, 120 }, { 232, 232 }, { 120, 232 },
        { 120, 120 }, { 120, 232 }, { 8, 232 },
        { 120, 120 }, { 8, 232 }, { 8, 120 },
        { 120, 120 }, { 8, 120 }, { 8, 8 } },
      { "11111112222222..",
        "81111112222223..",
        "88111112222233..",
        "88811112222333..",
        "88881112223333..",
        "88888112233333..",
        "88888812333333..",
        "77777774444444..",
        "77777765444444..",
        "77777665544444..",
        "77776665554444..",
        "77766665555444..",
        "77666665555544..",
        "76666665555554..",
        "................",
        "................" } },
    { "slivers take what centres they hold, often none",
      7,
      { { 0, 0 }, { 255, 63 }, { 255, 64 },
        { 0, 0 }, { 255, 64 }, { 255, 66 },
        { 4, 250 }, { 250, 130 }, { 252, 134 },
        { 40, 100 }, { 41, 100 }, { 40, 200 },
        { 73, 100 }, { 74, 100 }, { 73, 200 },
        { 136, 200 }, { 200, 200 }, { 200, 201 },
        { 136, 232 }, { 200, 232 }, { 136, 231 } },
      { "................",
        "................",
        "................",
        "................",
        "................",
        "................",
        "..4.............",
        "..4.............",
        "..4.............",
        "..4.............",
        "..4.............",
        "..4.............",
        "........6666....",
        "................",
        "................",
        "................" } },
    { "triangles of about a pixel: around, left of, above and on a centre",
      8,
      { { 35, 35 }, { 46, 36 }, { 40, 47 },
        { 88, 40 }, { 95, 40 }, { 88, 47 },
        { 136, 40 }, { 129, 40 }, { 129, 47 },
        { 184, 40 }, { 177, 33 }, { 184, 33 },
        { 40, 99 }, { 45, 109 }, { 40, 109 },
        { 88, 99 }, { 88, 109 }, { 83, 109 },
        { 131, 104 }, { 141, 104 }, { 136, 110 },
        { 179, 104 }, { 189, 104 }, { 184, 98 } },
      { "................",
        "................",
        "..1..2..........",
        "................",
        "................",
        "................",
        "..5.....7.......",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................",
        "................" } },
};

static void draw_picture(int count, const int32_t at[24][2], char rows[16][17])
{
    memset(rows, '.', 16 * sizeof *rows);
    for (int n = 0; n < count; n++) {
        test_tile tile = tile_of(0, 0, 16, 16, 0);
        const tp_screen_vertex a = corner(at[3 * n][0], at[3 * n][1]);
        const tp_screen_vertex b = corner(at[3 * n + 1][0], at[3 * n + 1][1]);
        const tp_screen_vertex c = corner(at[3 * n + 2][0], at[3 * n + 2][1]);
        tp_tri_water(&tile.samples, &a, &b, &c);
        for (int i = 0; i < 256; i++) {
            char *to = &rows[i / 16][i % 16];
            if (is_drawn(&tile, i % 16, i / 16))
                *to = *to == '.' ? (char)('1' + n) : 'X';
        }
        tile_free(&tile);
    }
}

static void pictures_come_out_as_drawn_here(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof pictures / sizeof pictures[0]; i++) {
        char rows[16][17];
        draw_picture(pictures[i].count, pictures[i].at, rows);
        for (int y = 0; y < 16; y++) {
            rows[y][16] = '\0';
            if (strcmp(rows[y], pictures[i].rows[y]) != 0)
                fail_msg("%s, row %d: %s is not %s", pictures[i].name, y, rows[y],
                         pictures[i].rows[y]);
        }
    }
}

/* -- the fill rule in exact integers ------------------------------------------------- */

/* The tile is a part of the picture: 192 x 128 px at (64, 32). */
static void compare(const tp_screen_vertex c[3], uint64_t *pixels)
{
    const tp_screen_vertex *const corners[3] = { &c[0], &c[1], &c[2] };
    const bool flat = tp_tri_twice_area(&c[0], &c[1], &c[2]) == 0;
    test_tile tile = tile_of(64, 32, 256, 160, 0);

    tp_tri_water(&tile.samples, &c[0], &c[1], &c[2]);
    for (int32_t y = 32; y < 160; y++) {
        int64_t left = 0, right = 0;
        if (!flat)
            ref_fill_row(corners, y, &left, &right);
        for (int32_t x = 64; x < 256; x++) {
            const bool want = left <= x && x < right;
            *pixels += want;
            if (is_drawn(&tile, x, y) != want)
                fail_msg("pixel %d %d of (%d %d) (%d %d) (%d %d) should be %d", (int)x,
                         (int)y, (int)c[0].u, (int)c[0].v, (int)c[1].u, (int)c[1].v,
                         (int)c[2].u, (int)c[2].v, (int)want);
        }
    }
    tile_free(&tile);
}

/* A corner within `far` sixteenths of the tile's middle; one in four is on a pixel's
 * centre. */
static tp_screen_vertex any_corner(int32_t far)
{
    const int32_t grain = random_below(&chance, 4) ? 1 : 16;
    return corner(160 * 16 + chance_int(&chance, -far, far) / grain * grain + 8,
                  96 * 16 + chance_int(&chance, -far, far) / grain * grain + 8);
}

static void triangles_cover_what_the_rule_says(void **state)
{
    (void)state;
    static const int32_t fars[] = { 24, 100, 1000, 3000, 20000, BAND };

    for (size_t i = 0; i < sizeof fars / sizeof fars[0]; i++) {
        uint64_t pixels = 0;
        for (int n = 0; n < random_rounds(400, 100); n++) {
            const tp_screen_vertex c[3] = { any_corner(fars[i]), any_corner(fars[i]),
                                            any_corner(fars[i]) };
            compare(c, &pixels);
        }
        printf("    corners within %7.1f px: %9" PRIu64 " pixels\n", fars[i] / 16.0,
               pixels);
        assert_true(pixels > 0);
    }
}

/* The third corner is within an LSB or two of the line between the others. */
static void slivers_cover_what_the_rule_says(void **state)
{
    (void)state;
    static const int32_t fars[] = { 100, 3000, BAND };

    for (size_t i = 0; i < sizeof fars / sizeof fars[0]; i++) {
        uint64_t pixels = 0;
        for (int n = 0; n < random_rounds(700, 150); n++) {
            tp_screen_vertex c[3] = { any_corner(fars[i]), any_corner(fars[i]) };
            const double way = chance_double(&chance, -0.2, 1.2);
            c[2] = corner((int32_t)lround(c[0].u + way * (c[1].u - c[0].u))
                              + chance_int(&chance, -2, 2),
                          (int32_t)lround(c[0].v + way * (c[1].v - c[0].v))
                              + chance_int(&chance, -2, 2));
            c[2].u = tp_clamp(c[2].u, 2568 - BAND, 2568 + BAND);
            c[2].v = tp_clamp(c[2].v, 1544 - BAND, 1544 + BAND);
            compare(c, &pixels);
        }
        printf("    slivers within %7.1f px: %9" PRIu64 " pixels\n", fars[i] / 16.0,
               pixels);
    }
}

static void the_order_of_the_corners_does_not_matter(void **state)
{
    (void)state;
    static const int order[6][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 },
                                     { 0, 2, 1 }, { 2, 1, 0 }, { 1, 0, 2 } };

    for (int n = 0; n < random_rounds(60, 20); n++) {
        const tp_screen_vertex c[3] = { any_corner(900), any_corner(900), any_corner(900) };
        test_tile first = tile_of(64, 32, 256, 160, 0);
        tp_tri_water(&first.samples, &c[0], &c[1], &c[2]);
        for (int k = 1; k < 6; k++) {
            test_tile tile = tile_of(64, 32, 256, 160, 0);
            tp_tri_water(&tile.samples, &c[order[k][0]], &c[order[k][1]],
                         &c[order[k][2]]);
            for (int32_t y = 32; y < 160; y++) {
                for (int32_t x = 64; x < 256; x++)
                    assert_int_equal(is_drawn(&tile, x, y), is_drawn(&first, x, y));
            }
            tile_free(&tile);
        }
        tile_free(&first);
    }
}

/* -- closed meshes ------------------------------------------------------------------- */

enum { POINTS = 240, FACES = 2 * POINTS };

typedef struct {
    int32_t point[POINTS][2];
    int     face[FACES][3];     /* all have the same orientation */
    int     points, faces;
} mesh;

static int64_t turn(const mesh *m, int a, int b, int32_t u, int32_t v)
{
    return (int64_t)(m->point[b][0] - m->point[a][0]) * (v - m->point[a][1])
         - (int64_t)(m->point[b][1] - m->point[a][1]) * (u - m->point[a][0]);
}

/* Puts a point strictly inside a face and splits the face into three. */
static void split(mesh *m, int f, int32_t u, int32_t v)
{
    const int a = m->face[f][0], b = m->face[f][1], c = m->face[f][2], p = m->points++;
    const int made[3][3] = { { a, b, p }, { b, c, p }, { c, a, p } };

    m->point[p][0] = u;
    m->point[p][1] = v;
    memcpy(m->face[f], made[0], sizeof made[0]);
    memcpy(m->face[m->faces++], made[1], sizeof made[1]);
    memcpy(m->face[m->faces++], made[2], sizeof made[2]);
}

/* A square around the tile's middle, split into faces by random points, half of the points
 * inside the tile.  Repeated splitting produces slivers. */
static mesh any_mesh(int32_t far)
{
    mesh m = { .point = { { 1280 - far, 1280 - far }, { 1280 + far, 1280 - far },
                          { 1280 + far, 1280 + far }, { 1280 - far, 1280 + far } },
               .face = { { 0, 1, 2 }, { 0, 2, 3 } }, .points = 4, .faces = 2 };

    for (int n = 0; n < 4 * POINTS && m.points < POINTS; n++) {
        const int32_t within = n % 2 ? far : 1280;
        const int32_t u = 1280 + chance_int(&chance, -within, within);
        const int32_t v = 1280 + chance_int(&chance, -within, within);
        for (int f = 0; f < m.faces; f++) {
            const int *c = m.face[f];
            if (turn(&m, c[0], c[1], u, v) > 0 && turn(&m, c[1], c[2], u, v) > 0
                && turn(&m, c[2], c[0], u, v) > 0) {
                split(&m, f, u, v);
                break;
            }
        }
    }
    return m;
}

static void each_pixel_of_a_closed_mesh_is_drawn_once(void **state)
{
    (void)state;
    static const int32_t fars[] = { 1280, 5000, 16000, BAND };
    static uint8_t count[160 * 160];

    for (int n = 0; n < random_rounds(24, 8); n++) {
        const mesh m = any_mesh(fars[n % 4]);
        memset(count, 0, sizeof count);
        test_tile tile = tile_of(0, 0, 160, 160, 0);
        for (int f = 0; f < m.faces; f++) {
            tp_screen_vertex c[3];
            for (int k = 0; k < 3; k++)
                c[k] = corner(m.point[m.face[f][k]][0], m.point[m.face[f][k]][1]);
            tp_gbuffer_clear(&tile.samples);
            tp_tri_water(&tile.samples, &c[0], &c[1], &c[2]);
            for (int i = 0; i < 160 * 160; i++)
                count[i] = (uint8_t)(count[i] + (tile.samples.key[i] != 0));
        }
        tile_free(&tile);
        for (int i = 0; i < 160 * 160; i++) {
            if (count[i] != 1)
                fail_msg("pixel %d %d is drawn %d times, corners within %d px", i % 160,
                         i / 160, count[i], (int)fars[n % 4] / 16);
        }
    }
}

/* -- tiles --------------------------------------------------------------------------- */

static tp_screen_vertex any_sample_corner(int32_t far)
{
    tp_screen_vertex c = any_corner(far);

    c.zi = (uint32_t)chance_int(&chance, 1 << 16, 0x7f7fffff);
    c.s = chance_int(&chance, -1000 * TP_FX_ONE, 1000 * TP_FX_ONE);
    c.t = chance_int(&chance, -1000 * TP_FX_ONE, 1000 * TP_FX_ONE);
    for (int k = 0; k < 3; k++)
        c.n[k] = (int16_t)chance_int(&chance, -511, 511);
    return c;
}

typedef struct {
    tp_screen_vertex corner[3];
    int       opacity;          /* for a solid; -1: water */
} shape;

static void draw_shapes(const tp_gbuffer *tile, const shape *shapes, int count)
{
    for (int i = 0; i < count; i++) {
        const tp_screen_vertex *c = shapes[i].corner;
        if (shapes[i].opacity < 0)
            tp_tri_water(tile, &c[0], &c[1], &c[2]);
        else
            tp_tri_solid(tile, &c[0], &c[1], &c[2], TP_MARK_SOLID + (uint32_t)i,
                         (uint32_t)i, shapes[i].opacity);
    }
}

static void assert_same_samples(const test_tile *part, const test_tile *whole)
{
    const tp_gbuffer *p = &part->samples, *w = &whole->samples;

    for (int32_t y = p->y0; y < p->y1; y++) {
        for (int32_t x = p->x0; x < p->x1; x++) {
            const size_t i = tile_at(part, x, y), j = tile_at(whole, x, y);
            assert_int_equal(p->key[i], w->key[j]);
            assert_int_equal(p->s[i], w->s[j]);
            assert_int_equal(p->t[i], w->t[j]);
            assert_int_equal(p->n[i], w->n[j]);
        }
        for (size_t x = (size_t)(p->x1 - p->x0); x < p->stride && y + 1 < p->y1; x++)
            assert_int_equal(p->s[tile_at(part, p->x0, y) + x], TILE_UNSET);
    }
}

/* Tiles begin and end anywhere, and their rows in memory are longer than the tile. */
static void tiles_cut_anywhere_give_the_same_samples(void **state)
{
    (void)state;
    static const int32_t fars[] = { 300, 2000, 2000, BAND };

    for (int n = 0; n < 60; n++) {
        shape shapes[12];
        for (int i = 0; i < 12; i++) {
            for (int k = 0; k < 3; k++)
                shapes[i].corner[k] = any_sample_corner(fars[n % 4]);
            shapes[i].opacity = chance_int(&chance, -12, 16);
        }
        test_tile whole = tile_of(0, 0, 320, 192, 0);
        draw_shapes(&whole.samples, shapes, 12);
        for (int k = 0; k < 12; k++) {
            const int32_t x0 = chance_int(&chance, 0, 318),
                          y0 = chance_int(&chance, 0, 190);
            test_tile part = tile_of(x0, y0, chance_int(&chance, x0 + 1, 320),
                                     chance_int(&chance, y0 + 1, 192),
                                     random_below(&chance, 20));
            draw_shapes(&part.samples, shapes, 12);
            assert_same_samples(&part, &whole);
            tile_free(&part);
        }
        tile_free(&whole);
    }
}

/* -- depth, stencil values, patterns ------------------------------------------------- */

static void cover_all(const tp_gbuffer *tile, uint32_t zi, uint32_t mark, int opacity)
{
    tp_screen_vertex c[3] = { corner(-2000, -2000), corner(6000, -2000),
                              corner(-2000, 6000) };

    for (int k = 0; k < 3; k++)
        c[k].zi = zi;
    tp_tri_solid(tile, &c[0], &c[1], &c[2], mark, 7, opacity);
}

static void the_nearer_stays_and_of_equals_the_first(void **state)
{
    (void)state;
    test_tile tile = tile_of(0, 0, 16, 16, 0);
    const uint32_t *key = tile.samples.key;

    cover_all(&tile.samples, 0x40000000, TP_MARK_SOLID, 16);
    assert_int_equal(TP_MARK(key[0]), TP_MARK_SOLID);
    assert_int_equal(TP_ZI(key[0]), 0x40000000);
    cover_all(&tile.samples, 0x40000000, TP_MARK_SOLID + 9, 16);
    assert_int_equal(TP_MARK(key[0]), TP_MARK_SOLID);
    cover_all(&tile.samples, 0x3fffff80, TP_MARK_SOLID + 10, 16);
    assert_int_equal(TP_MARK(key[0]), TP_MARK_SOLID);
    cover_all(&tile.samples, 0x40000080, TP_MARK_SOLID + 253, 16);
    assert_int_equal(TP_MARK(key[0]), 255);
    assert_int_equal(TP_ZI(key[255]), 0x40000080);
    tile_free(&tile);
}

/* A front face is counter-clockwise as seen, with a negative area on a screen whose v grows
 * downwards. */
static void back_faces_are_left_out_where_that_is_asked_for(void **state)
{
    (void)state;
    for (int n = 0; n < random_rounds(150, 40); n++) {
        const tp_screen_vertex c[3] = { any_corner(900), any_corner(900), any_corner(900) };
        const bool front = tp_tri_twice_area(&c[0], &c[1], &c[2]) < 0;
        test_tile all = tile_of(64, 32, 256, 160, 0), some = tile_of(64, 32, 256, 160, 0);
        some.samples.front_only = true;
        if (n % 2) {
            tp_tri_water(&all.samples, &c[0], &c[1], &c[2]);
            tp_tri_water(&some.samples, &c[0], &c[1], &c[2]);
        } else {
            tp_tri_solid(&all.samples, &c[0], &c[1], &c[2], TP_MARK_SOLID, 0, 16);
            tp_tri_solid(&some.samples, &c[0], &c[1], &c[2], TP_MARK_SOLID, 0, 16);
        }
        for (int32_t y = 32; y < 160; y++) {
            for (int32_t x = 64; x < 256; x++)
                assert_int_equal(is_drawn(&some, x, y), front && is_drawn(&all, x, y));
        }
        tile_free(&all);
        tile_free(&some);
    }
}

/* A pattern covers sixteenths of every 4 x 4 pixels and includes the patterns of lower
 * opacity. */
static void opacity_lets_sixteenths_of_the_pixels_through(void **state)
{
    (void)state;
    uint32_t before[256] = { 0 };

    for (int opacity = 0; opacity <= 16; opacity++) {
        test_tile tile = tile_of(32, 64, 48, 80, 0);
        int drawn = 0;
        cover_all(&tile.samples, 1u << 30, TP_MARK_SOLID, opacity);
        for (int i = 0; i < 256; i++) {
            drawn += tile.samples.key[i] != 0;
            assert_true(tile.samples.key[i] != 0 || before[i] == 0);
            before[i] = tile.samples.key[i];
        }
        assert_int_equal(drawn, 16 * opacity);
        tile_free(&tile);
    }
}

static void clearing_makes_everything_sky_and_touches_no_more(void **state)
{
    (void)state;
    test_tile tile = tile_of(0, 0, 20, 7, 0);

    for (int i = 0; i < 140; i++) {
        assert_int_equal(tile.samples.key[i], 0);
        assert_int_equal(TP_MARK(tile.samples.key[i]), TP_MARK_SKY);
        assert_int_equal(tile.samples.s[i], TILE_UNSET);
    }
    tile_free(&tile);
}

int main(void)
{
    chance = random_seed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pictures_come_out_as_drawn_here),
        cmocka_unit_test(triangles_cover_what_the_rule_says),
        cmocka_unit_test(slivers_cover_what_the_rule_says),
        cmocka_unit_test(the_order_of_the_corners_does_not_matter),
        cmocka_unit_test(each_pixel_of_a_closed_mesh_is_drawn_once),
        cmocka_unit_test(tiles_cut_anywhere_give_the_same_samples),
        cmocka_unit_test(the_nearer_stays_and_of_equals_the_first),
        cmocka_unit_test(back_faces_are_left_out_where_that_is_asked_for),
        cmocka_unit_test(opacity_lets_sixteenths_of_the_pixels_through),
        cmocka_unit_test(clearing_makes_everything_sky_and_touches_no_more),
    };
    return cmocka_run_group_tests_name("raster/fill", tests, NULL, NULL);
}
