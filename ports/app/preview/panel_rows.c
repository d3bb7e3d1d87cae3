/* SPDX-License-Identifier: MIT */
/* Groups, search and texts of the panel's rows.  Rows keep the order of the parameter
 * table, which is written for reading. */
#include "panel_rows.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- groups -------------------------------------------------------------------------- */

static size_t head_bytes(const char *name)
{
    return strcspn(name, ".");
}

uint32_t panel_groups_collect(const panel_host *host, panel_group groups[PANEL_GROUPS])
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < host->rows; i++) {
        const char *const name = host->row[i].name;
        const size_t bytes = head_bytes(name);
        panel_group *const last = n > 0 ? &groups[n - 1] : NULL;
        if (last && strlen(last->name) == bytes && memcmp(last->name, name, bytes) == 0) {
            last->count++;
            continue;
        }
        if (n == PANEL_GROUPS || bytes >= PANEL_NAME)
            break;
        groups[n] = (panel_group){ .first = i, .count = 1 };
        memcpy(groups[n++].name, name, bytes);
    }
    return n;
}

/* True if a group's first value is 0, "none" or empty: the scene does not use the
 * feature. */
static bool is_absent(const panel_host *host, uint32_t row)
{
    char text[PANEL_TEXT];
    const panel_row *const r = &host->row[row];
    host->get(host->user, row, text);
    return r->kind == PANEL_CHOICE ? strcmp(text, "none") == 0
         : r->kind == PANEL_NUMBER || r->kind == PANEL_COUNT ? r->low == 0
             && strcmp(text, "0") == 0
         : (r->kind == PANEL_MESH || r->kind == PANEL_PICTURE) && text[0] == '\0';
}

void panel_group_count(const panel_host *host, panel_group *group, bool fresh)
{
    group->changed = 0;
    for (uint32_t i = 0; i < group->count; i++)
        group->changed += !host->is_normal(host->user, group->first + i);
    if (fresh)
        group->idle = group->changed == 0 && is_absent(host, group->first);
}

/* -- names and search ---------------------------------------------------------------- */

void panel_label(const panel_row *row, uint32_t letters, char text[PANEL_NAME])
{
    const size_t head = head_bytes(row->name);
    const char *name = row->name + head + (row->name[head] == '.');
    size_t n = 0;
    for (; name[n] != '\0' && n < PANEL_NAME - 1u && n < letters; n++)
        text[n] = name[n] == '_' ? ' ' : name[n];
    if (name[n] != '\0' && n > 3)
        text[n - 1] = text[n - 2] = '.';
    text[n] = '\0';
}

