/* SPDX-License-Identifier: MIT */
/* The page of all charts, DIR/README.md.  The template is the folder's page.md: a line
 * @NAME stands for a chart, @NAME* for all charts not yet shown with names that begin with
 * NAME.  Other charts follow at the end in order of name.  Charts without a table in DIR
 * are left out. */
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "app/files/log.h"
#include "app/files/output_file.h"
#include "app/files/path.h"
#include "charts.h"

typedef struct {
    const charts *charts;
    const char   *dir;
    FILE         *file;
    bool         *shown;
    bool          blank;        /* the last line was blank: prints no second */
} page;

static bool is_there(const char *folder, const chart *of, const char *suffix)
{
    char *path = chart_path(folder, of, suffix);
    const bool there = path && path_is_file(path);
    free(path);
    return there;
}

static void copy_text(const page *p, const chart *of)
{
    char *path = chart_path(p->charts->folder, of, ".txt");
    FILE *text = path ? fopen(path, "r") : NULL;
    if (!text)
        log_line("chart %s: no text (%s)", of->name, path ? path : "no memory");
    for (int c; text && (c = getc(text)) != EOF;)
        putc(c, p->file);
    if (text)
        fclose(text);
    free(path);
}

static void print_units(const page *p, const chart *of)
{
    for (size_t i = 0; i < of->units.count; i++) {
        const char *unit = of->units.of[i];
        const size_t bytes = strcspn(unit, ":");
        fprintf(p->file, "%s`%.*s` ", i ? ", " : "\n\nColumns: ", (int)bytes, unit);
        for (const char *c = unit + bytes + 1; *c; c++)
            putc(*c == '_' ? ' ' : *c, p->file);
    }
    if (of->units.count)
        putc('.', p->file);
}

static void print_chart(page *p, const chart *of)
{
    p->shown[of - p->charts->of] = true;
    if (!is_there(p->dir, of, ".csv"))
        return;
    fprintf(p->file, "### %s\n\n", of->title);
    if (is_there(p->dir, of, ".png"))
        fprintf(p->file, "![%s](%s.png)\n\n", of->title, of->name);
    copy_text(p, of);
    fprintf(p->file, "\n`tidepool charts DIR --only %s` makes this chart again:"
            " [the table](%s.csv)", of->name, of->name);
    if (is_there(p->dir, of, ".time.csv"))
        fprintf(p->file, ", [times](%s.time.csv)", of->name);
    if (is_there(p->dir, of, ".svg"))
        fprintf(p->file, ", [as SVG](%s.svg)", of->name);
    putc('.', p->file);
    print_units(p, of);
    putc('\n', p->file);
    p->blank = false;
}

static void print_text(page *p, const char *line)
{
    const bool blank = line[0] == '\n';
    if (!blank || !p->blank)
        fputs(line, p->file);
    p->blank = blank;
}

/* Prints the charts with a prefix that were not shown; "" matches every chart. */
static void print_left(page *p, const char *prefix)
{
    for (size_t i = 0; i < p->charts->count; i++) {
        const chart *of = &p->charts->of[i];
        if (p->shown[i] || strncmp(of->name, prefix, strlen(prefix)) != 0)
            continue;
        print_text(p, "\n");
        print_chart(p, of);
    }
}

static void print_line(page *p, char *line)
{
    if (line[0] != '@') {
        print_text(p, line);
        return;
    }
    const size_t bytes = strcspn(line, "*\r\n");
    const bool many = line[bytes] == '*';
    line[bytes] = 0;
    const chart *of = charts_find(p->charts, line + 1);
    if (many)
        print_left(p, line + 1);
    else if (of)
        print_chart(p, of);
}

static void print_page(page *p, FILE *frame)
{
    char line[512];
    while (fgets(line, sizeof line, frame))
        print_line(p, line);
    print_left(p, "");
}

int charts_page(const charts *c, const char *dir)
{
    output_file out = { .file = NULL };
    page p = { .charts = c, .dir = dir, .shown = calloc(c->count, sizeof *p.shown) };
    char *from = path_join(c->folder, "page.md", ""), *to = path_join(dir, "README.md", "");
    FILE *frame = from ? fopen(from, "r") : NULL;
    int code = p.shown && from && to ? EXIT_DONE : log_fail_memory(strlen(dir));
    if (!code && !frame)
        code = log_fail(EXIT_INPUT, "%s: %s", from, strerror(errno));
    if (!code)
        code = output_file_open(&out, to);
    if (!code) {
        p.file = out.file;
        print_page(&p, frame);
        code = output_file_close(&out);
    }
    if (frame)
        fclose(frame);
    free(p.shown);
    free(from);
    free(to);
    return code;
}
