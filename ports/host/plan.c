/* SPDX-License-Identifier: MIT */
/* tidepool plan: by which rungs a scene is drawn, what each costs, how far it is off, the
 * bytes that it takes, and why the others were not chosen. */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "commands.h"
#include "governing.h"
#include "say.h"

#define BAND 16                 /* rows of a tile, as a board draws */
#define MHZ  168                /* of the estimate, and cycles of an instruction */
#define CPI  "1.3"
#define SPEED (MHZ * 1000000ull * 10 / 13)      /* instructions a second */

static const char *const kinds[TP_KINDS] = { "visibility", "shading", "rate", "lod" };

static const char *const whys[] = {
    [TP_WHY_CHOSEN] = "chosen", [TP_WHY_NAMED] = "as the scene says",
    [TP_WHY_OTHER_NAMED] = "the scene says otherwise", [TP_WHY_ERROR] = "over the budget",
    [TP_WHY_COST] = "no cheaper", [TP_WHY_UNKNOWN] = "has no price yet",
    [TP_WHY_UNFIT] = "not for this scene",
};

typedef struct {
    stage  *stage;
    tp_plan_report report;
    size_t  bytes[TP_KINDS][TP_KIND_RUNGS];     /* frame and scratch, with that rung */
} plan;

static void name_rungs(tp_scene *scene, tp_rungs rungs)
{
    scene->quality.visibility = (int32_t)rungs.visibility;
    scene->quality.shading = (int32_t)rungs.shading;
    scene->quality.rate = (int32_t)rungs.rate;
    scene->quality.lod = (int32_t)rungs.lod;
}

static tp_rungs with(tp_rungs rungs, int kind, int rung)
{
    switch (kind) {
    case 0:  rungs.visibility = (tp_visibility)(rung + 1); break;
    case 1:  rungs.shading = (tp_shading)(rung + 1); break;
    case 2:  rungs.rate = (tp_rate)(rung + 1); break;
    default: rungs.lod = (tp_lod)(rung + 1); break;
    }
    return rungs;
}

static void weigh(plan *p)
{
    const tp_frame_config *config = &p->stage->canvas.config;
    const tp_assets *named = &p->stage->assets.names;
    tp_scene scene = p->stage->file.scene;

    for (int k = 0; k < TP_KINDS; k++)
        for (int i = 0; i < p->report.rung_count[k]; i++) {
            name_rungs(&scene, with(p->report.rungs, k, i));
            p->bytes[k][i] = tp_frame_bytes(&scene, named, config)
                           + tp_frame_scratch_bytes(config);
        }
}

/* To two decimals, which is what prices are good for. */
static const char *fx_text(tp_fx x, char text[24])
{
    const int64_t hundredths = ((int64_t)x * 100 + 0x8000) >> 16;
    snprintf(text, 24, "%" PRId64 ".%02d", hundredths / 100, (int)(hundredths % 100));
    return text;
}

static void word_of(int kind, int rung, char word[32])
{
    const tp_param *row;
    char name[32];

    snprintf(name, sizeof name, "quality.%s", kinds[kind]);
    row = tp_param_find(name, strlen(name));
    tp_param_number_text(row, rung + 1, word, 32);
}

/* -- for programs -------------------------------------------------------------------- */

static void print_csv(const plan *p)
{
    char word[32], px[24], colour[24];
    const tp_plan_report *r = &p->report;

    puts("kind,rung,why,instructions,error_px,error_colour,bytes");
    for (int k = 0; k < TP_KINDS; k++)
        for (int i = 0; i < r->rung_count[k]; i++) {
            const tp_rung_report *rung = &r->rung[k][i];
            word_of(k, i, word);
            printf("%s,%s,%s,", kinds[k], word, whys[rung->why]);
            if (rung->price.known)
                printf("%" PRIu64 ",%s,%s", rung->price.cost,
                       fx_text(rung->price.error_px, px),
                       fx_text(rung->price.error_colour, colour));
            else
                printf(",,");
            printf(",%zu\n", p->bytes[k][i]);
        }
    printf("total,,,%" PRIu64 ",%s,%s,%zu\n", r->total.cost,
           fx_text(r->total.error_px, px), fx_text(r->total.error_colour, colour),
           p->stage->canvas.frame_bytes + p->stage->canvas.scratch_bytes);
}

/* -- for people ---------------------------------------------------------------------- */

