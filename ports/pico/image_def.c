/* SPDX-License-Identifier: MIT */
/* Image definition of the RP2350: the boot ROM starts a flash image with this block in its
 * first 4 KB.  It sets VTOR to the start of the image and takes stack and entry from the
 * vectors there (RP2350 data sheet, 5.9.5.1). */
#include <stdint.h>

extern const uint32_t image_def[5];
__attribute__((section(".image_def"), used)) const uint32_t image_def[5] = {
    0xffffded3,                 /* block begins */
    0x10210142,                 /* a program, secure, Arm, RP2350; one word */
    0x000001ff,                 /* last item, of one word before it */
    0,                          /* no other block */
    0xab123579,                 /* block ends */
};
