/* SPDX-License-Identifier: MIT */
/* Golden frames: pictures whose every bit is known.
 *
 * A folder holds for each pixel format a list in the form of `tidepool render --hash`,
 * and for each frame of it the picture itself, for people and for the difference:
 *     rgb565.crc          frame 0000 crc32 1234abcd
 *     rgb565-0000.png     whose colours have that CRC
 * A frame is right only if list and picture are there, agree, and are equal to it. */
#ifndef GOLDEN_H
#define GOLDEN_H
#include <stdbool.h>
#include "host/assets.h"
#include "host/picture.h"
#include "host/scene_file.h"
#include "tests/golden/sizes.h"

extern const uint32_t golden_frames[GOLDEN_FRAMES];     /* in ticks */

/* A scene that can be drawn at any tick, in any format and tiling. */
typedef struct {
    scene_file file;
    asset_set  assets;
    tp_world  *world[GOLDEN_FRAMES];    /* snapshots of one run */
} golden_scene;

bool golden_open(golden_scene *g, const char *name);
void golden_close(golden_scene *g);

/* The picture, to be freed by golden_free; exits the program when it cannot be drawn. */
picture golden_draw(const golden_scene *g, uint32_t frame_index, tp_format format,
                    uint32_t strip, uint32_t band);
void    golden_free(picture *p);

/* Compares a picture with its reference in `folder`.  When it differs or has none,
 * returns false, says why on stdout, and leaves what it can of NAME-expected.png,
 * NAME-actual.png and NAME-difference.png in `wreck`. */
bool golden_compare(const char *folder, const char *wreck, const picture *actual,
                    uint32_t frame, const char *name);

/* Makes `actual` the reference, and prints the PSNR between the old one and it. */
void golden_write(const char *folder, const picture *actual, uint32_t frame, bool first);
#endif
