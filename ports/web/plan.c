/* SPDX-License-Identifier: MIT */
/* The page's plan: by the error budget, or for the board that the scene names; the steps
 * below it, and the governor of quality.frame_ms, which walks them.  The boat's mesh is
 * loaded before the plan and stays. */
#include "interact/boards.h"
#include "interact/plan_text.h"
#include "interact/tick_cost.h"
#include "web.h"

static struct {
    tp_plan     plan;
    tp_set_walk walk;           /* from the plan's set to cheaper ones */
    board_frame frame;          /* of the scene's board */
    bool        real_time;
    tp_governor governor;
    tp_scene    drawn;
} page;

/* Estimates a tick with a world of its own, in memory that is free again afterwards. */
static uint64_t estimate_tick(void)
{
    const uintptr_t mark = web_mark();
    const size_t bytes = tp_world_bytes(&tp_program_all, &web_scene, &web_assets);
    tp_world *world = web_take(bytes < sizeof *world ? sizeof *world : bytes);
    uint64_t tick = 0;

    if (world
        && tp_world_init(&tp_program_all, world, bytes, &web_scene, &web_assets, NULL)
               == TP_OK)
        tick = tick_cost_estimate(world, &web_scene, page.frame.board->priced_as).mean;
    web_restore_mark(mark);
    return tick;
}

static tp_plan find_plan(uint32_t width, uint32_t height)
{
    tp_scene loaded = web_scene;

    if (loaded.quality.mesh == TP_MESH_AUTO)
        loaded.quality.mesh = TP_MESH_FULL;
    if (page.frame.board)
        return board_plan_make(&page.frame, &loaded, &web_assets, width, height,
                               &page.real_time);
    return tp_plan_make(&loaded, &web_assets, width, height);
}

/* Begins the walk and its governor with the plan. */
static void begin_walk(uint32_t width, uint32_t height)
{
    const tp_fx limit = page.frame.board ? 0 : web_scene.quality.frame_ms;
    tp_view_costs view;

    tp_plan_view(&view, &web_scene, &web_assets, width, height);
    if (page.frame.board)
        view.processor = page.frame.board->priced_as;
    tp_set_walk_make(&page.walk, &view, page.plan.set, page.plan.open);
    tp_governor_init(&page.governor, &page.walk, (uint32_t)((int64_t)limit * 1000 >> 16));
}

/* Takes the scene's board; a tick is estimated if `anew`, or if there was no board. */
static void find_board(bool anew)
{
    const board_frame before = page.frame;

    page.frame = board_frame_of_scene(&web_scene);
    if (page.frame.board)
        page.frame.tick = anew || !before.board ? estimate_tick() : before.tick;
}

void web_plan_make(uint32_t width, uint32_t height)
{
    find_board(true);
    page.plan = find_plan(width, height);
    begin_walk(width, height);
}

bool web_plan_renew(uint32_t width, uint32_t height)
{
    const tp_plan before = page.plan;
    const bool stepped = page.governor.at > 0;
    bool same = true;

    find_board(false);
    page.plan = find_plan(width, height);
    begin_walk(width, height);
    for (int k = 0; k < TP_RUNG_KINDS; k++)
        same = same && before.set.of[k] == page.plan.set.of[k];
    return stepped || !same || before.open != page.plan.open;
}

int web_plan_took(uint32_t us)
{
    return tp_governor_add_frame_time(&page.governor, us);
}

const tp_scene *web_plan_drawn(void)
{
    page.drawn = web_scene;
    tp_rung_set_apply_some(&page.drawn, &page.walk.set[page.governor.at], page.plan.open);
    return &page.drawn;
}

/* -- for the page -------------------------------------------------------------------- */

EXPORT(uint32_t, ladder_steps, void)
{
    return page.walk.count;
}

EXPORT(uint32_t, ladder_at, void)
{
    return page.governor.at;
}

/* Returns a step as text: its cost, its error, and what it changes. */
EXPORT(const char *, ladder_text, uint32_t i)
{
    plan_text to = { web_text, 2048, 0 };

    if (i >= page.walk.count)
        return "";
    plan_text_add_price(&to, page.walk.price[i]);
    plan_text_add(&to, ": ");
    if (i > 0)
        plan_text_add_changes(&to, &web_scene, &page.walk.set[i - 1], &page.walk.set[i],
                              false);
    else
        plan_text_add(&to, "the plan");
    return web_text;
}

/* Returns what the scene's board does with the plan's picture; "": no board. */
EXPORT(const char *, board_text, void)
{
    plan_text to = { web_text, 256, 0 };

    web_text[0] = 0;
    if (page.frame.board)
        plan_text_add_board(&to, &page.frame, page.plan.price, page.real_time);
    return web_text;
}
