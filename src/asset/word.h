/* SPDX-License-Identifier: MIT */
/* Splits a line of text into words.  Words are separated by blanks.  Every byte up to the
 * space is a blank: tabs, stray control bytes and NULs too. */
#ifndef TP_ASSET_WORD_H
#define TP_ASSET_WORD_H
#include <stdbool.h>
#include <stdint.h>

typedef struct { const char *at, *end; } tp_words;
typedef struct { const char *text; uint32_t bytes; } tp_word;

static inline bool tp_is_blank(char c) { return (unsigned char)c <= ' '; }

/* Skips blanks.  True if the line ends or a comment follows. */
bool tp_words_at_end(tp_words *words);

/* Skips blanks and returns the next word; a word of no bytes at the end. */
tp_word tp_word_next(tp_words *words);

/* Returns the rest of the line without the blanks around it. */
tp_word tp_word_rest(tp_words *words);

bool tp_word_is(tp_word word, const char *name);
bool tp_word_is_any_case(tp_word word, const char *name);   /* name in lower case */
bool tp_word_holds_nul(tp_word word);

/* Reads the next word as a number in 48.16.  Returns false and takes nothing if the word is
 * not a number.  Too large numbers saturate to +-TP_WIDE_MAX. */
bool tp_word_number(tp_words *words, int64_t *x);

/* Reads [+-] digits at the cursor, without skipping blanks; false if there is no number.
 * Saturates at +-INT32_MAX. */
bool tp_word_int(tp_words *words, int32_t *x);
#endif