/* Maps a character for the search: lower case, and a blank for "_" and ".". */
static char plain(char c)
{
    return c == '_' || c == '.' ? ' ' : c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

static bool holds(const char *text, const char *word, size_t bytes)
{
    for (; *text != '\0'; text++) {
        size_t i = 0;
        while (i < bytes && text[i] != '\0' && plain(text[i]) == plain(word[i]))
            i++;
        if (i == bytes)
            return true;
    }
    return false;
}

panel_find panel_found(const panel_row *row, const char *wanted)
{
    panel_find by = PANEL_BY_NAME;
    for (;;) {
        wanted += strspn(wanted, " ._");
        const size_t bytes = strcspn(wanted, " ._");
        if (bytes == 0)
            return by;
        if (!holds(row->name, wanted, bytes)) {
            if (!holds(row->help, wanted, bytes))
                return PANEL_LOST;
            by = PANEL_BY_HELP;
        }
        wanted += bytes;
    }
}

bool panel_word(const char *list, uint32_t i, char text[PANEL_TEXT])
{
    for (; i > 0; i--) {
        list += strcspn(list, "|");
        if (*list == '\0')
            return false;
        list++;
    }
    snprintf(text, PANEL_TEXT, "%.*s", (int)strcspn(list, "|"), list);
    return true;
}

/* -- values -------------------------------------------------------------------------- */

/* A linear slider is useless for a range from centimetres to many metres: such a range
 * gets a logarithmic slider (fine > 0). */
panel_span panel_span_choose(const panel_row *row, double value)
{
    panel_span s = { row->low, row->high, 0, 1000, row->kind == PANEL_COUNT };
    const double largest = fmax(fabs(s.low), fabs(s.high));
    if (strncmp(row->unit, "degrees", 7) == 0) {
        const double turn = 360 * floor((value + 180) / 360);
        if (s.high - s.low > 720) {
            s.low = fmax(turn - 180, row->low);
            s.high = fmin(turn + 180, row->high);
        }
    } else if (s.low > 0 && s.high >= 100 * s.low) {
        s.fine = s.low / 4;
    } else if (s.low <= 0 && s.high - s.low >= 100) {
        s.fine = largest / 1000;
    }
    if (s.whole && s.high - s.low <= 100)
        s = (panel_span){ s.low, s.high, 0, (int)(s.high - s.low), true };
    return s;
}

/* The slider's scale: linear; or asinh, linear near 0 and logarithmic beyond, for both
 * signs. */
static double way(const panel_span *s, double value)
{
    return s->fine > 0 ? asinh(value / s->fine) : value;
}

int panel_place(const panel_span *s, double value)
{
    const double low = way(s, s->low), high = way(s, s->high);
    const double share = (way(s, value) - low) / (high - low);
    return (int)lround(fmin(fmax(share, 0), 1) * s->steps);
}

static void tell(double value, int decimals, char text[PANEL_TEXT])
{
    snprintf(text, PANEL_TEXT, "%.*f", decimals, value);
    if (strchr(text, '.')) {
        size_t n = strlen(text);
        while (text[n - 1] == '0')
            n--;
        text[text[n - 1] == '.' ? n - 1 : n] = '\0';
    }
    if (strcmp(text, "-0") == 0)
        memcpy(text, "0", 2);
}

/* Writes the shortest decimal number that rounds to the same Q16.16 value. */
static void tell_end(double value, char text[PANEL_TEXT])
{
    int decimals = 0;
    do
        tell(value, decimals++, text);
    while (decimals < 8 && fabs(strtod(text, NULL) - value) > 0.5 / 65536);
}

/* Rounds to 1/500 or finer of the span (linear) or of the value (logarithmic); stays
 * within the range. */
void panel_number(const panel_span *s, int place, char text[PANEL_TEXT])
{
    const double low = way(s, s->low), high = way(s, s->high);
    const double at = low + (high - low) * place / s->steps;
    const double value = s->fine > 0 ? s->fine * sinh(at) : at;
    const double size = s->fine > 0 ? fmax(fabs(value), s->fine) : s->high - s->low;
    const int finest = (int)ceil(2.5 - log10(size));
    tell(value, s->whole || finest < 0 ? 0 : finest > 5 ? 5 : finest, text);
    if (place <= 0 || strtod(text, NULL) < s->low)
        tell_end(s->low, text);
    else if (place >= s->steps || strtod(text, NULL) > s->high)
        tell_end(s->high, text);
}

uint32_t panel_colour(const char *text)
{
    unsigned rgb = 0;
    return strlen(text) == 7 && sscanf(text, "#%6x", &rgb) == 1 ? rgb : 0;
}

void panel_tip(const panel_row *row, char *text, size_t bytes)
{
    const bool number = row->kind == PANEL_NUMBER || row->kind == PANEL_COUNT;
    const bool normal = row->normal && row->normal[0];
    int n = snprintf(text, bytes, "%s\n%s", row->name, row->help);
    if (number && n > 0 && (size_t)n < bytes)
        n += snprintf(text + n, bytes - (size_t)n, "\n%.6g to %.6g%s%s", row->low,
                      row->high, row->unit[0] ? " " : "", row->unit);
    if (normal && n > 0 && (size_t)n < bytes)
        snprintf(text + n, bytes - (size_t)n, "\ndefault %s", row->normal);
}
