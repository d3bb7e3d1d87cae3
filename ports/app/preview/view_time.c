/* SPDX-License-Identifier: MIT */
/* Time: ticks of 1/60 s follow the clock, independent of the display's rate.
 *
 * A frame is one call of tp_world_advance_clock: 0 ticks in slow motion, or 1, or
 * several.  The frame's first tick takes the collected input.  Before each frame the
 * world goes to `history`, to be replayed on rewinding; the input goes to the tape.  A tape
 * counts the ticks of all worlds since its beginning: base + world->tick. */
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "interact/input_merge.h"
#include "view.h"
#include "world/world.h"

#define TICKS_AT_ONCE 8         /* if more are due, the water slows down */
#define SECOND_US     1000000u

static tp_world *current_world(view *v)
{
    return v->loaded->world;
}

static uint64_t current_tick(view *v)
{
    return v->base + current_world(v)->tick;
}

/* -- one frame ----------------------------------------------------------------------- */

/* Applies the tape's scene changes and camera moves recorded at the current tick. */
static void play_acts(view *v)
{
    bool opened = false;
    const tape_file *tape = &v->replay.tape;
    if (tape->at < tape->count && tape->entries[tape->at].kind == TAPE_FILE_SET)
        compare_forget(v->compare);
    if (replay_acts(&v->replay, v->loaded, v->options, &opened) != EXIT_DONE)
        view_untape(v);
    if (opened)
        view_refit(v, true);
}

static void step_world(view *v, const tp_input *input)
{
    if (v->playing)
        play_acts(v);
    if (v->playing)
        input = replay_step(&v->replay);
    else
        tape_file_add_input(&v->tape, current_tick(v), input);
    tp_world_step(&tp_program_all, current_world(v), &v->loaded->file.scene, input);
}

/* True if the next frame has a tick.  Advances the clock of a copy of the world's head. */
static bool has_tick(const tp_world *world)
{
    tp_world head = *world;
    return tp_world_advance_clock(&head) > 0;
}

/* One frame.  Slow motion has frames without a tick: the input then waits for the next
 * tick, and so does the path of a stir, since its strength is divided among its points
 * per tick. */
void view_step(view *v)
{
    static const tp_input nothing;
    if (v->playing)
        v->pokes = (poke_queue){ 0 };           /* a tape has pokes of its own */
    else if (has_tick(current_world(v)))
        poke_take(&v->pokes, &v->loaded->file.scene, &v->next_input);
    if (v->playing && tape_file_has_ended(&v->replay.tape, v->replay.tick)) {
        view_untape(v);
        view_say(v, "the tape has ended: keys work again");
    }
    if (v->playing)
        play_acts(v);
    else
        rewind_add(v->history, v->picture, current_world(v), v->loaded->world_bytes,
                   &v->loaded->file.scene, &v->next_input, v->changed);
    v->changed = false;
    v->tape.picture = ++v->picture;
    for (uint32_t ticks = tp_world_advance_clock(current_world(v)); ticks > 0; ticks--) {
        step_world(v, &v->next_input);
        v->next_input = nothing;
    }
    v->stale = true;
}

/* Restores the world of the previous frame: takes the latest snapshot before the frame
 * and replays the inputs since.  A tp_frame holds a plan made for its scene, so a
 * changed scene needs a new frame renderer. */
void view_back(view *v)
{
    loaded_scene *s = v->loaded;
    const tp_scene before = s->file.scene;
    uint32_t from;
    if (v->playing) {
        view_say(v, "a tape cannot play backwards");
        return;
    }
    if (v->picture == 0
        || !rewind_take(v->history, v->picture - 1, s->world, s->world_bytes,
                        &s->file.scene, &from)) {
        view_say(v, v->picture == 0 ? "this is the beginning"
                                    : "no older pictures are stored");
        return;
    }
    for (; from < v->picture - 1; from++) {
        const tp_input *input = rewind_input(v->history, from);
        for (uint32_t ticks = tp_world_advance_clock(s->world); ticks > 0; ticks--) {
            tp_world_step(&tp_program_all, s->world, &s->file.scene, input);
            input = NULL;
        }
    }
    v->tape.picture = --v->picture;
    v->changed = true;
    tape_file_cut(&v->tape, v->picture);
    if (v->taping)                      /* the lines of recorded edits may be gone */
        undo_edits_forget_worlds(&v->edits);
    v->next_input = (tp_input){ 0 };
    v->pokes = (poke_queue){ 0 };
    const bool other = memcmp(&before, &s->file.scene, sizeof before) != 0;
    if (other && loaded_scene_open_renderer(s, v->options) != EXIT_DONE)
        v->quit = true;
    view_refit(v, other);
}

/* -- a tick -------------------------------------------------------------------------- */

void view_poke(view *v, const tp_push *push)
{
    if (!poke_add(&v->pokes, push))
        view_say(v, "%d pokes wait, the most: P continues the water", POKE_WAITS);
}

