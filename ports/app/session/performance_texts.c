/* SPDX-License-Identifier: MIT */
/* Makes texts for the instruments: lines with columns separated by tabs. */
#include "performance_texts.h"
#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include "app/files/log.h"
#include "frame/tools.h"
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
    kept->sheet = plan_sheet_make(s);
}

static bool is_governed(const frame_governor *g)
{
    return g && g->governor.limit > 0 && g->governor.ladder.count > 1;
}

/* Adds "visibility, *rows, 1.34 M, 1.20 MB, chosen"; the star marks the rung drawn now. */
static void add_rung(performance_sheet *to, const plan_sheet *p, int kind, int i, int drawn)
{
    const tp_rung_report *rung = &p->report.rung[kind][i];
    const bool stepped = i == drawn && i != plan_rung(p->report.rungs, kind);
    char word[32], cost[32] = "";

    plan_word(kind, i, word);
    if (rung->price.known)
        snprintf(cost, sizeof cost, "%.2f M, ", (double)rung->price.cost / 1e6);
    add(to, "%s%s\t%s%s\t%s%.2f MB, %s", to->length ? "\n" : "", i ? "" : plan_kind[kind],
        i == drawn ? "*" : "", word, cost, (double)p->bytes[kind][i] / 1e6,
        stepped ? "to hold frame_ms" : plan_why[rung->why]);
}

static void add_total(performance_sheet *to, const tp_plan_report *r)
{
    char px[24], colour[24];

    if (r->total.known)
        add(to, "\nin all\t%.2f M\tinstructions of a Cortex-M4",
            (double)r->total.cost / 1e6);
    add(to, "\noff\t%s px\tand %s of 255 rms", plan_number(r->total.error_px, px),
        plan_number(r->total.error_colour, colour));
}

static void tell_plan(performance *f, const plan_sheet *p, tp_rungs drawn)
{
    performance_sheet to = { .length = 0 };

    for (int k = 0; k < TP_KINDS; k++)
        for (int i = 0; i < p->report.rung_count[k]; i++)
            add_rung(&to, p, k, i, plan_rung(drawn, k));
    add_total(&to, &p->report);
    performance_set_text(f, PERFORMANCE_PLAN, to.text);
}

void performance_describe_scene(performance *f, performance_plan *kept,
                                const loaded_scene *s, const frame_governor *g)
{
    follow(kept, s);
    performance_set_limit(f, is_governed(g) ? (float)g->governor.limit / 1000
                                            : 1000.0f / 60);
    tell_memory(f, s);
    tell_plan(f, &kept->sheet, is_governed(g) ? tp_governor_rungs(&g->governor)
                                              : kept->sheet.report.rungs);
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
