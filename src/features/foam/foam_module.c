/* SPDX-License-Identifier: MIT */
/* The foam field: its window, its fading, its drift.
 *
 * A cell is visited every eighth tick.  The visit keeps e^(-8 ticks / fade) of the cover
 * and adds the foam made since.  The sum, in 2^-24 of a unit, is rounded by a threshold.
 * The threshold cycles through 0..1 in steps of the golden ratio, with another phase in
 * each cell.  The mean therefore fades exactly, however slowly, and always ends at 0.
 *
 * Drift moves the lattice and leaves the cells' bytes alone, so no cover spreads or is
 * lost at any speed.  Interpolation in place would smear a byte over its neighbours.
 *
 * Cells left behind by the window are cleared when they are reused for other places. */
#include "base/base.h"
#include "features/foam/foam_visit.h"
#include "waves/softfloat.h"
#include "world/module.h"
#include "world/pools.h"
#include "world/world.h"

#define MIDDLE_MOST (8000 * TP_FX_ONE)  /* limit of the eye and of pools, m */

/* -- the window ---------------------------------------------------------------------- */

static size_t cover_bytes(uint32_t cells)
{
    return ((size_t)cells * cells + 7) & ~(size_t)7;
}

bool tp_foam_enabled(const tp_module_conditions *conditions)
{
    return conditions->scene->foam.cells > 0;
}

/* Returns the size of the state.  With coastal water a row of displaced positions follows
 * the cover, and over a map of the floor the sums of open water. */
static size_t bytes(const tp_module_conditions *conditions)
{
    const uint32_t cells = (uint32_t)conditions->scene->foam.cells;
    const bool coastal = (conditions->above & TP_MODULE_COASTAL) != 0;
    const bool mapped = coastal && conditions->assets && conditions->assets->floor;

    return sizeof(tp_foam) + cover_bytes(cells) + (coastal ? cells * sizeof(tp_vec3) : 0)
           + (mapped ? sizeof(tp_foam_open) : 0);
}

/* Returns the window's side, Q32 m: below 2^46. */
static int64_t window_side_q32(const tp_foam *foam)
{
    return (int64_t)foam->cells * foam->cell * 65536;
}

/* Returns the lowest lattice cell of a window around `middle`, m.  The drift is within
 * 0..side. */
static int32_t first_window_cell(const tp_foam *foam, tp_fx middle, int64_t drift_q32)
{
    TP_ASSERT(foam->cells > 0 && foam->cell > 0);
    int64_t from = (int64_t)middle - (drift_q32 >> 16), cell = foam->cell;
    int64_t at = from / cell - (from % cell < 0);

    return (int32_t)at - (int32_t)(foam->cells / 2);
}

static void centre_window_on_pool_or_eye(tp_foam *foam, const tp_world *world,
                                         const tp_scene *scene)
{
    bool  pool = tp_world_pool(world) != NULL;
    tp_vec3 eye = tp_camera_interpolate(world, 0).eye;
    tp_fx x = pool ? scene->pool.x : eye.x;
    tp_fx z = pool ? scene->pool.z : eye.z;

    foam->first_x = first_window_cell(foam, x, foam->drift_x);
    foam->first_z = first_window_cell(foam, z, foam->drift_z);
}

/* Refuses scenes whose sources of foam the program lacks. */
static tp_status check(const tp_module_conditions *conditions, tp_error *err)
{
    const tp_scene *scene = conditions->scene;
    const tp_wave_models *by = conditions->water;
    const bool coast = conditions->above & TP_MODULE_COASTAL
                       || (tp_has_floor(scene) && scene->pool.cols == 0);
    const char *lacking =
        !by                                       ? NULL
        : coast && !by->foam_coast                ? "foam_coast"
        : scene->pool.cols > 0 && !by->foam_walls ? "foam_walls"
        : scene->boat.mesh[0] && scene->foam.hull > 0 && !by->foam_hull ? "foam_hull"
        : scene->foam.slices > 1 && !by->foam_slices ? "foam_slices"
        : scene->drops.count > 0 && !by->foam_splashes ? "foam_splashes" : NULL;

    return lacking ? tp_program_fail_lacking(lacking, err) : TP_OK;
}

static tp_status init(void *mine, tp_world *world, const tp_module_conditions *conditions,
                      tp_error *err)
{
    const tp_scene *scene = conditions->scene;
    const uint32_t cells = (uint32_t)scene->foam.cells;
    tp_foam *foam = mine;

    TP_ASSERT(cells > 0 && cells <= 256);
    (void)err;
    foam->cells = cells;
    foam->cell = scene->foam.cell;
    foam->slices = (uint32_t)scene->foam.slices;
    foam->scratch = conditions->above & TP_MODULE_COASTAL
               ? (uint32_t)(sizeof *foam + cover_bytes(cells)) : 0;
    centre_window_on_pool_or_eye(foam, world, scene);
    for (int q = 0; q < TP_FOAM_TICKS; q++) {
        foam->seen[q][0] = foam->first_x;
        foam->seen[q][1] = foam->first_z;
    }
    return TP_OK;
}

