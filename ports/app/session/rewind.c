/* SPDX-License-Identifier: MIT */
/* Rewinding: snapshots of every 16th picture, thinned by age, and the inputs of all
 * pictures since the oldest snapshot.
 *
 * A world is plain data and evolves the same from the same inputs.  A snapshot only
 * shortens the replay: any but the oldest can be dropped if inputs alone led to its world.
 * After a change of the scene inputs do not lead to the world; such a snapshot begins a new
 * sequence and is dropped only when it is the oldest.
 *
 * When the budget is exhausted, the snapshot is dropped whose neighbours are then closest
 * relative to their age.  Gaps grow with age, up to an eighth of the age and at most 128
 * pictures, which replay in a moment.  If no gap can grow, the oldest snapshot is
 * dropped. */
#include "rewind.h"
#include <stdlib.h>
#include <string.h>

#define DENSE    16             /* pictures between snapshots */
#define GAP_MOST 128
#define GAP_AGE  8              /* a gap is at most 1 / GAP_AGE of its age */
#define SCENE_BYTES ((sizeof(tp_scene) + 7) / 8 * 8)

typedef struct {
    uint32_t picture;
    bool     begins;            /* first of a sequence: inputs do not lead here */
    size_t   bytes;             /* size of the world */
    char    *block;             /* the scene, then the world */
} rewind_frame;

struct rewind_history {
    size_t    budget, used;     /* bytes of blocks and inputs: limit, in use */
    rewind_frame *kept;         /* snapshots, in order of pictures */
    size_t    count, room;
    tp_input *input;            /* inputs of the pictures kept[0].picture to end - 1, ... */
    size_t    lead, inputs_room;/* ... from input[lead] on */
    uint32_t  end;
};

/* -- inputs -------------------------------------------------------------------------- */

static size_t count_inputs(const rewind_history *p)
{
    return p->count ? p->end - p->kept[0].picture : 0;
}

/* Makes room for one input, if possible in the room of dropped pictures. */
static bool make_inputs_room(rewind_history *p)
{
    const size_t count = count_inputs(p);
    if (p->lead + count < p->inputs_room)
        return true;
    if (p->lead <= count) {
        const size_t room = p->inputs_room ? 2 * p->inputs_room : 1024;
        tp_input *more = realloc(p->input, room * sizeof *more);
        if (!more)
            return false;
        p->input = more;
        p->inputs_room = room;
    } else {
        memmove(p->input, p->input + p->lead, count * sizeof *p->input);
        p->lead = 0;
    }
    return true;
}

static bool note(rewind_history *p, const tp_input *input)
{
    if (!make_inputs_room(p))
        return false;
    p->input[p->lead + count_inputs(p)] = *input;
    p->used += sizeof *input;
    p->end++;
    return true;
}

const tp_input *rewind_input(const rewind_history *p, uint32_t picture)
{
    if (p->count == 0 || picture < p->kept[0].picture || picture >= p->end)
        return NULL;
    return &p->input[p->lead + (picture - p->kept[0].picture)];
}

/* -- snapshots ----------------------------------------------------------------------- */

static void drop(rewind_history *p, size_t i)
{
    p->used -= SCENE_BYTES + p->kept[i].bytes;
    free(p->kept[i].block);
    p->count--;
    memmove(&p->kept[i], &p->kept[i + 1], (p->count - i) * sizeof *p->kept);
}

void rewind_forget(rewind_history *p)
{
    while (p->count > 0)
        drop(p, p->count - 1);
    p->used = 0;
    p->lead = 0;
    p->end = 0;
}

static void drop_oldest(rewind_history *p)
{
    const uint32_t picture = p->kept[0].picture;
    if (p->count == 1) {
        rewind_forget(p);
        return;
    }
    drop(p, 0);
    const uint32_t gone = p->kept[0].picture - picture;
    p->lead += gone;
    p->used -= gone * sizeof *p->input;
}

/* Returns the snapshot whose removal leaves the smallest gap relative to its age; 0:
 * none. */
