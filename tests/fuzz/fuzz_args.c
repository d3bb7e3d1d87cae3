/* SPDX-License-Identifier: MIT */
/* Fuzzes command lines: the first byte selects the command, then each line is a word.
 * Accepted options are within their ranges; errors name the command. */
#include "fuzz.h"
#include "app/cli/args.h"

enum { COMMANDS = 13, WORDS = 24 };

static bool is_in(uint32_t number, uint32_t low, uint32_t high)
{
    return number >= low && number <= high;
}

static void require_ranges(const options *o, int words)
{
    REQUIRE(is_in(o->width, 16, 4096) && is_in(o->height, 16, 4096));
    REQUIRE(o->first <= o->last && o->last <= 999999999);
    REQUIRE(o->band <= 4096 && o->strip <= 4096 && o->strip % 16 == 0);
    REQUIRE(o->threads <= 64 && o->texels <= 4096 && o->jobs <= 1024);
    REQUIRE(o->format < TP_FORMAT_COUNT && o->work >= -1);
    REQUIRE(o->points == 0 || is_in(o->points, 2, 1024));
    REQUIRE(o->scale <= 16 && (o->ui == 0 || is_in(o->ui, 50, 400)));
    REQUIRE(o->memory <= (uint64_t)UINT32_MAX << 20);
    REQUIRE(o->n_settings + o->n_names < (uint32_t)words);
}

/* Each stored word is one of the given words, or a part of one. */
static void require_words(const options *o, char *const *words, int count)
{
    for (uint32_t i = 0; i < o->n_settings + o->n_names; i++) {
        const char *kept = i < o->n_settings ? o->settings[i]
                                             : o->names[i - o->n_settings];
        bool found = false;
        for (int k = 1; k < count; k++)
            found = found || (kept >= words[k] && kept <= words[k] + strlen(words[k]));
        REQUIRE(found);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const unsigned command = fuzz_byte(&data, &size);
    char *text = fuzz_text(data, size), *words[WORDS + 1] = { "fuzz" };
    int count = 1;
    for (char *line = text; line && count < WORDS; count++) {
        words[count] = line;
        line = fuzz_line(line);
    }
    options o;
    const int code = args_read(&o, 1u << (command % COMMANDS), count, words);
    REQUIRE(code == EXIT_DONE || code == EXIT_USAGE);
    if (code) {
        fuzz_refused("tidepool fuzz", 0);
    } else {
        require_ranges(&o, count);
        require_words(&o, words, count);
    }
    free(o.settings);
    free(text);
    return 0;
}
