/* SPDX-License-Identifier: MIT */
/*
 * Phong shading of 16 samples of a mesh for vectorizing compilers, with the bits of
 * boat_stage.c's loop: a part of that file.  Texels, tangents, lengths of normals and the
 * lobe's table are read one sample after another, the rest are loops over all samples.
 */
#ifndef TP_FEATURES_BOAT_BOAT_WIDE_H
#define TP_FEATURES_BOAT_BOAT_WIDE_H

/* x, y, z: normals; bent, tangent: texels of the normal map, and tangents.  bright: share
 * of light; lit: mask of surfaces that face the light; at, part: place in the lobe's table;
 * here, next: its entries. */
typedef struct {
    int32_t  x[16], y[16], z[16];
    uint32_t diffuse[16], bent[16], tangent[16], bright[16];
    int32_t  lit[16], at[16], part[16], here[16], next[16];
} solid_columns;

/* Fills the texels of `count` samples from sample i on. */
TP_ALWAYS_INLINE void fetch_columns(const tp_boat_shading *shading, const tp_solid *solid,
                                    const tp_shade *shade, const tp_run *run, int32_t i,
                                    int32_t count, solid_columns *to)
{
    const tp_texture *picture = solid->diffuse_map, *normals = solid->normal_map;

    for (int32_t k = 0; k < count; k++) {
        const int32_t  depth = tp_log_depth(shade, run->key[i + k]);
        const uint32_t st = run->s[i + k];
        to->diffuse[k] = solid->diffuse;
        if (picture) {
            int level = tp_mip_level_choose(solid->lod, depth, false, picture->levels);
            to->diffuse[k] =
                tp_colour_times(fetch_texel(picture, level, st), solid->diffuse);
        }
        if (normals) {
            int level = tp_mip_level_choose(solid->lod, depth, false, normals->levels);
            to->bent[k] = fetch_texel(normals, level, st);
            to->tangent[k] = shading->mesh->faces[run->t[i + k]].tangent;
        }
    }
}

/* Bends the normals n by the fetched texels. */
TP_ALWAYS_INLINE void bend_normals(const uint32_t *restrict n, int32_t bump, int32_t count,
                                   solid_columns *restrict to)
{
    for (int32_t k = 0; k < count; k++) {
        const vec bent = bend_normal(unpack_dir_q14(n[k]), bump, to->bent[k],
                                     to->tangent[k]);
        to->x[k] = bent.x;
        to->y[k] = bent.y;
        to->z[k] = bent.z;
    }
}

TP_ALWAYS_INLINE void set_unit_normals(const uint32_t *n, bool bent, int32_t count,
                                       solid_columns *to)
{
    for (int32_t k = 0; k < count; k++) {
        const vec unit = bent ? tp_vec_q14_unit(to->x[k], to->y[k], to->z[k])
                              : tp_vec_q14_unpack(n[k]);
        to->x[k] = unit.x;
        to->y[k] = unit.y;
        to->z[k] = unit.z;
    }
}

TP_ALWAYS_INLINE void light_columns(const tp_view_axes *axes, int32_t ambient,
                                    const tp_run *run, int32_t i, int32_t count,
                                    solid_columns *restrict to)
{
    const vec light = { axes->lx, axes->ly, axes->lz };

    for (int32_t k = 0; k < count; k++) {
        const vec n = { to->x[k], to->y[k], to->z[k] };
        const vec v = { run->vx[i + k], run->vy[i + k], run->vz[i + k] };
        const int32_t nl = tp_clamp(tp_vec_q14_dot(n, light), 0, 16384);
        const int32_t rv = tp_clamp(
            tp_lobe_table_cosine(nl, tp_vec_q14_dot(n, v), run->lv[i + k], 0), 0, 16384);
        const int32_t at = rv * (TP_GLOSS - 1);
        to->bright[k] = (uint32_t)tp_lit_share(ambient, nl);
        to->lit[k] = -(int32_t)(nl > 0);
        to->at[k] = at >> 14;
        to->part[k] = (at & 16383) >> 6;
    }
}

TP_ALWAYS_INLINE void read_gloss(const uint8_t *gloss, int32_t count, solid_columns *to)
{
    for (int32_t k = 0; k < count; k++) {
        const int32_t at = to->at[k];
        to->here[k] = gloss[at];
        to->next[k] = gloss[at + 1 < TP_GLOSS ? at + 1 : at];
    }
}

TP_ALWAYS_INLINE void mix_columns(uint32_t shine, const solid_columns *from, int32_t count,
                                  uint32_t *restrict colour)
{
    for (int32_t k = 0; k < count; k++) {
        const int32_t here = from->here[k], rise = from->next[k] - here;
        const int32_t gloss = (here + (rise * from->part[k] >> 8)) & from->lit[k];
        colour[k] = tp_colour_add(tp_colour_scale(from->diffuse[k], from->bright[k]),
                                  tp_colour_scale(shine, (uint32_t)gloss));
    }
}

/* Shades `count` samples from sample i on, at most 16. */
TP_ALWAYS_INLINE void solid_columns_wide(const tp_shade *shade, tp_run *run, int32_t i,
                                         int32_t count)
{
    const tp_boat_shading *shading = run->mine;
    const tp_solid *solid = &shading->solid[run->material];
    solid_columns columns;

    fetch_columns(shading, solid, shade, run, i, count, &columns);
    if (solid->normal_map)
        bend_normals(run->n + i, solid->bump, count, &columns);
    set_unit_normals(run->n + i, solid->normal_map != NULL, count, &columns);
    light_columns(&shading->axes, shade->ambient, run, i, count, &columns);
    read_gloss(solid->gloss, count, &columns);
    mix_columns(tp_colour_times(solid->specular, shade->light_colour), &columns, count,
                run->colour + i);
}
#endif