/* Pokes or stirs the water under a pixel of the window. */
static void aim(view *v, const user_input_place *place)
{
    const tp_scene *scene = &v->loaded->file.scene;
    const picture *p = &v->loaded->renderer.picture;
    tp_vec3 at;
    int x, y;
    if (!window_pixel(&v->window, v->scale, place->x, place->y, &x, &y)
        || !tp_world_pick(&tp_program_all, current_world(v), scene, p->width, p->height,
                          tp_pixel_middle(x), tp_pixel_middle(y), &at))
        return;
    const tp_push push = poke_make_push(scene, at.x, at.z);
    if (place->stir)
        poke_stir(&v->pokes, at.x, at.z);
    else if (scene->pool.cols || scene->field.cols)
        view_poke(v, &push);
    else
        view_say(v, "no pool to poke here: Space releases a drop");
}

static void gather_input(view *v, tp_input *input)
{
    *input = user_input_read(&v->control, &v->keys, &v->pad,
                             v->panel && panel_types(v->panel));
    if (v->camera_mode.mode == CAMERA_ORBIT || v->camera_mode.mode == CAMERA_TOP) {
        /* camera_mode_steer gives the whole way to a pose: drop older camera input */
        v->next_input.forward = v->next_input.strafe = v->next_input.up = 0;
        v->next_input.turn = v->next_input.tilt = 0;
    }
    camera_mode_steer(&v->camera_mode, current_world(v), &v->loaded->file.scene, input);
    input_merge(&v->next_input, input);
    for (int i = 0; i < v->control.places; i++)
        aim(v, &v->control.place[i]);
    v->control.places = 0;
}

/* Moves the camera while the water stands still. */
static void look_round(view *v, const tp_input *input)
{
    tape_file_add_look(&v->tape, current_tick(v), input);
    tp_world_move_camera(current_world(v), input);
    v->next_input.forward = v->next_input.strafe = v->next_input.up = 0;
    v->next_input.turn = v->next_input.tilt = 0;
    v->changed = v->stale = true;
}

static void tick(view *v)
{
    const bool back = !(v->panel && panel_types(v->panel))
        && keymap_held(&v->keys, ACT_REWIND, SDL_GetKeyboardState(NULL),
                       SDL_GetModState());
    tp_input input = { 0 };
    if (v->camera_mode.jump && !v->playing) { /* at once: no frame on the way */
        camera_mode_steer(&v->camera_mode, current_world(v), &v->loaded->file.scene,
                          &input);
        look_round(v, &input);
    }
    gather_input(v, &input);
    if (back)
        view_back(v);
    else if (!v->paused)
        view_step(v);
    else if (input_moves_camera(&input) && !v->playing)
        look_round(v, &input);
}

/* Makes the ticks due.  While filming each tick becomes a frame of the film, so time
 * waits for the drawing. */
void view_advance(view *v, uint64_t now)
{
    const int most = v->film ? 1 : TICKS_AT_ONCE;
    v->owed += (now - v->clock) * TP_TICKS_PER_SECOND;
    v->clock = now;
    if (v->control.hidden)
        v->owed = 0;
    if (v->options->counted)            /* --frames: as fast as possible */
        v->owed = SECOND_US;
    for (int i = 0; i < most && v->owed >= SECOND_US; i++, v->owed -= SECOND_US)
        tick(v);
    v->owed %= SECOND_US;
}

/* -- the beginning, and tapes -------------------------------------------------------- */

void view_restart(view *v)
{
    if (loaded_scene_make_world(v->loaded) != EXIT_DONE)
        return;
    if (v->taping || v->playing) {
        view_untape(v);
        view_say(v, "the tape has ended");
    }
    v->picture = 0;
    v->base = 0;
    v->next_input = (tp_input){ 0 };
    v->pokes = (poke_queue){ 0 };
    rewind_forget(v->history);
    v->camera_mode =
        (camera_mode){ .mode = v->camera_mode.mode == CAMERA_BOAT ? CAMERA_BOAT
                                                                  : CAMERA_FREE };
    view_refit(v, false);
}

int view_play(view *v, const char *name)
{
    options wanted = *v->options;
    wanted.tape = name;
    const int code = replay_open(&v->replay, v->loaded, &wanted, REPLAY_ALL);
    v->playing = !code;
    rewind_forget(v->history);
    return code;
}

int view_tape(view *v, const char *name)
{
    const int code = tape_file_record(&v->tape, name, v->loaded->file.name);
    v->taping = !code;
    v->tape.picture = v->picture;
    undo_edits_forget_worlds(&v->edits);     /* earlier edits have no lines on this tape */
    return code;
}

int view_untape(view *v)
{
    const int code = tape_file_close(&v->tape);
    replay_close(&v->replay);
    v->taping = v->playing = false;
    return code;
}
