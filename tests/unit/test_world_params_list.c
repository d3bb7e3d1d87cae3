/* SPDX-License-Identifier: MIT */
/* The table of parameters as listed in tests/golden/params.txt: unit, range and default of
 * each row; and the constant for each word of a choice. */
#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>
#include "tests/lib/listing.h"
#include "world/text.h"

static listing listed;

/* Writes "fx m, -8000 to 8000, 0": kind, unit, range, default; names have no range. */
static void tell(const tp_param *row, char *to, size_t bytes)
{
    static const char *const kinds[] = {
        [TP_PARAM_FX] = "fx", [TP_PARAM_INT] = "int", [TP_PARAM_BOOL] = "bool",
        [TP_PARAM_COLOUR] = "colour", [TP_PARAM_CHOICE] = "choice",
        [TP_PARAM_MESH] = "mesh", [TP_PARAM_TEXTURE] = "texture",
        [TP_PARAM_GREY] = "grey", [TP_PARAM_TEXT] = "text",
    };
    const int32_t numbers[] = { row->low, row->high, row->normal };
    char text[3][TP_NAME_BYTES];
    tp_scene scene;

    tp_scene_level(&scene);
    for (int i = 0; i < 3 && !tp_param_is_text(row); i++) {
        memcpy((char *)&scene + row->offset, &numbers[i], sizeof numbers[i]);
        tp_param_text(&scene, row, text[i], sizeof text[i]);
    }
    if (tp_param_is_text(row))
        snprintf(to, bytes, "%s \"%s\"", kinds[row->kind], row->text);
    else
        snprintf(to, bytes, "%s%s%s, %s to %s, %s", kinds[row->kind],
                 row->unit[0] ? " " : "", row->unit, text[0], text[1], text[2]);
}

static void every_row_is_the_listed_one(void **state)
{
    uint32_t count, wrong = 0;
    const tp_param *rows = tp_params(&count);

    (void)state;
    assert_true(count <= LISTING_MOST);
    for (uint32_t i = 0; i < count; i++) {
        char values[LISTING_VALUES];
        tell(&rows[i], values, sizeof values);
        wrong += !listing_holds(&listed, i, rows[i].name, values);
    }
    wrong += listed.count != count;
    listed.count = count;
    listing_write(&listed);
    assert_true(wrong == 0 || listed.write);
}

/* -- words --------------------------------------------------------------------------- */

