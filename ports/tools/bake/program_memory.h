/* SPDX-License-Identifier: MIT */
/* The RAM and flash of a baked program on a Cortex-M4, without the port's own code, before
 * anything is linked.
 *
 * Code, constants and stack are those of the program's list, by tables that
 * tests/budgets/code-sizes.sh measures with the linker and the compiler's call graph.  The
 * frame is laid out here; a third table has the bytes that a part takes less where pointers
 * have 32 bits.  The scene's tables are those that bake writes. */
#ifndef TP_TOOLS_BAKE_PROGRAM_MEMORY_H
#define TP_TOOLS_BAKE_PROGRAM_MEMORY_H
#include "app/cli/args.h"
#include "bake.h"
#include "bake_program.h"

/* Bytes by use.  RAM: `frame` is the frame's block without vertices, tables and mirror
 * (frame/tools.h); `tile` is the scratch of one tile, with its pixels. */
#define PROGRAM_RAM_LIST(X) \
    X(frame) X(vertices) X(tables) X(mirror) X(tile) X(world) X(stack)
#define PROGRAM_FLASH_LIST(X) X(code) X(constants) X(scene) X(pictures)

typedef struct program_memory {
#define X(use) size_t use;
    PROGRAM_RAM_LIST(X)
    PROGRAM_FLASH_LIST(X)
#undef X
} program_memory;

/* Each returns a sum. */
size_t program_memory_ram(const program_memory *m);
size_t program_memory_flash(const program_memory *m);

/* Sets the bytes of a program that was found, with the assets and pictures of its file.
 * Returns an exit code, and prints the reason of a failure. */
int program_memory_measure(program_memory *m, const bake_program *program, const bake *b,
                           const tp_assets *names);

/* The same for a scene whose rungs are named: finds the program that bake would write for o's
 * size, format, tiles and --stream, for a board without a user, from pictures of at most 320
 * columns.  worlds: for many searches, those of an earlier search, kept for later ones; the
 * caller closes worlds->run.  Pictures then have at most 96 columns, in which a list may lack a
 * piece: 2 % of the code in one of 17 scenes.  NULL: one search. */
int program_memory_find(program_memory *m, const tp_scene *scene, const tp_assets *names,
                        const options *o, component_search_worlds *worlds);

/* Prints a table: the uses and their bytes, RAM, then flash.  Each line begins with `before`. */
void program_memory_print(const program_memory *m, FILE *out, const char *before);
#endif
