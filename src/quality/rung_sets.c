/* SPDX-License-Identifier: MIT */
/* The kinds of a set of rungs, and the rows of a scene that name them. */
#include "quality/rung_sets.h"
#include "base/base.h"
#include "world/pools.h"

/* A kind: its row, the place of its number in a scene, and the number of its rungs. */
typedef struct {
    const char *row;
    uint16_t    at;
    uint8_t     count;
} kind;

#define AT(member) (uint16_t)offsetof(tp_scene, member)

static const kind kind_table[TP_RUNG_KINDS] = {
    [TP_KIND_VISIBILITY] = { "quality.visibility", AT(quality.visibility),
                             TP_VISIBILITIES },
    [TP_KIND_SHADING]    = { "quality.shading", AT(quality.shading), TP_SHADINGS },
    [TP_KIND_RATE]       = { "quality.rate", AT(quality.rate), TP_RATES },
#define X(name, words, last, help) \
    [TP_KIND_##name] = { "quality." #name, AT(quality.name), last },
    TP_EFFECT_LIST(X)
#undef X
    [TP_KIND_mirror_size] = { "mirror.size", AT(mirror.size), 2 },
    [TP_KIND_vertices]    = { "grid.vertices", AT(grid.vertices), 4 },
};

uint32_t tp_rung_kind_count(int of)
{
    TP_ASSERT(of >= 0 && of < TP_RUNG_KINDS);
    return kind_table[of].count;
}

const char *tp_rung_kind_row(int of)
{
    TP_ASSERT(of >= 0 && of < TP_RUNG_KINDS);
    return kind_table[of].row;
}

static int32_t *number_place(tp_scene *scene, int of)
{
    return (int32_t *)(void *)((uint8_t *)scene + kind_table[of].at);
}

void tp_rung_set_apply_some(tp_scene *scene, const tp_rung_set *set, uint32_t kinds)
{
    const uint8_t *of = set->of;

    for (int k = 0; k < TP_KIND_mirror_size; k++)
        if (kinds >> k & 1)
            *number_place(scene, k) = of[k] + 1;
    if (kinds >> TP_KIND_mirror_size & 1 && of[TP_KIND_mirror_size])
        scene->mirror.size = TP_MIRROR_QUARTER;
    if (kinds >> TP_KIND_vertices & 1 && of[TP_KIND_vertices])
        scene->grid.vertices = (int32_t)(tp_fan_budget(scene) >> of[TP_KIND_vertices]);
}

void tp_rung_set_apply(tp_scene *scene, const tp_rung_set *set)
{
    /* Walk has no price; a scene that names it keeps it. */
    const bool walks = scene->quality.visibility == TP_VISIBILITY_WALK;

    tp_rung_set_apply_some(scene, set, walks ? ~(1u << TP_KIND_VISIBILITY) : UINT32_MAX);
}

tp_rung_set tp_rung_set_named(const tp_scene *scene, bool drawing_rows, uint32_t *open)
{
    tp_rung_set set = { .of = { 0 } };

    *open = drawing_rows ? 1u << TP_KIND_vertices : 0;
    if (drawing_rows && scene->mirror.size != TP_MIRROR_QUARTER)
        *open |= 1u << TP_KIND_mirror_size;
    for (int k = 0; k < TP_KIND_mirror_size; k++) {
        const int32_t named =
            *(const int32_t *)(const void *)((const uint8_t *)scene + kind_table[k].at);
        if (named == 0)
            *open |= 1u << k;
        else if (named <= kind_table[k].count)       /* walk has no price: as triangles */
            set.of[k] = (uint8_t)(named - 1);
    }
    return set;
}
