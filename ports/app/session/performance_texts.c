/* SPDX-License-Identifier: MIT */
/* Makes texts for the instruments: lines with columns separated by tabs. */
#include "performance_texts.h"
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "app/files/log.h"
#include "frame/tools.h"
#include "interact/plan_text.h"
#include "world/world.h"

/* A text that grows; text beyond its size is cut off. */
typedef struct {
    char   text[2048];
    size_t length;
} performance_sheet;

static void add(performance_sheet *to, const char *format, ...) LOG_PRINTF(2, 3);

static void add(performance_sheet *to, const char *format, ...)
{
    const size_t room = sizeof to->text - to->length;
    va_list args;

    va_start(args, format);
    const int bytes = vsnprintf(to->text + to->length, room, format, args);
    va_end(args);
    if (bytes > 0)
        to->length += (size_t)bytes < room ? (size_t)bytes : room - 1;
}

/* -- memory -------------------------------------------------------------------------- */

/* Adds a line with a number as "11,953,600". */
static void add_bytes(performance_sheet *to, const char *use, size_t bytes)
{
    char digits[24];
    const int n = snprintf(digits, sizeof digits, "%zu", bytes);

    add(to, "%s%s\t", to->length ? "\n" : "", use);
    for (int i = 0; i < n; i++)
        add(to, i && (n - i) % 3 == 0 ? ",%c" : "%c", digits[i]);
}

static void tell_memory(performance *f, const loaded_scene *s)
{
    const frame_renderer *c = &s->renderer;
    const tp_ram_use ram = tp_frame_ram(c->frame);
    const size_t picture_bytes = c->picture.row_bytes * c->picture.height;
    performance_sheet to = { .length = 0 };

    add_bytes(&to, "frame", ram.frame);
    add_bytes(&to, "- vertices", ram.vertices);
    add_bytes(&to, "- tables", ram.tables);
    add_bytes(&to, "- mirror", ram.mirror);
    add_bytes(&to, c->threads > 1 ? "scratches" : "scratch", c->scratch_bytes);
    add_bytes(&to, "picture", picture_bytes);
    add_bytes(&to, "world", s->world_bytes);
    add_bytes(&to, "meshes", s->assets.mesh_bytes);
    add_bytes(&to, "textures", s->assets.texture_bytes);
    add_bytes(&to, "in all", ram.frame + c->scratch_bytes + picture_bytes + s->world_bytes
                             + s->assets.mesh_bytes + s->assets.texture_bytes);
    performance_set_text(f, PERFORMANCE_RAM, to.text);
}

/* -- the plan ------------------------------------------------------------------------ */

static void follow(performance_plan *kept, const loaded_scene *s)
{
    const tp_config *config = &s->renderer.config;

    if (kept->made && kept->width == config->width && kept->height == config->height
        && memcmp(&kept->scene, &s->file.scene, sizeof kept->scene) == 0)
        return;
    kept->made = true;
    kept->width = config->width;
    kept->height = config->height;
    memcpy(&kept->scene, &s->file.scene, sizeof kept->scene);
    plan_sheet_make(&kept->sheet, s);
}

/* Adds "4, 12.31 M, off 3.12, light=fast"; the star marks the step drawn now. */
static void add_step(performance_sheet *to, const plan_sheet *p, const tp_scene *scene,
                     uint32_t i, uint32_t drawn)
{
    char price[64], rows[640];
    plan_text cost = { price, sizeof price, 0 }, changes = { rows, sizeof rows, 0 };

    plan_text_add_price(&cost, p->walk.price[i]);
    plan_text_add(&changes, i ? "" : "the plan");
    if (i > 0)
        plan_text_add_changes(&changes, scene, &p->walk.set[i - 1], &p->walk.set[i], false);
    add(to, "%s%s%u\t%s\t%s", to->length ? "\n" : "", i == drawn ? "*" : "", (unsigned)i,
        price, rows);
}

/* Adds what the scene's board does with the plan's picture. */
static void add_board(performance_sheet *to, const plan_sheet *p, const board_frame *frame)
{
    const board_frame second = { frame->board, 1000000, frame->tick };
    const double cost = (double)p->plan.price.cost;

    if (frame->board)
        add(to, "\n%s\t%.1f pictures/s\t%s", frame->board->name,
            cost > 0 ? (double)board_frame_budget(&second) / cost : 0,
            p->real_time ? "in time" : "too slow");
}

static void tell_plan(performance *f, const performance_plan *kept, const loaded_scene *s,
                      uint32_t drawn)
{
    performance_sheet to = { .length = 0 };

    for (uint32_t i = 0; i < kept->sheet.walk.count; i++)
        add_step(&to, &kept->sheet, &s->file.scene, i, drawn);
    add_board(&to, &kept->sheet, &s->frame);
    performance_set_text(f, PERFORMANCE_PLAN, to.text);
}

void performance_describe_scene(performance *f, performance_plan *kept,
                                const loaded_scene *s, const frame_governor *g)
{
    const bool governed = g && frame_governor_is_active(g);

    follow(kept, s);
    performance_set_limit(f, governed ? (float)g->governor.limit / 1000 : 1000.0f / 60);
    tell_memory(f, s);
    tell_plan(f, kept, s, governed ? g->governor.at : 0);
}

/* -- the world ----------------------------------------------------------------------- */

static double metres(tp_fx x)
{
    return x / 65536.0;
}

static double degrees(tp_turn turn)
{
    return (int32_t)turn * (360 / 4294967296.0);
}

void performance_describe_world(performance *f, const loaded_scene *s, const char *more)
{
    const tp_world *w = s->world;
    const tp_vec3 eye = tp_world_camera(w).eye;
    performance_sheet to = { .length = 0 };

    add(&to,
        "tick %" PRIu64 ", clock %.3g, camera at %.1f %.1f %.1f m, heading %.0f,"
        " pitch %.0f%s",
        w->tick, metres(tp_clock_scale(&w->clock)), metres(eye.x), metres(eye.y),
        metres(eye.z), degrees(w->heading), degrees(w->pitch),
        w->aboard == TP_ABOARD_DECK ? " of the deck" : "");
    if (*more)
        add(&to, "; %s", more);
    performance_set_text(f, PERFORMANCE_STATE, to.text);
}
