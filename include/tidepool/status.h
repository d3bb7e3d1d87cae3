/* SPDX-License-Identifier: MIT */
/* Errors: a code, a sentence, and the location of the fault.
 *
 * Only init functions, setters and readers can fail.  An error stores the line of the
 * input (`where`) and up to two numbers and a word for its sentence.  The application
 * knows the file's name and prints, for example, "boat.obj:41: face uses vertex 9 of
 * 3". */
#ifndef TP_STATUS_H
#define TP_STATUS_H
#include <stddef.h>
#include <stdint.h>
#include "tidepool/fixed.h"

TP_BEGIN_C

/* Codes and sentences.  In a sentence %a and %b stand for the error's two numbers, %s for
 * its word. */
#define TP_STATUS_LIST(X)                                                                \
    X(OK, "ok")                                                                          \
    X(E_ARG, "argument out of range")                                                    \
    X(E_NOSPACE, "out of memory: %a bytes needed, %b available")                         \
    X(E_NULL, "%s is NULL")                                                              \
    X(E_ALIGN, "%s is not aligned to %a bytes")                                          \
    X(E_SIZE, "picture of %a x %b pixels; 16 x 16 to 4096 x 4096 can be drawn")          \
    X(E_TILE, "tile of %a x %b pixels; the width must be a multiple of 16")              \
    X(E_PROGRAM, "the program lacks %s")                                                 \
    X(E_NAME, "no parameter is called %s")                                               \
    X(E_NUMBER, "expected a number, found %s")                                           \
    X(E_RANGE, "%s is outside its range")                                                \
    X(E_CHOICE, "%s is none of the choices")                                             \
    X(E_COLOUR, "expected a colour such as #204060, found %s")                           \
    X(E_TEXT, "control character in %s")                                                 \
    X(E_LONG, "longer than %a bytes")                                                    \
    X(E_UNENDED, "%s has no terminating zero within %a bytes")                           \
    X(E_TEXTURE, "texture of %a x %b texels; 1 x 1 to 4096 x 4096 can be used")          \
    X(E_OBJ_NUMBER, "expected a number, found %s")                                       \
    X(E_OBJ_MISSING, "%s needs %a numbers, found %b")                                    \
    X(E_OBJ_ZERO, "index 0; indices start at 1")                                         \
    X(E_OBJ_VERTEX, "face uses vertex %a of %b")                                         \
    X(E_OBJ_TEXCOORD, "face uses texture coordinate %a of %b")                           \
    X(E_OBJ_NORMAL, "face uses normal %a of %b")                                         \
    X(E_OBJ_MIXED, "corners of a face in different forms, such as 1 and 1/1")            \
    X(E_OBJ_RANGE, "coordinate beyond +-%a")                                             \
    X(E_OBJ_LINE, "line longer than %a bytes")                                           \
    X(E_OBJ_NAME, "name contains a zero byte")                                           \
    X(E_OBJ_EMPTY, "no face of the file has an area")                                    \
    X(E_OBJ_COUNT, "more than %a elements of one kind")                                  \
    X(E_OBJ_CHANGED, "the file changed between its two readings")                        \
    X(E_OBJ_MATERIALS, "more than %a materials")                                         \
    X(E_MTL_NAME, "material %s is not defined")                                          \
    X(E_MTL_ORDER, "%s before any newmtl")                                               \
    X(E_MTL_RANGE, "%s is outside %a..%b")                                               \
    X(E_MTL_IMAGES, "names of pictures exceed %a bytes in total")                        \
    X(E_POOL_SIZE, "%s: pool of %a x %b cells; 16 x 16 to 512 x 512 can be "             \
                   "computed")                                                           \
    X(E_POOL_COURANT, "%s of 0.%a is above 0.%b, the bound of this damping; water "      \
                      "would not come to rest")                                          \
    X(E_POOL_INTERVAL, "%s: a step in %a ticks takes a courant up to 0.%b with this "        \
                       "damping")                                                        \
    X(E_POOL_DAMPING, "%s: a step in %a ticks takes a damping of %b or more")             \
    X(E_POOL_RANGE, "%s is outside the range of pools")                                  \
    X(E_POOL_FEED, "%s is above drive_max")                                              \
    X(E_POOL_MASK, "%s has no samples: %a x %b")                                         \
    X(E_WORLD, "the world's %s does not match its scene")                                \
    X(E_TAPE_HEAD, "expected \"tape 2 SCENE\", found %s")                                \
    X(E_TAPE_VERSION, "a tape of format %s; this version draws other pictures and replays " \
                      "format 2 only")                                                   \
    X(E_TAPE_TICK, "expected a tick, found %s")                                          \
    X(E_TAPE_VALUE, "expected NAME=NUMBER, found %s")                                    \
    X(E_TAPE_NAME, "no input is called %s")                                              \
    X(E_TAPE_TWICE, "%s occurs twice in the line")

typedef enum {
#define X(name, text) TP_##name,
    TP_STATUS_LIST(X)
#undef X
    TP_STATUS_COUNT
} tp_status;

typedef struct {
    tp_status   code;
    const char *file;       /* __FILE__ and __LINE__ of the check that failed */
    int         line;
    uint32_t    where;      /* line of the input, from 1; 0: no line */
    int32_t     a, b;       /* numbers of the sentence */
    char        word[48];   /* the offending word of the input, cut to fit; for a pool the
                             * field of its config, for a scene the parameter */
} tp_error;

/* Writes the whole sentence of `err`, without location and file name, to `text`, always
 * terminated and cut to `bytes`.  Returns the length of the whole sentence. */
size_t tp_error_text(const tp_error *err, char *text, size_t bytes);

TP_END_C
#endif
