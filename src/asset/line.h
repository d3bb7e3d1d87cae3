/* SPDX-License-Identifier: MIT */
/* Builds logical lines from bytes that arrive in pieces of any size.
 *
 * A line ends at LF, CR LF or CR.  A backslash at the end joins the next line; backslash
 * and line end become a space.  Blank lines and lines that begin with # are skipped.
 *
 * A line of more than TP_OBJ_LINE_BYTES arrives in parts.  Parts end at a blank.  Their
 * ends depend on the line alone, not on the pieces. */
#ifndef TP_ASSET_LINE_H
#define TP_ASSET_LINE_H
#include "asset/reader.h"
#include "asset/word.h"

void tp_lines_begin(tp_obj_lines *lines);

/* Takes bytes from *at up to `end`.  Returns true for a line, or a part of a long line;
 * lines->first is the number of its first file line.  lines->continues: the part is not the
 * first part of its line.  lines->goes_on: the part is not the last part.  lines->split:
 * the last word is longer than a part and was cut.  Returns false if all bytes are taken
 * and more are needed.  The line stays valid until the next call, and may lie in the
 * caller's piece or in lines->text. */
bool tp_lines_next(tp_obj_lines *lines, const char **at, const char *end,
                   tp_words *line);

/* Call at the end of the file, after tp_lines_next returned false.  Returns true, with the
 * line or its last part, if the file ends without a line end. */
bool tp_lines_last(tp_obj_lines *lines, tp_words *line);
#endif
