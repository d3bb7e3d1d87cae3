/* SPDX-License-Identifier: MIT */
/* Writes a picture as a PNG file that is complete or absent. */
#include "output_file.h"
#include "picture.h"

int picture_write_png(const picture *p, const char *name)
{
    output_file out;
    const int code = output_file_open(&out, name);
    if (code)
        return code;
    const int error = picture_put_png(p, out.file);
    return error ? output_file_fail(&out, error) : output_file_close(&out);
}
