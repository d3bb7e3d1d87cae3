/* SPDX-License-Identifier: MIT */
/* The lines of an INI file as a list; new lines are attached to the line before them. */
#define _POSIX_C_SOURCE 200809L
#include "scene_lines.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include "app/files/log.h"
#include "app/files/path.h"

#define WHITE " \t\v\f\r"
#define MARK  "\xef\xbb\xbf"    /* UTF-8 byte order mark, written by some editors */

/* -- reading and writing ------------------------------------------------------------- */

static bool add(scene_lines *l, const char *text, size_t bytes)
{
    const bool ended = bytes > 0 && text[bytes - 1] == '\n';
    const bool dos = ended && bytes > 1 && text[bytes - 2] == '\r';
    scene_line *more = realloc(l->of, (l->count + 1) * sizeof *more);
    if (!more)
        return false;
    l->of = more;
    scene_line *line = &l->of[l->count];
    *line = (scene_line){ .row = LINE_NONE, .end = dos ? "\r\n" : ended ? "\n" : "" };
    line->text = path_copy(text, bytes - strlen(line->end));
    if (!line->text)
        return false;
    const char *begin = line->text;
    if (l->count++ == 0 && strncmp(begin, MARK, 3) == 0)
        begin += 3;
    line->head = begin[strspn(begin, WHITE)] == '[';
    return true;
}

int scene_lines_read(scene_lines *l, const char *path)
{
    FILE *file = fopen(path, "rb");
    char *text = NULL;
    size_t room = 0;
    bool memory = true;
    if (!file)
        return log_fail(EXIT_INPUT, "%s: %s", path, strerror(errno));
    errno = 0;
    for (ssize_t n; memory && (n = getline(&text, &room, file)) > 0;)
        memory = add(l, text, (size_t)n);
    const int error = feof(file) ? 0 : errno;   /* getline may have run out of memory */
    fclose(file);
    free(text);
    if (!memory)
        return log_fail_memory(room);
    return error ? log_fail(EXIT_INPUT, "%s: %s", path, strerror(error)) : EXIT_DONE;
}

void scene_lines_free(scene_lines *l)
{
    for (size_t i = 0; i < l->count; i++) {
        free(l->of[i].text);
        free(l->of[i].more);
    }
    free(l->of);
    free(l->tail);
    *l = (scene_lines){ 0 };
}

static const char *end_of_lines(const scene_lines *l)
{
    return l->count && l->of[0].end[0] ? l->of[0].end : "\n";
}

void scene_lines_write(const scene_lines *l, FILE *to)
{
    for (size_t i = 0; i < l->count; i++) {
        const scene_line *line = &l->of[i];
        if (!line->gone)
            fprintf(to, "%s%s", line->text, line->end);
        if (!line->gone && !line->end[0] && (line->more || l->tail))
            fputs(end_of_lines(l), to);
        if (line->more)
            fputs(line->more, to);
    }
    if (l->tail)
        fputs(l->tail, to);
}

/* -- one line ------------------------------------------------------------------------ */

void scene_lines_value(scene_lines *l, uint32_t line, long row, size_t value_bytes)
{
    if (line > l->count)
        return;                         /* another program is writing the file */
    l->of[line - 1].row = row;
    l->of[line - 1].value_bytes = value_bytes;
}

/* Finds the value, [*begin, *end); blanks and a comment may follow. */
static void find_value(const scene_line *line, size_t *begin, size_t *end)
{
    const char *text = line->text;
    size_t at = strcspn(text, "=:");
    at += text[at] != 0;
    if (line->value_bytes || text[at + strspn(text + at, WHITE)] != ';')
        at += strspn(text + at, WHITE);
    else
        at += text[at] == ' ';          /* as in "name = ; comment" */
    *begin = at;
    *end = at + line->value_bytes;
}

/* Returns the comment of a line, or NULL. */
static const char *find_comment(const scene_line *line)
{
    size_t begin, end;
    find_value(line, &begin, &end);
    const char *rest = line->text + end;
    rest += strspn(rest, WHITE);
    return *rest == ';' ? rest : NULL;
}

/* Returns the concatenation of the texts; the caller frees the result. */
static char *chain(const char *const *texts, size_t count)
{
    size_t room = 1;
    for (size_t i = 0; i < count; i++)
        room += strlen(texts[i]);
    char *all = malloc(room), *at = all;
    for (size_t i = 0; all && i < count; i++)
        at = stpcpy(at, texts[i]);
    return all;
}

bool scene_lines_replace(scene_lines *l, uint32_t line, const char *value, size_t most)
{
    if (line > l->count)
        return true;
    scene_line *of = &l->of[line - 1];
    size_t begin, end;
    find_value(of, &begin, &end);
    const char *comment = find_comment(of), *rest = of->text + end;
    const char *gap = comment && comment == rest ? " " : "";
    const bool tight = begin > 0 && begin == end && of->text[begin - 1] != ' ';
    char *head = path_copy(of->text, begin);
    const char *const one[] = { head, tight ? " " : "", value, gap, rest };
    const char *const two[] = { comment, of->end[0] ? of->end : end_of_lines(l), head,
                                tight ? " " : "", value };
    char *text = head ? chain(one, 5) : NULL;
    if (text && comment && strlen(text) + 1 > most) {
        free(text);
        text = chain(two, 5);
    }
    free(head);
    if (!text)
        return false;
    free(of->text);
    of->text = text;
    return true;
}