/* Returns the drift after one tick.  A drift by a full side maps the torus onto
 * itself, so the drift is reduced by the side and the cell numbers in `seen` are
 * shifted instead. */
static int64_t advance_drift(tp_foam *foam, int64_t drift, tp_fx speed, int axis)
{
    int64_t side = window_side_q32(foam),
            step = (int64_t)speed * 65536 / TP_TICKS_PER_SECOND;
    int32_t turns = 0;

    for (drift += step % side; drift >= side; drift -= side)
        turns++;
    for (; drift < 0; drift += side)
        turns--;
    for (int q = 0; q < TP_FOAM_TICKS; q++)
        foam->seen[q][axis] += turns * (int32_t)foam->cells;
    return drift;
}

static tp_lattice_axis make_axis(int32_t first, uint32_t cells)
{
    return (tp_lattice_axis){ first, tp_foam_mod(first, cells), cells };
}

/* -- visits -------------------------------------------------------------------------- */

uint32_t tp_foam_kept_share(tp_fx fade_seconds)
{
    TP_ASSERT(fade_seconds > 0);
    uint64_t x =
        ((uint64_t)TP_FOAM_TICKS << 40) / (TP_TICKS_PER_SECOND * (uint32_t)fade_seconds);
    return tp_exp_neg((uint32_t)x) >> 8;
}

static void set_previous_row_points(tp_foam_visit *v, const tp_foam *foam)
{
    for (uint32_t i = 0; i < foam->cells; i++) {
        const int32_t number = tp_lattice_cell_number(&v->x, i);
        v->make.by->foam_coast->sample_previous_row(
            &v->make, i, tp_foam_cell_centre(foam, number, foam->drift_x));
    }
}

/* Returns the sum of the row's new cover. */
static uint32_t visit_row(tp_foam_visit *v, tp_foam *foam, uint8_t *cover)
{
    int32_t last = INT32_MIN;
    uint32_t sum = 0;

    for (uint32_t i = 0; i < foam->cells; i++) {
        int32_t number = tp_lattice_cell_number(&v->x, i);
        tp_fx   x = tp_foam_cell_centre(foam, number, foam->drift_x);
        uint32_t gain = tp_foam_maker_gain(&v->make, i, x, number - 1 == last);
        bool    same = number == tp_lattice_cell_number(&v->seen_x, i);
        last = number;
        const uint32_t before = same ? cover[i] : 0;
        cover[i] = gain == TP_FOAM_DRY || (gain | before) == 0
                 ? 0 : tp_foam_next_cover(before, v, i, gain);
        sum += cover[i];
    }
    return sum;
}

static void visit_slice(tp_foam_visit *v, tp_foam *foam)
{
    uint32_t q = foam->visits % TP_FOAM_TICKS, cells = foam->cells;
    uint32_t end = (q + 1) * cells / TP_FOAM_TICKS;
    uint32_t sum = 0;
    int32_t  last = INT32_MIN;

    v->x = make_axis(foam->first_x, cells);
    v->z = make_axis(foam->first_z, cells);
    const tp_lattice_axis seen_x = make_axis(foam->seen[q][0], cells);
    v->seen_x = v->map ? v->x : seen_x;     /* no cell counts as new once they are filled */
    v->seen_z = make_axis(foam->seen[q][1], cells);
    v->low_x = tp_foam_cell_centre(foam, foam->first_x, foam->drift_x);
    for (uint32_t j = q * cells / TP_FOAM_TICKS; j < end; j++) {
        int32_t  number = tp_lattice_cell_number(&v->z, j);
        uint8_t *cover = tp_foam_cover(foam) + (size_t)j * cells;
        if (number != tp_lattice_cell_number(&v->seen_z, j))
            memset(cover, 0, cells);
        v->threshold_q24 =
            foam->visits / TP_FOAM_TICKS * TP_FOAM_GOLDEN + j * (TP_FOAM_GOLDEN / 7);
        v->make.z = tp_foam_cell_centre(foam, number, foam->drift_z);
        if (foam->scratch && v->slices == 1 && number - 1 != last)
            set_previous_row_points(v, foam);
        last = number;
        if (v->map)
            v->make.by->foam_coast->fill_entering_cells(
                v, foam, cover, &seen_x, number != tp_lattice_cell_number(&v->seen_z, j));
        sum += v->slices > 1 ? v->make.by->foam_slices->visit_row(v, foam, cover, number)
                             : visit_row(v, foam, cover);
        if (v->map && j % 2 == 0)
            v->make.by->foam_coast->count_open_water(v, foam, cover);
    }
    foam->sum[q] = sum;
    foam->seen[q][0] = foam->first_x;
    foam->seen[q][1] = foam->first_z;
}

