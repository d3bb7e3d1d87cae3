/* SPDX-License-Identifier: MIT */
/* Pictures: gnuplot runs style.gp and NAME.gp; gnuplot variables name the tables.  Pictures
 * are drawn into a private temporary folder and copied when both pictures of a chart are
 * complete: the folder of charts never holds an incomplete picture. */
#define _POSIX_C_SOURCE 200809L
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/files/output_file.h"
#include "app/files/path.h"
#include "charts.h"
#include "charts_hold.h"

static const char *const suffixes[] = { "png", "svg" };

/* A command line that grows.  text is NULL after memory ran out. */
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

/* Adds a text quoted as one word of the shell. */
static void put_word(command *c, const char *text)
{
    put(c, "'");
    for (; *text; text++)
        put(c, *text == '\'' ? "'\\''" : (char[]){ *text, 0 });
    put(c, "'");
}

/* Adds NAME='VALUE'; for gnuplot, where '' stands for a quote. */
static void put_variable(command *c, const char *name, const char *value)
{
    put(c, name);
    put(c, "='");
    for (; *value; value++)
        put(c, *value == '\'' ? "''" : (char[]){ *value, 0 });
    put(c, "'; ");
}

/* The folders of a chart's jobs. */
typedef struct {
    const char *folder;         /* style.gp, NAME.gp, svg.awk */
    const char *dir;            /* tables */
    const char *drawn;          /* pictures */
} places;

static void put_picture(command *c, const places *at, const chart *of, const char *term)
{
    command sets = { .text = calloc(1, 1) };
    char *csv = chart_path(at->dir, of, ".csv");
    char *times = chart_path(at->dir, of, ".time.csv");
    char *out = chart_path(at->drawn, of, ""), *own = chart_path(at->folder, of, ".gp");
    char *style = path_join(at->folder, "style.gp", "");
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

/* Draws the points of the SVG as large and as thick as the PNG's, see svg.awk. */
static void put_points(command *c, const places *at, const chart *of)
{
    char *awk = path_join(at->folder, "svg.awk", "");
    char *svg = chart_path(at->drawn, of, ".svg");
    char *part = chart_path(at->drawn, of, ".part");
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

/* After some errors gnuplot continues, prints a message and exits with 0: any message
 * counts as a failure, except the message below.  The message means that a plot has no
 * points: no row of the table is used by a scene, or every row is. */
#define NO_POINTS "Skipping data file with no valid points"

static bool add_picture(chart_jobs *jobs, const places *at, const chart *of)
{
    command both = { .text = calloc(1, 1) };
    put(&both, "said=$({ ");
    for (int i = 0; i < 2; i++) {
        put_picture(&both, at, of, suffixes[i]);
        put(&both, " && ");
    }
    put_points(&both, at, of);
    put(&both, "; } 2>&1); code=$?; said=$(echo \"$said\" | grep -v '" NO_POINTS "');"
               " [ $code = 0 ] && [ -z \"$said\" ] || { echo \"$said\"; exit 1; }");
    if (!chart_jobs_add(jobs, both.text, NULL))
        return false;
    jobs->of[jobs->count - 1].title = of->title;
    return true;
}

/* -- the temporary folder ------------------------------------------------------------ */

/* Makes a private folder and returns its name, which the caller frees.  Returns NULL after
 * printing the reason. */
static char *make_folder(void)
{
    const char *place = getenv("TMPDIR");
    char *name = path_join(place && *place ? place : "/tmp", "tidepool-XXXXXX", "");
    if (name && mkdtemp(name))
        return name;
    if (name)
        log_line("%s: %s", name, strerror(errno));
    else
        log_fail_memory(sizeof "tidepool-XXXXXX");
    free(name);
    return NULL;
}

/* Removes the folder with all files that drawing may leave there. */
static void remove_folder(char *drawn, const charts *c)
{
    static const char *const parts[] = { ".part", ".png", ".svg" };
    for (size_t i = 0; i < 3 * c->count; i++) {
        char *path = chart_path(drawn, &c->of[i / 3], parts[i % 3]);
        if (path)
            unlink(path);
        free(path);
    }
    rmdir(drawn);
    free(drawn);
}

static int copy_to_file(FILE *from, const char *name, const char *to)
{
    output_file out;
    char bytes[1 << 14];
    size_t n;
    const int code = output_file_open(&out, to);
    if (code)
        return code;
    while ((n = fread(bytes, 1, sizeof bytes, from)) > 0)
        if (fwrite(bytes, 1, n, out.file) != n)
            return output_file_fail(&out, errno);
    if (!ferror(from))
        return output_file_close(&out);
    output_file_discard(&out);
    return log_fail(EXIT_INPUT, "%s: %s", name, strerror(errno));
}

/* Copies the two pictures of a chart to the folder of charts. */
static int settle(const chart *of, const places *at)
{
    int code = EXIT_DONE;
    for (int i = 0; i < 2 && !code; i++) {
        const char *suffix = i ? ".svg" : ".png";
        char *from = chart_path(at->drawn, of, suffix);
        char *to = chart_path(at->dir, of, suffix);
        FILE *file = from && to ? fopen(from, "rb") : NULL;
        if (file)
            code = copy_to_file(file, from, to);
        else
            code = from && to ? log_fail(EXIT_INPUT, "%s: %s", from, strerror(errno))
                              : log_fail_memory(strlen(at->dir));
        if (file)
            fclose(file);
        free(from);
        free(to);
    }
    return code;
}

/* -- all charts ---------------------------------------------------------------------- */

static bool has_gnuplot(void)
{
    return system("command -v gnuplot >/dev/null 2>&1") == 0;
}

static int draw_all(chart_jobs *jobs, const charts *c, const bool *written,
                    const places *at, unsigned most)
{
    size_t next = 0;
    bool held = true;
    for (size_t i = 0; i < c->count && held; i++)
        held = !written[i] || add_picture(jobs, at, &c->of[i]);
    int code = held ? chart_jobs_run(jobs, most, "pictures")
                    : log_fail_memory(jobs->count * sizeof *jobs->of);
    for (size_t i = 0; i < c->count && next < jobs->count; i++)
        if (written[i] && jobs->of[next++].done) {
            const int end = settle(&c->of[i], at);
            code = code ? code : end;
        }
    return code;
}

int charts_draw(const charts *c, const bool *written, const char *dir, unsigned most)
{
    chart_jobs jobs = { 0 };
    chart_hold hold;
    if (!has_gnuplot())
        return log_fail(EXIT_DONE, "tidepool charts: tables only; pictures need gnuplot"
                                   " (package gnuplot-nox)");
    charts_hold(&hold);
    char *drawn = make_folder();
    const places at = { c->folder, dir, drawn };
    const int code = drawn ? draw_all(&jobs, c, written, &at, most) : EXIT_INPUT;
    if (drawn)
        remove_folder(drawn, c);
    charts_release(&hold);
    chart_jobs_stop(&jobs);
    chart_jobs_free(&jobs);
    return code;
}
