/* SPDX-License-Identifier: MIT */
/* Scenes and their values, by index in the table of parameters. */
#include "base/base.h"
#include "interact/old_names.h"
#include "interact/setting.h"
#include "web.h"
#include "world/text.h"

char web_text[WEB_TEXT_BYTES];
tp_scene web_scene, web_filed;

/* -- text ---------------------------------------------------------------------------- */

EXPORT(char *, words, void)
{
    return web_text;
}

int web_refuse(const tp_error *err)
{
    tp_error_text(err, web_text, sizeof web_text);
    return (int)err->code;
}

static size_t length(const char *text, char end)
{
    size_t n = 0;
    while (text[n] && text[n] != end)
        n++;
    return n;
}

/* -- scenes -------------------------------------------------------------------------- */

/* Returns the text of scene i, with its name in the first line; NULL if there is none. */
EXPORT(const char *, file, uint32_t i)
{
    return i < web_scene_count ? web_scenes[i] : NULL;
}

/* Sets the parameter "section.name" from a line "name=value" of a scene's text. */
static int set_line(const char *section, size_t section_bytes, const char *line,
                    tp_error *err)
{
    char name[64];
    const size_t bytes = length(line, '=');
    size_t n = 0;
    for (size_t i = 0; i < section_bytes && n < sizeof name - 1; i++)
        name[n++] = section[i];
    name[n++] = '.';
    for (size_t i = 0; i < bytes && n < sizeof name; i++)
        name[n++] = line[i];
    const tp_param *param = tp_param_find(name, n);
    if (!param)
        return (int)TP_FAIL(err, TP_E_NAME, 0, 0, 0);
    const char *value = line + bytes + 1;
    return (int)tp_param_set(&web_filed, param, value, length(value, '\n'), err);
}

/* Selects scene i for changes and for build().  Returns 0, or an error with its text in
 * web_text. */
EXPORT(int, choose, uint32_t i)
{
    const char *line = web_file(i), *section = "";
    size_t section_bytes = 0;
    tp_error err = { 0 };
    if (!line) {
        TP_FAIL(&err, TP_E_ARG, 0, 0, 0);
        return web_refuse(&err);
    }
    web_drop();
    tp_scene_level(&web_filed);
    for (line += length(line, '\n'); *line++; line += length(line, '\n')) {
        if (*line == '[') {
            section = line + 1;
            section_bytes = length(section, ']');
        } else if (*line && set_line(section, section_bytes, line, &err)) {
            return web_refuse(&err);
        }
    }
    web_scene = web_filed;
    return 0;
}

/* Returns the kind of the next file to supply, its name in web_text, or WEB_NOTHING. */
EXPORT(int, wanted, void)
{
    if (web_find_assets(&web_scene))
        return WEB_NOTHING;
    web_drop();
    size_t n = 0;
    do
        web_text[n] = web_name[n];
    while (web_name[n++]);
    return web_kind;
}

/* -- values -------------------------------------------------------------------------- */

_Static_assert(sizeof(tp_param) == 9 * 4, "the page reads rows as nine words");

EXPORT(const tp_param *, params, void)
{
    uint32_t count;
    return tp_params(&count);
}

EXPORT(uint32_t, param_count, void)
{
    uint32_t count;
    tp_params(&count);
    return count;
}

/* Returns the index of the row whose name, present or earlier, is in `bytes` bytes of
 * web_text; -1: none. */
EXPORT(int, find, size_t bytes)
{
    const tp_param *param = old_name_param(web_text, bytes);
    return param ? (int)(param - web_params()) : -1;
}

/* Returns a value as text: of the changed scene, or as in its file (filed). */
EXPORT(const char *, value, uint32_t i, bool filed)
{
    tp_param_text(filed ? &web_filed : &web_scene, web_params() + i, web_text,
                  TP_NAME_BYTES);
    return web_text;
}

/* Returns a number of the row as text, such as a bound of its range or its default. */
EXPORT(const char *, number, uint32_t i, int32_t number)
{
    tp_param_number_text(web_params() + i, number, web_text, TP_NAME_BYTES);
    return web_text;
}

/* Sets a value from `bytes` bytes of web_text.  Returns a setting_result; if refused,
 * the reason is in web_text. */
EXPORT(int, put, uint32_t i, size_t bytes)
{
    char given[TP_NAME_BYTES];
    tp_error err = { 0 };
    if (bytes > sizeof given) {
        TP_FAIL(&err, TP_E_LONG, 0, sizeof given - 1, 0);
        web_refuse(&err);
        return SETTING_REFUSED;
    }
    for (size_t n = 0; n < bytes; n++)
        given[n] = web_text[n];
    const tp_param *param = web_params() + i;
    const setting_result result = setting_put(&tp_program_all, &web_scene, web_world(),
                                              &web_assets, param, given, bytes, &err);
    if (result == SETTING_REFUSED)
        web_refuse(&err);
    const bool anew = setting_is_grid(param) || setting_is_wall(param, &web_assets);
    if (result == SETTING_DONE && web_world() && web_changed(anew))
        return SETTING_ANEW;
    return (int)result;
}