static size_t least_missed(const rewind_history *p)
{
    size_t best = 0;
    uint64_t best_gap = 0, best_age = 0;
    for (size_t i = 1; i + 1 < p->count; i++) {
        const rewind_frame *m = &p->kept[i];
        const uint64_t gap = m[1].picture - m[-1].picture, age = p->end - m->picture;
        if (m->begins || gap > GAP_MOST || gap * GAP_AGE > age)
            continue;
        if (best == 0 || gap * best_age < best_gap * age) {
            best = i;
            best_gap = gap;
            best_age = age;
        }
    }
    return best;
}

static bool make_room(rewind_history *p, size_t bytes)
{
    while (bytes > p->budget || p->used > p->budget - bytes) {
        const size_t i = least_missed(p);
        if (p->count == 0)
            return false;
        if (i > 0)
            drop(p, i);
        else
            drop_oldest(p);
    }
    return true;
}

static bool make_list_room(rewind_history *p)
{
    if (p->count < p->room)
        return true;
    const size_t room = p->room ? 2 * p->room : 64;
    rewind_frame *more = realloc(p->kept, room * sizeof *more);
    if (more) {
        p->kept = more;
        p->room = room;
    }
    return more;
}

static bool keep(rewind_history *p, uint32_t picture, const tp_world *world, size_t bytes,
                 const tp_scene *scene, bool begins)
{
    const size_t block_bytes = SCENE_BYTES + bytes;
    if (!make_list_room(p) || !make_room(p, block_bytes + DENSE * sizeof(tp_input)))
        return false;
    char *block = malloc(block_bytes);
    if (!block)
        return false;
    memcpy(block, scene, sizeof *scene);
    memcpy(block + SCENE_BYTES, world, bytes);
    if (p->count == 0)
        p->end = picture;
    p->kept[p->count++] = (rewind_frame){ picture, begins, bytes, block };
    p->used += block_bytes;
    return true;
}

/* -- pictures ------------------------------------------------------------------------ */

/* Drops everything from `picture` on. */
static void cut(rewind_history *p, uint32_t picture)
{
    if (p->count && picture <= p->kept[0].picture) {
        rewind_forget(p);
        return;
    }
    while (p->count && p->kept[p->count - 1].picture >= picture)
        drop(p, p->count - 1);
    if (p->count && picture < p->end) {
        p->used -= (p->end - picture) * sizeof *p->input;
        p->end = picture;
    }
}

void rewind_add(rewind_history *p, uint32_t picture, const tp_world *world, size_t bytes,
                const tp_scene *scene, const tp_input *input, bool changed)
{
    cut(p, picture);
    if (p->count && picture != p->end)
        rewind_forget(p);
    const rewind_frame *last = p->count ? &p->kept[p->count - 1] : NULL;
    const bool begins = changed || !last || last->bytes != bytes;
    if ((begins || picture - last->picture >= DENSE)
        && !keep(p, picture, world, bytes, scene, begins) && begins)
        rewind_forget(p);
    if (p->count && !note(p, input))
        rewind_forget(p);
}

static const rewind_frame *find_latest_moment(const rewind_history *p, uint32_t picture)
{
    size_t n = p->count;
    while (n > 0 && p->kept[n - 1].picture > picture)
        n--;
    return n > 0 ? &p->kept[n - 1] : NULL;
}

bool rewind_take(const rewind_history *p, uint32_t picture, tp_world *world, size_t bytes,
                 tp_scene *scene, uint32_t *from)
{
    const rewind_frame *m = find_latest_moment(p, picture);
    if (!m || m->bytes != bytes)
        return false;
    memcpy(scene, m->block, sizeof *scene);
    memcpy(world, m->block + SCENE_BYTES, bytes);
    *from = m->picture;
    return true;
}

size_t rewind_world_bytes(const rewind_history *p, uint32_t picture)
{
    const rewind_frame *m = find_latest_moment(p, picture);
    return m ? m->bytes : 0;
}

uint32_t rewind_oldest(const rewind_history *p)
{
    return p->count ? p->kept[0].picture : UINT32_MAX;
}

size_t rewind_bytes(const rewind_history *p)
{
    return p->used;
}

rewind_history *rewind_begin(size_t budget)
{
    rewind_history *p = calloc(1, sizeof *p);
    if (p)
        p->budget = budget;
    return p;
}

void rewind_end(rewind_history *p)
{
    if (!p)
        return;
    rewind_forget(p);
    free(p->kept);
    free(p->input);
    free(p);
}
