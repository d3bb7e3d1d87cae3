/* SPDX-License-Identifier: MIT */
/*
 * Checks of data from outside the program: a scene that a program has filled in, and a
 * world stored in a file.
 *
 * A scene: each row against its range, then the combinations of rows.  A scene from a
 * file is set row by row through tp_param_set, and tp_param_set checks the same ranges.
 *
 * A world: no byte is trusted, neither offsets and counts nor truth values, compared as
 * bytes.  Layout, deep water, floor and tables follow from the scene, so they must equal a
 * fresh world of the same scene.  State changed by ticks is checked by the file that owns
 * the state.
 */
#include "base/base.h"
#include "world/light.h"
#include "world/module.h"
#include "world/pools.h"
#include "world/text.h"
#include "world/world.h"

/* -- a scene ------------------------------------------------------------------------- */

static tp_status check_number(const tp_scene *scene, const tp_param *row, tp_error *err)
{
    int32_t number;

    memcpy(&number, (const char *)scene + row->offset, sizeof number);
    if (number >= row->low && number <= row->high)
        return TP_OK;
    return tp_error_add_word(err, TP_FAIL(err, TP_E_RANGE, 0, row->low, row->high),
                             row->name);
}

static tp_status check_text_value(const tp_scene *scene, const tp_param *row, tp_error *err)
{
    const char *const name = (const char *)scene + row->offset;
    size_t bytes = 0;

    while (bytes < TP_NAME_BYTES && name[bytes] != '\0')
        bytes++;
    if (bytes == TP_NAME_BYTES)
        return tp_error_add_word(err, TP_FAIL(err, TP_E_UNENDED, 0, TP_NAME_BYTES, 0),
                                 row->name);
    if (tp_string_view_has_control((tp_string_view){ name, bytes }))
        return tp_error_add_word(err, TP_FAIL(err, TP_E_TEXT, 0, 0, 0), row->name);
    return TP_OK;
}

tp_status tp_program_check_scene(const tp_program *program, const tp_scene *scene,
                                 tp_error *err)
{
    tp_status status = tp_pointer_check(scene, "scene", err);

    if (status == TP_OK && program->check != NULL)
        status = program->check(scene, err);
    return status;
}

tp_status tp_scene_check(const tp_scene *scene, tp_error *err)
{
    uint32_t count;
    const tp_param *const rows = tp_params(&count);

    tp_status status = tp_pointer_check(scene, "scene", err);

    for (uint32_t i = 0; i < count && status == TP_OK; i++)
        status = tp_param_is_text(&rows[i]) ? check_text_value(scene, &rows[i], err)
                                            : check_number(scene, &rows[i], err);
    for (int field = 0; field < 2 && status == TP_OK; field++)
        status = tp_pools_check(scene, NULL, field, err);
    return status;
}

/* -- a stored world ------------------------------------------------------------------ */

#define TICKS_MOST ((uint64_t)1 << 40)  /* 580 years; times in ticks x 65536 fit 64 bits */

/* True if the camera's frame of reference is possible: a deck camera may have left the
 * deck. */
static bool is_aboard_valid(const tp_world *world, const tp_world *fresh)
{
    return world->aboard == fresh->aboard
           || (fresh->aboard != TP_ABOARD_NOT && world->aboard == TP_ABOARD_LEFT);
}

static bool is_head_valid(const tp_world *world, const tp_world *fresh)
{
    return world->tick <= TICKS_MOST && world->lag >= 0 && world->lag <= TP_FX_ONE
           && is_aboard_valid(world, fresh)
           && world->boat_state.placed == fresh->boat_state.placed
           && (fresh->boat_state.placed
               || memcmp(&world->boat, &fresh->boat, 2 * sizeof fresh->boat) == 0);
}

/* Compares bytes, without the padding that the compiler inserts between members. */
static bool is_same_deep_water(const tp_deep_water *deep, const tp_deep_water *fresh)
{
    bool same =
        memcmp(deep, fresh, offsetof(tp_deep_water, crossed) + sizeof fresh->crossed)
        == 0;

    for (uint32_t i = 0; same && i < fresh->count; i++)
        same = memcmp(&deep->swell[i], &fresh->swell[i],
                      offsetof(tp_swell, mean_q24) + sizeof(int32_t)) == 0;
    return same;
}

/* Returns the first invalid part, or NULL. Both blocks have the same layout. */
static const char *find_invalid(const tp_program *program, const tp_world *world,
                                const tp_world *fresh)
{
    return !is_head_valid(world, fresh)        ? "head"
           : !tp_camera_is_valid(world)        ? "camera"
           : !tp_light_is_valid(world)         ? "light"
           : !tp_clock_is_valid(&world->clock) ? "clock"
           : !is_same_deep_water(&world->deep, &fresh->deep)
               ? "sea"
               : tp_modules_find_invalid(program, world, fresh);
}

tp_status tp_world_check(const tp_program *program, const tp_world *world, size_t bytes,
                         const tp_world *fresh, tp_error *err)
{
    const char *invalid = "layout";
    tp_status status = tp_pointer_check_aligned(world, 8, "world", err);

    if (status == TP_OK)
        status = tp_pointer_check_aligned(fresh, 8, "fresh", err);
    if (status != TP_OK)
        return status;
    if (bytes >= offsetof(tp_world, layout) + sizeof fresh->layout
        && world->layout.version != fresh->layout.version)
        invalid = "version";
    else if (bytes >= fresh->layout.bytes
             && memcmp(&world->layout, &fresh->layout, sizeof fresh->layout) == 0)
        invalid = find_invalid(tp_program_or_linked(program), world, fresh);
    return invalid ? tp_error_add_word(err, TP_FAIL(err, TP_E_WORLD, 0, 0, 0), invalid)
                   : TP_OK;
}