static const struct {
    const char *name, *word;
    int32_t     number;
} words[] = {
    { "camera.follow", "none", TP_FOLLOW_NONE },
    { "camera.follow", "boat", TP_FOLLOW_BOAT },
    { "light.model", "phong", TP_LIGHT_PHONG },
    { "light.model", "blinn", TP_LIGHT_BLINN },
    { "sky.kind", "gradient", TP_SKY_GRADIENT },
    { "sky.kind", "day", TP_SKY_DAY },
    { "sky.kind", "dusk", TP_SKY_DUSK },
    { "sky.kind", "night", TP_SKY_NIGHT },
    { "sky.kind", "cube", TP_SKY_CUBE },
    { "hdr.exposure", "fixed", TP_EXPOSURE_FIXED },
    { "hdr.exposure", "auto", TP_EXPOSURE_AUTO },
    { "water.filter", "nearest", TP_FILTER_NEAREST },
    { "water.filter", "linear", TP_FILTER_LINEAR },
    { "water.fresnel", "table", TP_FRESNEL_TABLE },
    { "water.fresnel", "schlick", TP_FRESNEL_SCHLICK },
    { "mirror.method", "none", TP_MIRROR_NONE },
    { "mirror.method", "stencil", TP_MIRROR_STENCIL },
    { "mirror.method", "cube", TP_MIRROR_CUBE },
    { "mirror.size", "half", TP_MIRROR_HALF },
    { "mirror.size", "quarter", TP_MIRROR_QUARTER },
    { "mirror.size", "full", TP_MIRROR_FULL },
    { "mirror.colours", "rgb888", TP_MIRROR_RGB888 },
    { "mirror.colours", "rgb565", TP_MIRROR_RGB565 },
    { "pool.cell_bits", "8", TP_CELLS_8 },
    { "pool.cell_bits", "16", TP_CELLS_16 },
    { "pool.cell_bits", "32", TP_CELLS_32 },
    { "pool.interval", "1", 0 },
    { "pool.interval", "2", 1 },
    { "pool.interval", "4", 2 },
    { "pool.boundary", "wall", TP_EDGES_WALL },
    { "pool.boundary", "sponge", TP_EDGES_SPONGE },
    { "pool.boundary", "tile", TP_EDGES_TILE },
    { "field.cell_bits", "8", TP_CELLS_8 },
    { "field.cell_bits", "16", TP_CELLS_16 },
    { "field.cell_bits", "32", TP_CELLS_32 },
    { "field.interval", "1", 0 },
    { "field.interval", "2", 1 },
    { "field.interval", "4", 2 },
    { "field.boundary", "wall", TP_EDGES_WALL },
    { "field.boundary", "sponge", TP_EDGES_SPONGE },
    { "field.boundary", "tile", TP_EDGES_TILE },
    { "tank.kind", "none", TP_TANK_NONE },
    { "tank.kind", "stone", TP_TANK_STONE },
    { "tank.kind", "glass", TP_TANK_GLASS },
    { "drops.target", "rings", TP_DROPS_RINGS },
    { "drops.target", "pool", TP_DROPS_POOL },
    { "boat.mode", "kinematic", TP_BOAT_KINEMATIC },
    { "boat.mode", "dynamic", TP_BOAT_DYNAMIC },
    { "boat.edges", "plain", TP_EDGES_PLAIN },
    { "boat.edges", "smooth", TP_EDGES_SMOOTH },
    { "quality.visibility", "auto", TP_VISIBILITY_AUTO },
    { "quality.visibility", "triangles", TP_VISIBILITY_TRIANGLES },
    { "quality.visibility", "rows", TP_VISIBILITY_ROWS },
    { "quality.visibility", "projected", TP_VISIBILITY_PROJECTED },
    { "quality.visibility", "flat", TP_VISIBILITY_FLAT },
    { "quality.visibility", "walk", TP_VISIBILITY_WALK },
    { "quality.shading", "auto", TP_SHADING_AUTO },
    { "quality.shading", "exact", TP_SHADING_EXACT },
    { "quality.shading", "quick", TP_SHADING_QUICK },
    { "quality.rate", "auto", TP_RATE_AUTO },
    { "quality.rate", "full", TP_RATE_FULL },
    { "quality.rate", "layers", TP_RATE_LAYERS },
    { "quality.rate", "colour", TP_RATE_COLOUR },
    { "quality.sky", "auto", TP_RUNG_AUTO },
    { "quality.sky", "exact", TP_RUNG_EXACT },
    { "quality.sky", "fast", TP_RUNG_FAST },
    { "quality.haze", "auto", TP_RUNG_AUTO },
    { "quality.haze", "exact", TP_RUNG_EXACT },
    { "quality.haze", "fast", TP_RUNG_FAST },
    { "quality.layers", "auto", TP_RUNG_AUTO },
    { "quality.layers", "exact", TP_RUNG_EXACT },
    { "quality.layers", "nearest", TP_RUNG_FAST },
    { "quality.distortion", "auto", TP_RUNG_AUTO },
    { "quality.distortion", "exact", TP_RUNG_EXACT },
    { "quality.distortion", "nearest", TP_RUNG_FAST },
    { "quality.ripple", "auto", TP_RUNG_AUTO },
    { "quality.ripple", "exact", TP_RUNG_EXACT },
    { "quality.ripple", "nearest", TP_RUNG_FAST },
    { "quality.light", "auto", TP_RUNG_AUTO },
    { "quality.light", "exact", TP_RUNG_EXACT },
    { "quality.light", "fast", TP_RUNG_FAST },
    { "quality.foam", "auto", TP_RUNG_AUTO },
    { "quality.foam", "exact", TP_RUNG_EXACT },
    { "quality.foam", "fast", TP_RUNG_FAST },
    { "quality.foam", "plain", 3 },
    { "quality.objects", "auto", TP_RUNG_AUTO },
    { "quality.objects", "exact", TP_RUNG_EXACT },
    { "quality.objects", "fast", TP_RUNG_FAST },
    { "quality.refraction", "auto", TP_RUNG_AUTO },
    { "quality.refraction", "exact", TP_RUNG_EXACT },
    { "quality.refraction", "fast", TP_RUNG_FAST },
    { "quality.caustics", "auto", TP_RUNG_AUTO },
    { "quality.caustics", "exact", TP_RUNG_EXACT },
    { "quality.caustics", "half", TP_RUNG_FAST },
    { "quality.caustics", "quarter", 3 },
    { "quality.solids", "auto", TP_RUNG_AUTO },
    { "quality.solids", "exact", TP_RUNG_EXACT },
    { "quality.solids", "fast", TP_RUNG_FAST },
    { "quality.mesh", "auto", TP_MESH_AUTO },
    { "quality.mesh", "full", TP_MESH_FULL },
    { "quality.mesh", "middle", TP_MESH_MIDDLE },
    { "quality.mesh", "low", TP_MESH_LOW },
    { "quality.triangles", "auto", TP_RUNG_AUTO },
    { "quality.triangles", "exact", TP_RUNG_EXACT },
    { "quality.triangles", "fast", TP_RUNG_FAST },
    { "quality.lines", "auto", TP_RUNG_AUTO },
    { "quality.lines", "all", TP_RUNG_EXACT },
    { "quality.lines", "half", TP_RUNG_FAST },
    { "quality.rows", "auto", TP_RUNG_AUTO },
    { "quality.rows", "exact", TP_RUNG_EXACT },
    { "quality.rows", "fast", TP_RUNG_FAST },
    { "quality.rows", "pairs", TP_RUNG_PAIRS },
    { "quality.waves", "auto", TP_RUNG_AUTO },
    { "quality.waves", "exact", TP_RUNG_EXACT },
    { "quality.waves", "fast", TP_RUNG_FAST },
    { "quality.blending", "auto", TP_RUNG_AUTO },
    { "quality.blending", "exact", TP_RUNG_EXACT },
    { "quality.blending", "rgb565", TP_RUNG_FAST },
    { "quality.geometry", "auto", TP_RUNG_AUTO },
    { "quality.geometry", "all", TP_RUNG_EXACT },
    { "quality.geometry", "large", TP_RUNG_FAST },
    { "quality.geometry", "largest", 3 },
    { "quality.normals", "auto", TP_RUNG_AUTO },
    { "quality.normals", "exact", TP_RUNG_EXACT },
    { "quality.normals", "fast", TP_RUNG_FAST },
    { "quality.sine", "auto", TP_RUNG_AUTO },
    { "quality.sine", "exact", TP_RUNG_EXACT },
    { "quality.sine", "fast", TP_RUNG_FAST },
    { "quality.spray", "auto", TP_RUNG_AUTO },
    { "quality.spray", "exact", TP_RUNG_EXACT },
    { "quality.spray", "fast", TP_RUNG_FAST },
    { "quality.dispersion", "auto", TP_RUNG_AUTO },
    { "quality.dispersion", "exact", TP_RUNG_EXACT },
    { "quality.dispersion", "fast", TP_RUNG_FAST },
    { "quality.dispersion", "off", TP_DISPERSION_OFF },
    { "quality.exposure", "auto", TP_RUNG_AUTO },
    { "quality.exposure", "exact", TP_RUNG_EXACT },
    { "quality.exposure", "fast", TP_RUNG_FAST },
    { "quality.board", "none", TP_BOARD_none },
#define X(name) { "quality.board", #name, TP_BOARD_##name },
    TP_BOARD_LIST(X)
#undef X
};

