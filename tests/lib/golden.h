/* SPDX-License-Identifier: MIT */
/* Golden frames: pictures with every bit fixed.
 *
 * A folder holds, for each pixel format, a list in the form of `tidepool render --hash`,
 * and for each frame of the list the picture, for people and for the difference:
 *     rgb565.crc          frame 0000 crc32 1234abcd
 *     rgb565-0000.png     a picture with that CRC
 * A frame passes only if list and picture exist, agree with each other and equal the
 * frame. */
#ifndef TP_TESTS_LIB_GOLDEN_H
#define TP_TESTS_LIB_GOLDEN_H
#include <stdbool.h>
#include "app/scene/assets.h"
#include "app/files/picture.h"
#include "app/scene/scene_file.h"
#include "tests/lib/golden_sizes.h"

extern const uint32_t golden_frames[GOLDEN_FRAMES];     /* in ticks */

/* A scene to be drawn at any golden tick, in any format and tiling. */
typedef struct {
    scene_file file;
    asset_set  assets;
    tp_world  *world[GOLDEN_FRAMES];    /* snapshots of one run */
} golden_scene;

bool golden_open(golden_scene *g, const char *name);
void golden_close(golden_scene *g);

/* Draws a picture, to be freed by golden_free.  Exits the program on failure. */
picture golden_draw(const golden_scene *g, uint32_t frame_index, tp_format format,
                    uint32_t strip, uint32_t band);
void    golden_free(picture *p);

/* Compares a picture with its reference in `folder`.  If it differs or has no reference,
 * returns false, prints the reason to stdout, and writes NAME-expected.png,
 * NAME-actual.png and NAME-difference.png to `wreck`, as far as they exist. */
bool golden_compare(const char *folder, const char *wreck, const picture *actual,
                    uint32_t frame, const char *name);

/* Makes `actual` the reference, and prints the PSNR between the old and the new
 * reference. */
void golden_write(const char *folder, const picture *actual, uint32_t frame, bool first);
#endif
