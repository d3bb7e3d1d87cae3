/* SPDX-License-Identifier: MIT */
/* String views; see the header. */
#include "scene/string_view.h"
#include "base/base.h"
#include "base/text.h"
#include "fx/fx.h"

tp_string_view tp_string_view_trim(tp_string_view piece)
{
    while (piece.bytes > 0 && tp_is_white(*piece.text)) {
        piece.text++;
        piece.bytes--;
    }
    while (piece.bytes > 0 && tp_is_white(piece.text[piece.bytes - 1]))
        piece.bytes--;
    return piece;
}

bool tp_string_view_is(tp_string_view piece, const char *name)
{
    return tp_text_length(name) == piece.bytes
        && memcmp(name, piece.text, piece.bytes) == 0;
}

bool tp_string_view_has_control(tp_string_view piece)
{
    for (size_t i = 0; i < piece.bytes; i++)
        if ((unsigned char)piece.text[i] < 0x20 || piece.text[i] == 0x7f)
            return true;
    return false;
}

tp_status tp_string_view_fx(tp_string_view piece, tp_fx *x)
{
    int beyond = 0;

    if (piece.bytes == 0 || piece.bytes > UINT32_MAX
        || tp_fx_read(piece.text, (uint32_t)piece.bytes, x, &beyond) != piece.bytes)
        return TP_E_NUMBER;
    return beyond ? TP_E_RANGE : TP_OK;
}
