/* SPDX-License-Identifier: MIT */
/* Checks a scene that a program has filled in: each row against its range, then the
 * combinations of rows.  A scene from a file is set row by row through tp_param_set, and
 * tp_param_set checks the same ranges. */
#include "base/base.h"
#include "base/fail.h"
#include "base/given.h"
#include "scene/world_parts.h"
#include "scene/string_view.h"
#include "scene/pools.h"
#include "scene/value.h"

static tp_status check_number(const tp_scene *scene, const tp_param *row, tp_error *err)
{
    int32_t number;

    memcpy(&number, (const char *)scene + row->offset, sizeof number);
    if (number >= row->low && number <= row->high)
        return TP_OK;
    return tp_error_blame(err, TP_FAIL(err, TP_E_RANGE, 0, row->low, row->high),
                          row->name);
}

static tp_status check_name(const tp_scene *scene, const tp_param *row, tp_error *err)
{
    const char *const name = (const char *)scene + row->offset;
    size_t bytes = 0;

    while (bytes < TP_NAME_BYTES && name[bytes] != '\0')
        bytes++;
    if (bytes == TP_NAME_BYTES)
        return tp_error_blame(err, TP_FAIL(err, TP_E_UNENDED, 0, TP_NAME_BYTES, 0),
                              row->name);
    if (tp_string_view_has_control((tp_string_view){ name, bytes }))
        return tp_error_blame(err, TP_FAIL(err, TP_E_TEXT, 0, 0, 0), row->name);
    return TP_OK;
}

tp_status tp_program_check(const tp_program *program, const tp_scene *scene,
                           tp_error *err)
{
    tp_status status = tp_given_check(scene, "scene", err);

    if (status == TP_OK && program->check != NULL)
        status = program->check(scene, err);
    return status;
}

tp_status tp_scene_check(const tp_scene *scene, tp_error *err)
{
    uint32_t count;
    const tp_param *const rows = tp_params(&count);

    tp_status status = tp_given_check(scene, "scene", err);

    for (uint32_t i = 0; i < count && status == TP_OK; i++)
        status = tp_param_is_text(&rows[i]) ? check_name(scene, &rows[i], err)
                                            : check_number(scene, &rows[i], err);
    for (int field = 0; field < 2 && status == TP_OK; field++)
        status = tp_pools_check(scene, NULL, field, err);
    return status;
}
