/* SPDX-License-Identifier: MIT */
/* Pictures: gnuplot on style.gp and NAME.gp, which are told of the tables by variables.
 * They are drawn under another name, .NAME.svg, and are there only when both are whole. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "charts.h"
#include "path.h"
#include "say.h"

static const char *const suffixes[] = { "png", "svg" };

/* A command that grows; text is NULL when there is no memory. */
typedef struct {
    char  *text;
    size_t bytes;
} command;

static void put(command *c, const char *text)
{
    const size_t bytes = strlen(text);
    char *more = c->text ? realloc(c->text, c->bytes + bytes + 1) : NULL;
    if (!more)
        free(c->text);
    c->text = more;
    if (more)
        memcpy(more + c->bytes, text, bytes + 1);
    c->bytes += bytes;
}

/* As one word of the shell. */
static void put_word(command *c, const char *text)
{
    put(c, "'");
    for (; *text; text++)
        put(c, *text == '\'' ? "'\\''" : (char[]){ *text, 0 });
    put(c, "'");
}

/* NAME='VALUE'; of gnuplot, in which '' is a quote. */
static void put_variable(command *c, const char *name, const char *value)
{
    put(c, name);
    put(c, "='");
    for (; *value; value++)
        put(c, *value == '\'' ? "''" : (char[]){ *value, 0 });
    put(c, "'; ");
}

/* "DIR/.NAME": what is drawn until it is whole. */
static char *hidden_path(const char *dir, const chart *of, const char *suffix)
{
    char *name = path_join("", of->name, suffix);
    if (name)
        name[0] = '.';
    char *path = name ? path_join(dir, name, "") : NULL;
    free(name);
    return path;
}

static void put_picture(command *c, const char *folder, const char *dir, const chart *of,
                        const char *term)
{
    command sets = { .text = calloc(1, 1) };
    char *csv = chart_path(dir, of, ".csv"), *times = chart_path(dir, of, ".time.csv");
    char *out = hidden_path(dir, of, ""), *style = path_join(folder, "style.gp", "");
    char *own = chart_path(folder, of, ".gp");
    if (csv && times && out && style && own) {
        put_variable(&sets, "csv", csv);
        put_variable(&sets, "time_csv", times);
        put_variable(&sets, "out", out);
        put_variable(&sets, "term", term);
    }
    if (sets.text && sets.bytes) {
        put(c, "gnuplot -e ");
        put_word(c, sets.text);
        put(c, " ");
        put_word(c, style);
        put(c, " ");
        put_word(c, own);
    } else {
        free(c->text);
        c->text = NULL;
    }
    free(sets.text);
    free(csv);
    free(times);
    free(out);
    free(style);
    free(own);
}

/* The SVG's points as the PNG's, see svg.awk. */
static void put_points(command *c, const char *folder, const char *dir, const chart *of)
{
    char *awk = path_join(folder, "svg.awk", ""), *svg = hidden_path(dir, of, ".svg");
    char *part = hidden_path(dir, of, ".part");
    if (awk && svg && part) {
        put(c, "awk -f ");
        put_word(c, awk);
        put(c, " ");
        put_word(c, svg);
        put(c, " >");
        put_word(c, part);
        put(c, " && mv ");
        put_word(c, part);
        put(c, " ");
        put_word(c, svg);
    }
    free(awk);
    free(svg);
    free(part);
}

/* gnuplot goes on after some mistakes and says so alone: then there is no picture.  That
 * no row is used by a scene, or all are, is none. */
#define NO_POINTS "Skipping data file with no valid points"

static bool add_picture(chart_jobs *jobs, const charts *c, const chart *of,
                        const char *dir)
{
    command both = { .text = calloc(1, 1) };
    put(&both, "said=$({ ");
    for (int i = 0; i < 2; i++) {
        put_picture(&both, c->folder, dir, of, suffixes[i]);
        put(&both, " && ");
    }
    put_points(&both, c->folder, dir, of);
    put(&both, "; } 2>&1); code=$?; said=$(echo \"$said\" | grep -v '" NO_POINTS "');"
               " [ $code = 0 ] && [ -z \"$said\" ] || { echo \"$said\"; exit 1; }");
    if (!chart_jobs_add(jobs, both.text, NULL))
        return false;
    jobs->of[jobs->count - 1].title = of->title;
    return true;
}

/* The pictures become what they are called, or nothing is left of them. */
static int settle(const chart *of, const char *dir, bool drawn)
{
    static const char *const parts[] = { ".part", ".png", ".svg" };
    int code = EXIT_DONE;
    for (int i = 0; i < 3 && !code; i++) {
        char *from = hidden_path(dir, of, parts[i]), *to = chart_path(dir, of, parts[i]);
        if (!from || !to)
            code = fail_memory(strlen(dir));
        else if (!drawn || i == 0)
            unlink(from);
        else if (rename(from, to) != 0)
            code = fail(EXIT_INPUT, "%s: %s", to, strerror(errno));
        free(from);
        free(to);
    }
    return code;
}

static bool has_gnuplot(void)
{
    return system("command -v gnuplot >/dev/null 2>&1") == 0;
}

int charts_draw(const charts *c, const bool *written, const char *dir, unsigned most)
{
    chart_jobs jobs = { 0 };
    size_t next = 0;
    bool held = true;
    if (!has_gnuplot())
        return fail(EXIT_DONE, "tidepool charts: tables alone; pictures need gnuplot"
                    " (package gnuplot-nox)");
    for (size_t i = 0; i < c->count && held; i++)
        held = !written[i] || add_picture(&jobs, c, &c->of[i], dir);
    int code = held ? chart_jobs_run(&jobs, most, "pictures")
                    : fail_memory(jobs.count * sizeof *jobs.of);
    for (size_t i = 0; i < c->count && next < jobs.count; i++)
        if (written[i]) {
            const int end = settle(&c->of[i], dir, jobs.of[next++].done);
            code = code ? code : end;
        }
    chart_jobs_free(&jobs);
    return code;
}
