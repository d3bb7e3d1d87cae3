/* SPDX-License-Identifier: MIT */
/* The mesh in a view: vertices projected without clamps equal those with clamps, and the
 * list finds each face in all rows where the face draws a pixel. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include "features/boat/boat.h"
#include "tests/lib/frames.h"

enum { WIDTH = 64, HEIGHT = 48, VERTICES = 90, FACES = 160, BAND = 4 };

static uint64_t chance;
static tp_mesh_vertex vertex[VERTICES];
static tp_mesh_face face[FACES];
static const tp_material material[2] = { { .opacity = TP_FX_ONE }, { .opacity = 0 } };
static const tp_mesh mesh = {
    .vertices = vertex, .faces = face, .materials = material,
    .n_vertices = VERTICES, .n_faces = FACES, .n_materials = 2,
};

static void make_mesh(tp_fx size)
{
    for (int i = 0; i < VERTICES; i++)
        vertex[i] = (tp_mesh_vertex){ .position = { chance_int(&chance, -size, size),
                                                    chance_int(&chance, -size, size),
                                                    chance_int(&chance, -size, size) } };
    for (int i = 0; i < FACES; i++) {
        for (int k = 0; k < 3; k++)
            face[i].vertex[k] = random_below(&chance, VERTICES);
        face[i].material = i % 8 == 7;
    }
}

static tp_boat_view make_view(tp_fx metres, tp_fx far)
{
    const tp_vec3 eye = { chance_int(&chance, -far, far), chance_int(&chance, -far, far),
                          chance_int(&chance, -far, far) };
    tp_boat_view b;

    tp_boat_view_init(&b, &mesh);
    b.metres = metres;
    tp_projection_init(&b.projection, eye, (tp_turn)random_next(&chance),
                       (tp_turn)chance_int(&chance, -(1 << 28), 1 << 28), 60 * TP_FX_ONE,
                       TP_FX(0.1), WIDTH, HEIGHT);
    return b;
}

static tp_fx clamped(tp_fx x, tp_fx scale)
{
    const int64_t m = ((int64_t)x * scale + 0x8000) >> 16, most = 4000 * TP_FX_ONE;
    return (tp_fx)(m > most ? most : m < -most ? -most : m);
}

static void assert_projected(const tp_boat_view *b, const tp_view_plane *plane,
                             const tp_boat_vertex *got, uint32_t i)
{
    const tp_vec3 at = vertex[i].position;
    tp_view_vertex c;
    tp_boat_vertex want = { .u = TP_GRID_NEEDS_CLIP };

    tp_projection_view_vertex(&b->projection,
                              (tp_vec3){ clamped(at.x, b->metres), clamped(at.y, b->metres),
                                         clamped(at.z, b->metres) }, &c);
    if (plane && tp_view_plane_distance(plane, &c) < 0)
        want.u = TP_BOAT_OUTSIDE;
    else if (tp_projection_can_project(&b->projection, &c))
        tp_projection_project(&b->projection, &c, &want.u, &want.v, &want.zi);
    assert_int_equal(got->u, want.u);
    if (want.u > TP_BOAT_OUTSIDE) {
        assert_int_equal(got->v, want.v);
        assert_int_equal(got->zi, want.zi);
    }
}

static void vertices_are_projected_alike_near_and_far(void **state)
{
    static const tp_fx scale[] = { 655, TP_FX_ONE, 40 * TP_FX_ONE, 30000 * TP_FX_ONE };
    static const tp_fx far[] = { TP_FX(3), TP_FX(200), 12000 * TP_FX_ONE,
                                 23000 * TP_FX_ONE };
    tp_boat_vertex got[VERTICES];

    (void)state;
    for (int n = 0; n < 400; n++) {
        make_mesh(TP_FX(3));
        const tp_boat_view b = make_view(scale[n % 4], far[n / 4 % 4]);
        const tp_view_plane level = tp_projection_level_plane(&b.projection, 0, 1);
        const tp_view_plane *plane = n % 3 ? &level : NULL;
        tp_boat_project_vertices(&b, plane, got);
        for (uint32_t i = 0; i < VERTICES; i++)
            assert_projected(&b, plane, &got[i], i);
    }
}

/* True if a face alone draws a pixel of the tile. */
static bool draws(const tp_boat_view *b, const tp_view_plane *plane, uint32_t f,
                  test_tile *tile)
{
    tp_screen_vertex corner[TP_CLIP_VERTICES];
    const int count = tp_boat_clip_face(b, plane, f, corner);
    bool any = false;

    tp_gbuffer_clear(&tile->samples);
    tile->samples.front_only = true;
    for (int k = 2; k < count; k++)
        tp_tri_solid(&tile->samples, &corner[0], &corner[k - 1], &corner[k], 2, f, 16);
    for (size_t i = 0; i < tile->words; i++)
        any = any || tile->samples.key[i];
    return any;
}