static void print_head(const plan *p, const options *o)
{
    const tp_plan_report *r = &p->report;
    const tp_scene *scene = &p->stage->file.scene;
    char px[24], colour[24];

    printf("%s, %ux%u: about %u pixels of water, %u vertices, %u wave%s",
           p->stage->file.name, (unsigned)o->width, (unsigned)o->height,
           (unsigned)r->water_pixels, (unsigned)r->vertices, (unsigned)r->waves,
           r->waves == 1 ? "" : "s");
    if (r->waves_dropped)
        printf(" (%u more too faint)", (unsigned)r->waves_dropped);
    printf("\nbudget: outlines %s px, colours %s of 255 rms\n\n",
           fx_text(scene->quality.error_px, px),
           fx_text(scene->quality.error_colour, colour));
    printf("%-10s  %-9s %8s %6s %6s %9s  %s\n", "", "", "M instr", "px", "colour",
           "bytes", "why");
}

static void print_rung(const plan *p, int kind, int i)
{
    const tp_rung_report *rung = &p->report.rung[kind][i];
    const bool taken = rung->why == TP_WHY_CHOSEN || rung->why == TP_WHY_NAMED;
    char word[32], px[24] = "-", colour[24] = "-", cost[24] = "-";

    word_of(kind, i, word);
    if (rung->price.known) {
        fx_text(rung->price.error_px, px);
        fx_text(rung->price.error_colour, colour);
        snprintf(cost, sizeof cost, "%.2f", (double)rung->price.cost / 1e6);
    }
    printf("%-10s %c%-9s %8s %6s %6s %9zu  %s\n", i ? "" : kinds[kind],
           taken ? '*' : ' ', word, cost, px, colour, p->bytes[kind][i], whys[rung->why]);
}

static void print_total(const plan *p)
{
    const tp_plan_report *r = &p->report;
    const tp_frame_ram ram = tp_frame_memory(p->stage->canvas.frame);
    const double cost = (double)r->total.cost;
    char px[24], colour[24];

    if (r->total.known)
        printf("\nin all: %.2f M instructions a frame, %.0f a water pixel; off %s px,"
               " %s\nestimate: %.1f frames/s at %d MHz if an instruction takes "
               CPI " cycles\n", cost / 1e6, r->water_pixels ? cost / r->water_pixels : 0,
               fx_text(r->total.error_px, px), fx_text(r->total.error_colour, colour),
               r->total.cost ? (double)SPEED / cost : 0, MHZ);
    else
        puts("\nin all: not known, as a rung has no price yet");
    printf("bytes: frame %zu (vertices %zu, tables %zu, mirror %zu),\n  a tile's scratch"
           " %zu, world %zu\n", ram.frame, ram.vertices, ram.tables, ram.mirror,
           ram.scratch, p->stage->world_bytes);
    puts("Instructions are a Cortex-M4's of a frame at the scene's start, without ticks."
         "\nErrors are the most that was measured, beyond the exact rungs' own.");
}

static int run(const options *o)
{
    stage s;
    plan  p = { .stage = &s };
    int code = stage_open(&s, o);

    if (!code) {
        p.report = tp_plan_of(&s.file.scene, &s.assets.names, o->width, o->height);
        weigh(&p);
        if (o->csv)
            print_csv(&p);
        else {
            print_head(&p, o);
            for (int k = 0; k < TP_KINDS; k++)
                for (int i = 0; i < p.report.rung_count[k]; i++)
                    print_rung(&p, k, i);
            print_total(&p);
        }
    }
    stage_close(&s);
    return code;
}

int plan_command(int argc, char **argv)
{
    options o;
    int code = args_read(&o, FOR_PLAN, argc, argv);

    if (!o.band && !o.strip)
        o.band = BAND;
    if (!code && o.help) {
        puts("usage: tidepool plan SCENE [OPTION]...\n"
             "Prints by which methods the scene is drawn: for each what a frame costs a\n"
             "Cortex-M4 with it, how far outlines and colours may be off, and its bytes.\n"
             "Both are measured against the truth, a mesh and pixels many times finer;\n"
             "what counts is how much farther off it a rung is than the exact one.\n"
             "The cheapest within quality.error_px and quality.error_colour are taken;\n"
             "what the scene names (quality.visibility, shading, rate, lod) is taken\n"
             "whatever its error.\n");
        args_print(FOR_PLAN);
    } else if (!code) {
        code = run(&o);
    }
    free(o.settings);
    const int end = finish_stdout();
    return code ? code : end;
}