/* Returns the offset of `name` in a line that sets it, maybe with its section before a dot;
 * -1: the line sets something else. */
static long find_name(const char *text, const char *name)
{
    const size_t bytes = strlen(name), sign = strcspn(text, "=:");
    size_t begin = strncmp(text, MARK, 3) == 0 ? 3 : 0, end = sign;
    begin += strspn(text + begin, WHITE);
    while (end > begin && strchr(WHITE, text[end - 1]))
        end--;
    if (!text[sign] || end - begin < bytes
        || strncmp(text + end - bytes, name, bytes) != 0)
        return -1;
    const bool whole = end - begin == bytes || text[end - bytes - 1] == '.';
    return whole ? (long)(end - bytes) : -1;
}

bool scene_lines_rename(scene_lines *l, uint32_t line, const char *old, const char *now)
{
    if (line == 0 || line > l->count)
        return false;
    scene_line *of = &l->of[line - 1];
    const long at = find_name(of->text, old);
    if (at < 0)
        return false;
    char *head = path_copy(of->text, (size_t)at);
    const char *const parts[] = { head, now, of->text + at + strlen(old) };
    char *text = head ? chain(parts, 3) : NULL;
    free(head);
    if (!text)
        return false;
    free(of->text);
    of->text = text;
    return true;
}

/* -- removing ------------------------------------------------------------------------ */

static bool is_blank(const scene_line *line)
{
    return line->text[strspn(line->text, WHITE)] == 0;
}

/* Removes a section with nothing left but its head. */
static void remove_empty(scene_lines *l, size_t head)
{
    size_t end = head + 1;
    for (; end < l->count && !l->of[end].head; end++)
        if ((!l->of[end].gone && !is_blank(&l->of[end])) || l->of[end].more)
            return;
    for (size_t i = head; i < end; i++)
        l->of[i].gone = true;
}

void scene_lines_remove(scene_lines *l, long row)
{
    size_t head = l->count;
    for (size_t i = 0; i < l->count; i++) {
        scene_line *line = &l->of[i];
        head = line->head ? i : head;
        if (line->row != row)
            continue;
        const char *comment = find_comment(line);
        line->gone = !comment;
        line->row = LINE_NONE;
        if (comment)
            memmove(line->text, comment, strlen(comment) + 1);
        if (head < l->count && !l->of[head].more)
            remove_empty(l, head);
    }
}

/* -- adding -------------------------------------------------------------------------- */

static bool grow(char **text, const char *const *more, size_t count)
{
    char *added = chain(more, count);
    const char *const both[] = { *text ? *text : "", added };
    char *all = added ? chain(both, 2) : NULL;
    free(added);
    if (!all)
        return false;
    free(*text);
    *text = all;
    return true;
}

/* True if a head is "[section]". */
static bool heads(const scene_line *line, const char *section, size_t bytes)
{
    const char *name = strchr(line->text, '[') + 1;
    return strncmp(name, section, bytes) == 0 && name[bytes] == ']';
}

/* Returns the last line of a section: the last line with a setting, or the head.  Returns
 * count if there is no such section. */
static size_t end_of_section(const scene_lines *l, const char *section, size_t bytes)
{
    size_t at = l->count;
    bool in = false;
    for (size_t i = 0; i < l->count; i++) {
        const scene_line *line = &l->of[i];
        if (line->head)
            in = !line->gone && heads(line, section, bytes);
        if (in && (line->head || line->row != LINE_NONE || line->gone))
            at = i;
    }
    return at;
}

static bool add_section(scene_lines *l, const char *section, const char *line)
{
    const char *end = end_of_lines(l);
    size_t last = l->count;
    while (last > 0 && l->of[last - 1].gone)
        last--;
    const bool bare = !l->tail && (last == 0 || is_blank(&l->of[last - 1]));
    const char *const texts[] = { bare ? "" : end, "[", section, "]", end, line };
    return grow(&l->tail, texts, 6);
}

/* True if the tail ends in the section.  New sections are in the tail; the rows of a
 * section come one after another, so only the last section can grow. */
static bool ends_tail(const scene_lines *l, const char *section)
{
    const char *at = NULL;
    for (const char *c = l->tail; c && (c = strchr(c, '[')) != NULL; c++)
        if (c == l->tail || c[-1] == '\n')
            at = c;
    const size_t bytes = strlen(section);
    return at && strncmp(at + 1, section, bytes) == 0 && at[1 + bytes] == ']';
}

bool scene_lines_append(scene_lines *l, const char *name, const char *value)
{
    const char *dot = strchr(name, '.');
    const size_t bytes = (size_t)(dot - name), at = end_of_section(l, name, bytes);
    const char *const texts[] = { dot + 1, " = ", value, end_of_lines(l) };
    char *section = path_copy(name, bytes), *line = chain(texts, 4);
    bool done = section && line;
    if (done) {
        const char *const one[] = { line };
        done = at < l->count          ? grow(&l->of[at].more, one, 1)
             : ends_tail(l, section) ? grow(&l->tail, one, 1)
                                     : add_section(l, section, line);
    }
    free(section);
    free(line);
    return done;
}
