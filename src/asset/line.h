/* SPDX-License-Identifier: MIT */
/* Logical lines out of bytes that come in pieces of any size.
 *
 * A line ends at LF, CR LF or CR.  One that ends in a backslash goes on in the next, a
 * space instead of the two.  Blank lines and lines that begin with # are passed over. */
#ifndef TP_ASSET_LINE_H
#define TP_ASSET_LINE_H
#include "tidepool/asset.h"
#include "asset/word.h"

void tp_lines_begin(tp_obj_lines *lines);

/* Takes bytes from *at up to `end`.  True: here is a line, and lines->first tells where
 * it began; lines->used > TP_OBJ_LINE_BYTES: it is too long and incomplete.  False: all
 * bytes are taken and more are needed.  The line stays valid until the next call, and
 * may lie in the caller's piece or in lines->text. */
bool tp_lines_next(tp_obj_lines *lines, const char **at, const char *end,
                   tp_words *line);

/* At the end of the file: the line that no line end closed, if there is one. */
bool tp_lines_last(tp_obj_lines *lines, tp_words *line);
#endif
