/* SPDX-License-Identifier: MIT */
/* Settings of a picture as words of a chart's job; shared by the programs that count and
 * the programs that compare.
 *
 *     NAME=VALUE      a parameter of the scene
 *     grid=N          N vertices of a fan
 *     grid/N          one line of N along each axis */
#ifndef TP_TESTS_CHARTS_WORDS_H
#define TP_TESTS_CHARTS_WORDS_H
#include "world/text.h"
#include "world/pools.h"

/* Number of characters up to a blank, `end` or the end of the text. */
static inline size_t word_until(const char *text, char end)
{
    size_t n = 0;

    while (text[n] && text[n] != ' ' && text[n] != end)
        n++;
    return n;
}

static inline uint32_t word_number(const char *text)
{
    uint32_t n = 0;

    for (; *text >= '0' && *text <= '9'; text++)
        n = n * 10 + (uint32_t)(*text - '0');
    return n;
}

static inline bool word_begins(const char *word, const char *with)
{
    while (*with && *word == *with)
        word++, with++;
    return !*with;
}

/* Takes one vertex of `by` along each axis. */
static inline void word_thin_grid(tp_scene *scene, int32_t by)
{
    scene->grid.vertices = (int32_t)tp_fan_budget(scene) / (by * by);
}

/* Applies one word. Returns false if the word is not understood. *still becomes false if
 * the world depends on the setting. */
static inline bool word_set(tp_scene *scene, const char *word, size_t bytes, bool *still)
{
    const size_t name = word_until(word, '=');
    const tp_param *param = name < bytes ? tp_param_find(word, name) : NULL;

    if (word_begins(word, "grid=")) {
        scene->grid.vertices = (int32_t)word_number(word + 5);
        return true;
    }
    if (word_begins(word, "grid/") && word_number(word + 5) > 0) {
        word_thin_grid(scene, (int32_t)word_number(word + 5));
        return true;
    }
    *still = word_begins(word, "quality.") || word_begins(word, "grid.");
    return param && !tp_param_set(scene, param, word + name + 1, bytes - name - 1, NULL);
}

/* Applies all words of a text. */
static inline bool words_set(tp_scene *scene, const char *text)
{
    bool still = true, done = true;

    while (*text && done) {
        const size_t bytes = word_until(text, ' ');
        done = bytes == 0 || word_set(scene, text, bytes, &still);
        text += bytes + (text[bytes] == ' ');
    }
    return done;
}
#endif
