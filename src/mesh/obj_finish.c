/* SPDX-License-Identifier: MIT */
/* The last step of the OBJ reader: names the libraries and images for the caller,
 * assigns the textures to the materials, and hands out the mesh. */
#include "base/base.h"
#include "fixed/arithmetic.h"
#include "mesh/obj.h"

const char *tp_obj_library(const tp_obj *obj, uint32_t i)
{
    TP_ASSERT(i < obj->libraries);
    return tp_names_text(&obj->store.library_names, i);
}

uint32_t tp_obj_library_line(const tp_obj *obj, uint32_t i)
{
    TP_ASSERT(i < obj->libraries);
    return obj->store.library_names.line[i];
}

const char *tp_obj_image(const tp_obj *obj, uint32_t i)
{
    TP_ASSERT(i < obj->images);
    return tp_names_text(&obj->store.image_names, i);
}

uint32_t tp_obj_image_library(const tp_obj *obj, uint32_t i)
{
    TP_ASSERT(i < obj->images);
    return obj->store.image_names.tag[i];
}

uint32_t tp_obj_image_line(const tp_obj *obj, uint32_t i)
{
    TP_ASSERT(i < obj->images);
    return obj->store.image_names.line[i];
}

/* -- texels per unit ----------------------------------------------------------------- */

/* Shifts x != 0 until its top bit is bit 31.  Returns the exponent: x was
 * larger by 2^exponent. */
static int normalise_mantissa(uint64_t *x)
{
    TP_ASSERT(*x != 0);
    int shift = 0;
    for (; *x >> 32 != 0; shift++)
        *x >>= 1;
    for (; *x >> 31 == 0; shift--)
        *x <<= 1;
    return shift;
}

/* Returns sqrt(picture / area x 2^power) in 16.16, saturating; relative error < 2^-15. */
static tp_fx scaled_ratio_sqrt(uint64_t picture, uint64_t area, int power)
{
    if (picture == 0 || area == 0)
        return 0;
    power += normalise_mantissa(&picture);
    power -= normalise_mantissa(&area);
    uint64_t ratio = (picture << 31) / area;    /* 2^30..2^32, in units of 2^-31 */
    power += 1;                                 /* + 32 for 16.16, - 31 */
    if (power % 2 != 0) {
        ratio *= 2;
        power -= 1;
    }
    for (; power < 0 && ratio != 0; power += 2)
        ratio >>= 2;
    for (; power > 0 && ratio < (uint64_t)1 << 62; power -= 2)
        ratio <<= 2;
    const uint32_t root = power > 0 ? UINT32_MAX : tp_isqrt64(ratio);
    return root > TP_FX_MAX ? TP_FX_MAX : (tp_fx)root;
}

/* Both sums are twice an area.  `area` is in 2^-32 of squared mesh units, `picture` in
 * 2^-32 of squared texture repeats; each sum is divided by 2^shift. */
static tp_fx texels_per_unit(const tp_obj *obj, const struct tp_obj_made *made,
                             const tp_texture *texture)
{
    if (texture == NULL)
        return 0;
    return scaled_ratio_sqrt(made->picture, made->area,
                         texture->log2_w + texture->log2_h
                         + (int)obj->picture_shift - (int)obj->area_shift);
}

/* -- materials ----------------------------------------------------------------------- */

static const tp_texture *image_texture(const tp_texture *const *textures, uint32_t image)
{
    return textures == NULL || image == TP_NO_NAME ? NULL : textures[image];
}

static void bind_material(const tp_obj *obj, const tp_texture *const *textures,
                          uint32_t i)
{
    const struct tp_obj_made *const made = &obj->store.made[i];
    tp_material *const material = &obj->store.materials[i];
    material->diffuse_map = image_texture(textures, made->map[TP_MAP_DIFFUSE]);
    material->normal_map = image_texture(textures, made->map[TP_MAP_BUMP]);
    material->texels = texels_per_unit(obj, made, material->diffuse_map);
    if (!made->has_diffuse && material->diffuse_map != NULL)
        material->diffuse = 0xffffff;           /* a map alone keeps its colours */
}

/* Warns of each material without a definition, but only if all libraries were read: a
 * library not read may define the material. */
static void warn_undefined_materials(tp_obj *obj)
{
    const tp_obj_names *const names = &obj->store.material_names;
    if (obj->libraries == 0 || obj->libraries_read < obj->libraries)
        return;
    for (uint32_t i = 0; i < names->count; i++) {
        const char *const name = tp_names_text(names, i);
        if (obj->store.made[i].defined || name[0] == '\0')
            continue;
        const uint32_t end = i + 1 < names->count ? names->start[i + 1] : names->used;
        tp_error fault;
        TP_FAIL(&fault, TP_E_MTL_NAME, names->line[i], 0, 0);
        tp_error_set_word(&fault, name, end - names->start[i] - 1);
        tp_obj_warn(obj, &fault);
    }
}

tp_status tp_obj_finish(tp_obj *obj, const tp_texture *const *textures, tp_mesh *mesh,
                        tp_error *err)
{
    if (obj->stage != TP_STAGE_LOADED)
        return tp_obj_latch_failure(obj, TP_FAIL(err, TP_E_ARG, 0, 0, 0));
    obj->warnings = 0;
    warn_undefined_materials(obj);
    const tp_obj_memory *const store = &obj->store;
    for (uint32_t i = 0; i < store->material_names.count; i++)
        bind_material(obj, textures, i);
    *mesh = (tp_mesh){
        .vertices = &store->vertices[0].out, .n_vertices = store->n_vertices,
        .faces = store->faces,               .n_faces = store->n_faces,
        .materials = store->materials,       .n_materials = store->material_names.count,
        .low = obj->low,                     .high = obj->high,
        .log2_unit = obj->log2_unit };
    return TP_OK;
}

size_t tp_obj_finished_mesh_bytes(const tp_obj *obj)
{
    const tp_obj_memory *const store = &obj->store;
    const size_t before = (size_t)((const char *)store->vertices
                                   - (const char *)store->materials);
    return before + store->n_vertices * sizeof *store->vertices;
}
