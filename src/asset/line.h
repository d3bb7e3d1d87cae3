/* SPDX-License-Identifier: MIT */
/* Logical lines out of bytes that come in pieces of any size.
 *
 * A line ends at LF, CR LF or CR.  One that ends in a backslash goes on in the next, a
 * space instead of the two.  Blank lines and lines that begin with # are passed over.
 *
 * A line of more than TP_OBJ_LINE_BYTES comes in parts.  Parts end at a blank, and where
 * they end depends on the line alone, not on the pieces. */
#ifndef TP_ASSET_LINE_H
#define TP_ASSET_LINE_H
#include "asset/reader.h"
#include "asset/word.h"

void tp_lines_begin(tp_obj_lines *lines);

/* Takes bytes from *at up to `end`.  True: here is a line, or a part of a long one, and
 * lines->first tells where the line began.  lines->continues: the part is not the line's
 * first.  lines->goes_on: it is not the last; lines->split: its last word is longer than a
 * part and was cut.  False: all bytes are taken and more are needed.  The line stays valid
 * until the next call, and may lie in the caller's piece or in lines->text. */
bool tp_lines_next(tp_obj_lines *lines, const char **at, const char *end,
                   tp_words *line);

/* At the end of the file, after tp_lines_next returned false: the line, or the last part,
 * that no line end closed, if there is one. */
bool tp_lines_last(tp_obj_lines *lines, tp_words *line);
#endif