/* True if the slice of this tick has no cover. */
static bool is_slice_empty(tp_foam *foam)
{
    const uint32_t q = foam->visits % TP_FOAM_TICKS, cells = foam->cells;
    const uint32_t first = q * cells / TP_FOAM_TICKS, end = (q + 1) * cells / TP_FOAM_TICKS;

    return foam->sum[q] == 0
        && tp_foam_is_empty(tp_foam_cover(foam) + (size_t)first * cells,
                            (size_t)(end - first) * cells);
}

/* Passes over the slice of this tick, which stays without cover. */
static void leave_slice(tp_foam *foam)
{
    const uint32_t q = foam->visits % TP_FOAM_TICKS;

    foam->sum[q] = 0;
    foam->seen[q][0] = foam->first_x;
    foam->seen[q][1] = foam->first_z;
}

/* Advances the foam by one tick, after all other modules have moved. */
static void step_foam(tp_foam *foam, const tp_wave_models *by, const tp_world *world,
                      const tp_scene *scene)
{
    tp_foam_visit v;

    v.kept_q24 = tp_foam_kept_share(scene->foam.fade);
    v.map = by->foam_coast ? tp_foam_map(world) : NULL;
    v.slices = by->foam_slices ? foam->slices : 1;

    foam->drift_x = advance_drift(foam, foam->drift_x, scene->foam.map.drift_x, 0);
    foam->drift_z = advance_drift(foam, foam->drift_z, scene->foam.map.drift_z, 1);
    centre_window_on_pool_or_eye(foam, world, scene);
    tp_foam_maker_begin(&v.make, foam, by, world, scene);
    v.sparse.ready = false;
    v.sparse.waves = tp_foam_maker_has_waves(&v.make);
    v.sparse.sources = v.sparse.waves || v.make.pool;
    if (v.sparse.sources || v.make.has_hull || v.map || !is_slice_empty(foam))
        visit_slice(&v, foam);
    else
        leave_slice(foam);
    foam->visits++;
}

/* -- validation of a state from outside ---------------------------------------------- */

static bool is_window_valid(const tp_foam *foam, int32_t first, int64_t cells)
{
    const int64_t most = MIDDLE_MOST / foam->cell + cells;
    return first >= -most && first <= most;
}

/* True if the state is in range.  A window starts at most half a side and a drift of less
 * than a side from its middle.  The eight windows in `seen` may lag by one more side per
 * tick. */
static bool is_valid(const void *mine, const void *fresh_state, const tp_world *world)
{
    const tp_foam *foam = mine, *fresh = fresh_state;
    const int64_t cells = fresh->cells, side = window_side_q32(fresh);
    bool valid = foam->cells == fresh->cells && foam->cell == fresh->cell
              && foam->scratch == fresh->scratch && foam->slices == fresh->slices
              && foam->drift_x >= 0 && foam->drift_x < side
              && foam->drift_z >= 0 && foam->drift_z < side
              && is_window_valid(fresh, foam->first_x, 2 * cells)
              && is_window_valid(fresh, foam->first_z, 2 * cells);

    for (int q = 0; q < TP_FOAM_TICKS; q++)
        valid = valid && is_window_valid(fresh, foam->seen[q][0], 10 * cells)
             && is_window_valid(fresh, foam->seen[q][1], 10 * cells);
    if (!valid || !tp_foam_map(world))
        return valid;
    const tp_foam_open *open = tp_foam_open_water(foam);
    return open->count < TP_FOAM_OPEN_COUNT && open->sum <= 4 * open->count;
}

/* -- the module ---------------------------------------------------------------------- */

/* True if the state matches the scene.  A change of the cells' number or size loses the
 * cover; foam in other slices is another world. */
static bool fits(const void *mine, const tp_scene *scene)
{
    const tp_foam *foam = mine;
    return foam->cells == (uint32_t)scene->foam.cells && foam->cell == scene->foam.cell
        && foam->slices == (uint32_t)scene->foam.slices;
}

static void step(void *mine, const tp_program *program, tp_world *world,
                 const tp_scene *scene, const tp_input *input)
{
    (void)input;
    step_foam(mine, &program->water, world, scene);
}

static bool handle_impact(void *mine, const tp_program *program,
                          const tp_scene *scene, const tp_impact *impact, tp_fx level)
{
    const struct tp_water_foam_splashes *splashes = program->water.foam_splashes;

    (void)scene, (void)level;
    if (splashes)
        splashes->add(mine, impact->x, impact->z, impact->length / 5, 160);
    return false;
}

const tp_module tp_foam_module = {
    .name = "foam", .id = TP_FOAM_ID,
    .trait = TP_TRAIT_foam, .enabled = tp_foam_enabled,
    .check = check, .bytes = bytes, .init = init, .fits = fits, .step = step,
    .hit = handle_impact, .is_valid = is_valid,
};