static bool is_listed(const tp_boat_faces *faces, const tp_gbuffer *tile, uint32_t f)
{
    const tp_boat_rows rows = tp_boat_rows_find(faces, tile);
    const uint32_t range[2][2] = { { 0, faces->count }, { faces->lids, faces->end } };

    for (int r = 0; r < 2; r++)
        for (uint32_t i = range[r][0];
             (i = tp_boat_faces_next(faces, i, range[r][1], rows, TP_FACE_FILLS))
             < range[r][1]; i++)
            if (tp_boat_face_number(faces, faces->entry[i]) == f)
                return true;
    return false;
}

/* Lists the faces of a view, as the boat's drawing does. */
static void list(const tp_boat_view *b, const tp_view_plane *plane, tp_boat_faces *faces)
{
    tp_boat_vertex at[VERTICES];
    tp_screen_vertex corner[TP_CLIP_VERTICES];

    tp_boat_project_vertices(b, plane, at);
    tp_boat_faces_list(faces, &mesh, at, NULL);
    for (uint32_t i = 0; i < faces->end; i++)
        if ((i < faces->count || i >= faces->lids) && faces->entry[i] & TP_FACE_CUT) {
            const uint32_t f = tp_boat_face_number(faces, faces->entry[i]);
            tp_boat_faces_set_polygon(faces, i, corner,
                                      tp_boat_clip_face(b, plane, f, corner));
        }
    tp_boat_faces_set_blocks(faces);
}

static void a_face_is_listed_where_it_draws(void **state)
{
    static _Alignas(8) uint8_t block[8192];
    uint32_t drawn = 0, skipped = 0;

    (void)state;
    for (int n = 0; n < 30; n++) {
        tp_arena arena = tp_arena_init(block, sizeof block);
        tp_boat_faces faces = tp_boat_faces_layout(&arena, FACES, HEIGHT);
        make_mesh(TP_FX(3));
        const tp_boat_view b = make_view(TP_FX_ONE, TP_FX(5));
        const tp_view_plane level = tp_projection_level_plane(&b.projection, 0, 1);
        const tp_view_plane *plane = n % 3 ? &level : NULL;
        list(&b, plane, &faces);
        for (int32_t y = 0; y < HEIGHT; y += BAND) {
            test_tile tile = tile_of(0, y, WIDTH, y + BAND, 0);
            for (uint32_t f = 0; f < FACES; f++) {
                const bool listed = is_listed(&faces, &tile.samples, f),
                           draws_here = draws(&b, plane, f, &tile);
                assert_true(listed || !draws_here);
                drawn += draws_here;
                skipped += !listed;
            }
            tile_free(&tile);
        }
    }
    assert_true(drawn > 100 && skipped > 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vertices_are_projected_alike_near_and_far),
        cmocka_unit_test(a_face_is_listed_where_it_draws),
    };
    chance = random_seed();
    return cmocka_run_group_tests_name("features_boat_projection", tests, NULL, NULL);
}
