/* SPDX-License-Identifier: MIT */
/* A line of text taken word by word.  Words are divided by blanks, and every byte up to
 * the space is a blank: tabs, stray control bytes and NULs alike. */
#ifndef TP_ASSET_WORD_H
#define TP_ASSET_WORD_H
#include <stdbool.h>
#include <stdint.h>

typedef struct { const char *at, *end; } tp_words;
typedef struct { const char *text; uint32_t bytes; } tp_word;

static inline bool tp_is_blank(char c) { return (unsigned char)c <= ' '; }

/* Skips blanks; true if nothing or a comment follows. */
bool tp_words_end(tp_words *words);

/* The next word, skipping blanks; of no bytes at the end. */
tp_word tp_word_next(tp_words *words);

/* All that follows, without the blanks around it. */
tp_word tp_word_rest(tp_words *words);

bool tp_word_is(tp_word word, const char *name);
bool tp_word_is_any_case(tp_word word, const char *name);   /* name in lower case */
bool tp_word_holds_nul(tp_word word);

/* The next word as a number in 48.16; false and nothing taken if it is none.  Too large
 * ones saturate to +-TP_WIDE_MAX. */
bool tp_word_number(tp_words *words, int64_t *x);

/* [+-] digits at the cursor, without blanks before; false if there is none.  Saturates
 * at +-INT32_MAX. */
bool tp_word_int(tp_words *words, int32_t *x);
#endif