enum { WORDS = sizeof words / sizeof words[0] };

static void words_stand_for_their_constants(void **state)
{
    (void)state;
    for (int i = 0; i < WORDS; i++) {
        const tp_param *row = tp_param_find(words[i].name, strlen(words[i].name));
        tp_scene scene;
        int32_t number;

        tp_scene_level(&scene);
        assert_non_null(row);
        assert_int_equal(row->kind, TP_PARAM_CHOICE);
        assert_int_equal(tp_param_set(&scene, row, words[i].word, strlen(words[i].word),
                                      NULL), TP_OK);
        memcpy(&number, (char *)&scene + row->offset, sizeof number);
        assert_int_equal(number, words[i].number);
    }
}

/* The lists above and those of the rows are as long as the ranges. */
static void every_choice_has_a_word_for_each_of_its_numbers(void **state)
{
    uint32_t count;
    const tp_param *rows = tp_params(&count);

    (void)state;
    for (uint32_t i = 0; i < count; i++) {
        int listed_here = 0, in_unit = 1;
        if (rows[i].kind != TP_PARAM_CHOICE)
            continue;
        for (const char *c = rows[i].unit; *c; c++)
            in_unit += *c == '|';
        for (int k = 0; k < WORDS; k++)
            listed_here += !strcmp(words[k].name, rows[i].name);
        assert_int_equal(rows[i].low, 0);
        assert_int_equal(rows[i].high, in_unit - 1);
        if (listed_here != in_unit)
            fail_msg("%s has %d words here, %d in its row", rows[i].name, listed_here,
                     in_unit);
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_row_is_the_listed_one),
        cmocka_unit_test(words_stand_for_their_constants),
        cmocka_unit_test(every_choice_has_a_word_for_each_of_its_numbers),
    };

    listing_read(&listed, "tests/golden/params.txt", argc, argv);
    return cmocka_run_group_tests_name("world/params_list", tests, NULL, NULL);
}
